// A spiral round the middle of the picked faces, seen from above.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "support/progress.h"
#include "surface/beside.h"
#include "surface/ground.h"
#include "surface/polylines.h"

namespace evenload {

// The turns of a spiral of Archimedes whose radius changes by `stepover` mm with each: from as far
// out as the tool may touch the regions down to the middle of their bounds, or the other way. Each
// turn begins where the one before ends.
std::vector<std::vector<Polyline>> spiral_rows(const Ground& ground,
                                               const std::vector<Region>& regions, double stepover,
                                               bool is_outwards, bool is_clockwise);

struct SpiralByCusp {
  std::vector<std::vector<Polyline>> turns;
  double least_stepover = 0, largest_stepover = 0;  // mm, in plan
};

// The same, but each turn lies as far from the one within as StepBeside tells it, place by place.
// Throws Cancelled, and std::invalid_argument for too many turns.
SpiralByCusp spiral_by_cusp(const Ground& ground, const std::vector<Region>& regions,
                            const StepBeside& beside, bool is_outwards, bool is_clockwise,
                            int threads, Progress& progress);

}  // namespace evenload
