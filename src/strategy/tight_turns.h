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

// Where the tool's centre may be. The border of `walls` is followed as it is; elsewhere that of
// `centres`, which are a part of them, may be left inwards.
struct TurnRoom {
  const Area& centres;
  const Area& walls;
};

// `moves` with each arc that becomes_corners, and others like it beside it, replaced by one arc,
// tangent to the moves before and after, the tightest that stays an arc; or, where none is tangent
// to both, by a bi-arc (wider_bi_arc.h). They are replaced only where what comes instead leaves no
// more than `widening` mm to its right, or 0.0015 mm at the beginning of the moves, cuts no
// deeper than 0.004 mm, stays inside the room, and meets no more than `engagement` rad and a
// tolerance. `ground`: before the moves; it is left as it was. Laws: the moves follow each other as
// before, without new corners; they begin and end where they did, in the same directions; tight
// turns along the border of the walls stay as they are.
std::vector<Segment> without_tight_turns(const std::vector<Segment>& moves, const TurnRoom& room,
                                         ClearedGround& ground, double engagement, double widening);

}  // namespace evenload
