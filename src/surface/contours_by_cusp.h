// Passes along the outline of the picked faces whose distance follows a cusp height, place by
// place.
//
//  1. The outermost row is half a step within where the tool may touch the faces, and each next one
//     a step further in, as StepBeside tells it for places along the row before: what lies within
//     that of a row is cut from what is left.
//  2. Where a place between two rows is further than half a step from both, in corners, the inner
//     row makes a detour to it; what is left in the middle of the faces, and in necks, has rows of
//     its own, along its outline and its holes.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "support/progress.h"
#include "surface/beside.h"
#include "surface/polylines.h"

namespace evenload {

struct CuspRows {
  std::vector<std::vector<Polyline>> rows;
  double least_stepover = 0, largest_stepover = 0;  // mm, in plan
};

// Rows as contour_rows makes them. Throws Cancelled, and std::invalid_argument for too many rows.
CuspRows contours_by_cusp(const std::vector<Region>& regions, const StepBeside& beside, int threads,
                          Progress& progress);

// The outermost of these rows, and those of what it does not reach. Throws Cancelled.
std::vector<std::vector<Polyline>> border_rows(const std::vector<Region>& regions,
                                               const StepBeside& beside, int threads,
                                               Progress& progress);

}  // namespace evenload
