#include "surface/finish.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/demand.h"
#include "surface/contours.h"
#include "surface/ordering.h"
#include "surface/passes.h"
#include "surface/spacing.h"

namespace evenload {

namespace {

// More passes are a slip of the pen, and would take days.
constexpr double kMostPasses = 200000;

void check(const FinishParams& p, double deflection) {
  for (const double number : {p.cutter.radius, p.cutter.corner, p.angle, p.stepover, p.cusp_height,
                              p.allowance, p.tolerance, p.floor, p.top, p.safe_height,
                              p.clearance_height, p.feed, p.plunge_feed, p.rapid_feed, deflection})
    demand(std::isfinite(number), "A number for finishing is not finite.");
  demand(p.cutter.radius > 0, "The tool's radius must be positive.");
  demand(p.cutter.corner >= 0 && p.cutter.corner <= p.cutter.radius,
         "The corner's radius must lie between 0 and the tool's radius.");
  demand(p.stepover > 0 && p.stepover <= 2 * p.cutter.radius,
         "The stepover must be positive and no more than the tool's diameter.");
  demand(p.cusp_height >= 0, "The cusp height must not be negative.");
  demand(p.cusp_height == 0 || p.cutter.corner > 0,
         "A flat end mill leaves steps, not cusps: set a stepover, or take a ball end mill.");
  demand(p.cusp_height == 0 || !is_along_outline(p.pattern),
         "Passes along the outline keep a stepover: leave the cusp height out.");
  demand(p.cusp_height <= p.cutter.corner,
         "The cusp height must be no more than the radius of the tool's ball or corner.");
  demand(p.allowance >= 0, "The allowance must not be negative.");
  demand(p.tolerance > 0 && deflection >= 0, "The tolerance must be positive.");
  demand(p.feed > 0 && p.plunge_feed > 0 && p.rapid_feed > 0, "Feeds must be positive.");
  demand(p.safe_height >= p.top && p.clearance_height >= p.safe_height,
         "The safe height must not lie below the top, nor the clearance height below it.");
}

// Parts of parallel passes; `result` is told how far these are apart.
std::vector<PassPart> side_by_side(const Ground& ground, const FinishParams& params,
                                   double deflection, Finish& result, Progress& progress) {
  const PassFrame frame = pass_frame(ground, params.angle);
  demand(frame.last - frame.first < kMostPasses * params.stepover,
         "The stepover makes too many passes: raise it.");
  const std::vector<double> ordinates =
      params.cusp_height > 0
          ? spacing_by_cusp(ground, frame, params.cusp_height, deflection, progress)
          : even_spacing(frame, params.stepover);
  std::vector<PassPart> parts = parallel_passes(ground, frame, ordinates, params, progress);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].row != parts[i - 1].row + 1) continue;
    const double step = ordinates[parts[i].row] - ordinates[parts[i - 1].row];
    result.largest_stepover = std::max(result.largest_stepover, step);
    if (result.least_stepover == 0 || step < result.least_stepover) result.least_stepover = step;
  }
  return parts;
}

// Parts of passes along the outline.
std::vector<PassPart> along_outline(const Ground& ground, const FinishParams& params,
                                    Finish& result, Progress& progress) {
  const std::vector<Region> regions = covered_by_picked(*ground.mesh);
  const Bounds bounds = bounds_of(regions);
  demand(norm(bounds.high - bounds.low) < kMostPasses * params.stepover,
         "The stepover makes too many passes: raise it.");
  std::vector<std::vector<std::vector<Vec2>>> rows =
      contour_rows(ground, regions, params.stepover, progress);
  if (params.pattern == Pattern::kContoursOutwards) std::reverse(rows.begin(), rows.end());
  result.least_stepover = result.largest_stepover = rows.size() > 1 ? params.stepover : 0;
  return contour_passes(ground, rows, params, progress);
}

}  // namespace

Finish finish_surface(const FacetMesh& mesh, const FinishParams& params, double deflection,
                      Progress& progress) {
  check(params, deflection);
  const Ground ground{&mesh, params.cutter, params.allowance, params.floor, params.by_contact};
  Finish result;
  try {
    std::vector<PassPart> parts = is_along_outline(params.pattern)
                                      ? along_outline(ground, params, result, progress)
                                      : side_by_side(ground, params, deflection, result, progress);
    demand(!parts.empty(),
           "The tool touches none of the picked faces: take a smaller one, or lower "
           "FinalDepth.");
    FinishParams ordered = params;
    ordered.stepover = std::max(params.stepover, result.largest_stepover);
    result.toolpath = in_order(ground, std::move(parts), ordered, progress);
  } catch (const Cancelled&) {
    result = {};
    result.toolpath.report.termination = Termination::kCancelled;
  }
  return result;
}

}  // namespace evenload
