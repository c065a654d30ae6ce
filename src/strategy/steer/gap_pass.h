// Passes across gaps: where two walls are too near to each other to steer between them, the tool
// follows one of them, turns about by one arc that touches both, or two, and is at the other.
//
// Free steps would turn there in several arcs of some hundredths of a mm each, which posts write as
// lines. One arc of half a turn they can write down to 8 micrometres; where the gap widens by some
// degrees it would be written in halves, too small for that: either it ends short of the other wall
// by next to nothing, or an arc of less and a wider one lead there, whichever cuts more. Our own.
#pragma once

#include <optional>

#include "cutting/cleared_ground.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"

namespace evenload {

// The pass from `start`, a place on a wall of `centres` where the tool is clear, that gets as far
// into the gap ahead as `engagement` rad allows; its moves are added to the ground. Empty where
// there is no gap, where posts could not write the turn, or next to nothing can be taken.
Pass gap_pass(const Area& centres, const Pose& start, ClearedGround& ground, double engagement);

}  // namespace evenload
