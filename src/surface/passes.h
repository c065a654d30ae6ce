// Parallel passes over the picked faces, and the way from one to the next.
#pragma once

#include <vector>

#include "support/progress.h"
#include "surface/fewest_lines.h"
#include "surface/finish_params.h"
#include "surface/ground.h"
#include "surface/spacing.h"
#include "surface/waypoint.h"

namespace evenload {

// What one pass cuts without a break.
struct PassPart {
  std::size_t row = 0;  // the number of its pass
  std::vector<Waypoint> points;
  bool is_closed = false;  // may begin at any of its points, of which the last is the first
};

// How far lines may leave the true height of the tool, in mm: below and above.
struct LineBounds {
  double below = 0, above = 0;
};
// For a `tolerance` of the path against the triangles; what samples leave is taken off.
LineBounds line_bounds(double tolerance);

// The lines, or helices, of a part of the samples of a line or an arc in plan.
std::vector<Waypoint> lines_of(const PlanLine& line, const std::vector<DropSample>& samples,
                               double tolerance, LineEnds ends = LineEnds::kFree);

// The passes at some ordinates, in their order, each in the direction `frame.along`. Throws
// Cancelled.
std::vector<PassPart> parallel_passes(const Ground& ground, const PassFrame& frame,
                                      const std::vector<double>& ordinates,
                                      const FinishParams& params, Progress& progress);

}  // namespace evenload
