// Passes with fewer moves. Steering makes one arc after the other and cannot see what comes next;
// where three to five of its arcs can be one fewer, a program has fewer blocks.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"
#include "strategy/constant_engagement.h"

namespace evenload {

// mm of a pass, from its beginning: what may be replaced.
struct Stretch {
  double from = 0, to = 0;
};

// How what replaces a row is found: as arcs fitted to what the tool meets along it, one fewer; or,
// where more may be met, as the likeliest bi-arc, in half the time.
enum class Rows { kFitted, kQuick };

// `moves` with rows of three to five replaced by two to four tangent arcs, from where the row began
// to where it ended, in the same directions: only within `stretch` mm, inside `centres`, with no
// turn tighter than the pass has off the border, at no more than `overload` rad above `params`'
// engagement angle, and where the time that it costs at a constant removal rate is worth the
// blocks. `ground`: before the moves, and again in the end. Laws: the moves follow each other as
// before, and begin and end where they did; moves along the border of `centres` stay as they are,
// but for short ones, and so does, of a pass that comes back to where it was, all that it comes
// back to.
std::vector<Segment> with_fewer_moves(const std::vector<Segment>& moves, const Stretch& stretch,
                                      const Area& centres, ClearedGround& ground,
                                      const ClearingParams& params, double overload,
                                      Rows rows = Rows::kFitted);

}  // namespace evenload
