// Passes without turns so tight that a posted program would have corners in their place: arcs of
// some hundredths of a millimetre, which roll-outs in corners leave, give way to a little wider
// ones.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"

namespace evenload {

// mm: by which a pass may come nearer to a turn's centre than planned; no more than `tolerance`.
// What it leaves is no thicker, and too little to come back for: the next pass meets it, on an arc
// that is short beside `engagement` rad.
double most_widening(double engagement, double tool_radius, double tolerance);

// `moves` with each arc that becomes_corners, and others like it beside it, replaced by one arc,
// tangent to the moves before and after, the tightest that stays an arc; or, where none is tangent
// to both, by a bi-arc (wider_bi_arc.h). They are replaced only where what comes instead leaves no
// more than `widening` mm to its right, or 0.0015 mm at the beginning of the moves, cuts no deeper
// than 0.004 mm, stays inside `centres`, and meets no more than `engagement` rad and a tolerance.
// `ground`: before the moves; it is left as it was. Laws: the moves follow each other as before,
// without new corners; they begin and end where they did, in another direction where the last or
// the last but one of them was tight; tight turns along the border of `centres` stay as they are.
std::vector<Segment> without_tight_turns(const std::vector<Segment>& moves, const Area& centres,
                                         ClearedGround& ground, double engagement, double widening);

// A pass as the ground is to know it, and the way to be posted, which leaves what no pass comes
// back for.
struct WidenedPass {
  std::vector<Segment> cut, posted;
};

// `moves` without tight turns, widened by most_widening(). Where that does not do, turns in the
// open are widened by more, as in a notch of the stock's edge: so far from the border of `centres`
// that other passes are likely to follow beyond them, which take what is left, up to a quarter of
// the side step at `engagement` rad and 0.035 mm. Passes that come back to what they leave stay as
// they are there. `walls`: the border of this is followed as it is; elsewhere that of `centres`,
// which are a part of it, may be left inwards. `tolerance`: mm.
WidenedPass with_wide_turns(const std::vector<Segment>& moves, const Area& centres,
                            const Area& walls, ClearedGround& ground, double engagement,
                            double tolerance);

// The same for the sharp corners of regions' borders, inside the regions and however far from the
// corner; tight turns along the border of `exact` stay as they are.
std::vector<Region> without_tight_corners(const std::vector<Region>& regions, const Area& exact);

}  // namespace evenload
