// What the tool meets along a finished planar path, looked at anew from the moves alone.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "toolpath/planar.h"

namespace evenload {

struct LoadSample {
  std::size_t run = 0, move = 0;  // where
  double t = 0;                   // parameter on the move, middle of the piece
  double length = 0;              // mm of path that it stands for
  double engagement = 0;          // rad in the leading half circle, mean over the piece
  double width = 0;               // mm: area removed per mm of path, mean over the piece
  double peak_width = 0;          // mm: the largest on the piece
};

// The load along every move of `runs`, in pieces of at most `spacing` mm, shorter where it changes.
// The moves are added to `ground`, which holds what was cleared before; each run's descent is added
// first.
std::vector<LoadSample> load_profile(const std::vector<PlanarRun>& runs, ClearedGround& ground,
                                     double spacing);

// Adds the ground that a helix or ramp clears.
void add_descent(const Descent& descent, ClearedGround& ground);

// rad: the largest mean over `window` mm of path of the engagement of cutting moves.
double worst_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                        double window);

}  // namespace evenload
