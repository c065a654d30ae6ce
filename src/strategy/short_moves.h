// Passes without tiny moves. Steering leaves remainders of some hundredths of a millimetre before
// its roll-outs and where it cuts back; rounded G-code bends the path at them, and controllers slow
// down for each.
#pragma once

#include <vector>

#include "strategy/area.h"

namespace evenload {

// mm: over which engagement and rate are taken as means; a post's rounding to 0.001 mm turns
// longer moves by less than a degree.
inline constexpr double kShortest = 0.1;
// mm: what posts round to.
inline constexpr double kSmoothing = 1e-3;

// `moves` with each move shorter than kShortest, and the longer neighbour that it is tangent to,
// replaced by one line or arc, or by a bi-arc, from where the two began to where they ended, in the
// same directions, or for pieces that posts turn by as much within a quarter of a degree. They are
// replaced only where what comes instead stays within `smoothing` mm of them, inside `centres`, and
// each of its pieces is as long as kShortest, or four times as long as the shorter of the two, or
// one and a half times along the border where posts write it as an arc (small_arc.h), but not the
// shorter of the two: so there is an end to it.
// Moves of some micrometres, which posts would turn by a degree, also give way to bi-arcs with the
// joint near them, both of whose arcs stay arcs in posted programs.
// A way off the border of `centres` and back to the same line or circle of it is left out where it
// is shorter than kShortest and turns by less than 0.6 degrees all in all.
// Laws: the moves follow each other as before, and end where they ended; other moves along the
// border stay as they are, but for those beside one that posts would turn by a degree, or write as
// lines with corners, which change by less than posts round each time.
// `walls`: the border of this is followed as it is; elsewhere, on that of `centres` alone, whose
// room is a part of it, moves give way like others, and may get out of the room by `smoothing` mm.
std::vector<Segment> without_short_moves(const std::vector<Segment>& moves, const Area& centres,
                                         const Area& walls, double smoothing = kSmoothing);
// The same where all of the border of `centres` are walls.
inline std::vector<Segment> without_short_moves(const std::vector<Segment>& moves,
                                                const Area& centres,
                                                double smoothing = kSmoothing) {
  return without_short_moves(moves, centres, centres, smoothing);
}

}  // namespace evenload
