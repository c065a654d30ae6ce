// The turns of a Lamé spiral in the ground that they clear: its steps, first planned between closed
// curves, are corrected by the engagement that its arcs really meet.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/lame/lame_pitch.h"
#include "strategy/lame/lame_spiral.h"

namespace evenload {

struct LameTurns {
  LameSpiral spiral;
  std::vector<Segment> moves;
  double engagement = 0;  // rad, the largest that was looked at
  // mm per turn of the larger change of the semi-axes
  double smallest_pitch = 0, largest_pitch = 0;
};

// The spiral through a growth, from the polar angle `start` on, as arcs within `tolerance` mm.
// `ground`: what is cleared before. Law: the engagement at the arcs' ends and middles exceeds the
// limit by no more than load_budget::kSpiral, unless the first curve itself does.
LameTurns turns_of(const PlannedGrowth& planned, const TurnTask& task, double start,
                   double tolerance, const ClearedGround& ground);

}  // namespace evenload
