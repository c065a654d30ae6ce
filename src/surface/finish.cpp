#include "surface/finish.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "support/demand.h"
#include "surface/contours.h"
#include "surface/contours_by_cusp.h"
#include "surface/guides.h"
#include "surface/ordering.h"
#include "surface/passes.h"
#include "surface/spacing.h"
#include "surface/spiral.h"

namespace evenload {

namespace {

void check(const FinishParams& p, double deflection) {
  for (const double number :
       {p.cutter.radius, p.cutter.corner, p.angle, p.stepover, p.cusp_height, p.allowance,
        p.extension, p.lead_radius, p.fixture_clearance, p.tolerance, p.floor, p.top, p.safe_height,
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
  demand(p.cusp_height <= p.cutter.corner,
         "The cusp height must be no more than the radius of the tool's ball or corner.");
  demand(p.allowance >= 0, "The allowance must not be negative.");
  demand(p.extension >= 0, "The extension must not be negative.");
  demand(p.fixture_clearance >= 0, "The clearance of fixtures must not be negative.");
  demand(p.lead_radius >= 0, "The lead radius must not be negative.");
  demand(!is_between_guides(p.pattern) || p.guides.size() == 2,
         "Passes between guides need two of them.");
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

// A tool that turns clockwise climbs with what stands on its right: within, or around.
bool is_clockwise(const FinishParams& params) {
  return params.is_climb != (params.pattern == Pattern::kSpiralOutwards);
}

// Lines along the outline, or of a spiral, at even distances.
std::vector<std::vector<Polyline>> even_rows(const Ground& ground,
                                             const std::vector<Region>& regions,
                                             const FinishParams& params, Finish& result,
                                             Progress& progress) {
  std::vector<std::vector<Polyline>> rows;
  if (is_spiral(params.pattern)) {
    rows = spiral_rows(ground, regions, params.stepover, params.pattern == Pattern::kSpiralOutwards,
                       is_clockwise(params));
  } else {
    rows = contour_rows(ground, regions, params.stepover, progress);
    if (params.pattern == Pattern::kContoursOutwards) std::reverse(rows.begin(), rows.end());
  }
  result.least_stepover = result.largest_stepover = rows.size() > 1 ? params.stepover : 0;
  return rows;
}

// The same at distances that leave even cusps.
std::vector<std::vector<Polyline>> rows_by_cusp(const Ground& ground,
                                                const std::vector<Region>& regions,
                                                const FinishParams& params, double deflection,
                                                Finish& result, Progress& progress) {
  const StepBeside beside(ground, params.cusp_height, deflection);
  if (is_spiral(params.pattern)) {
    SpiralByCusp found =
        spiral_by_cusp(ground, regions, beside, params.pattern == Pattern::kSpiralOutwards,
                       is_clockwise(params), params.threads, progress);
    result.least_stepover = found.least_stepover;
    result.largest_stepover = found.largest_stepover;
    return std::move(found.turns);
  }
  CuspRows found = contours_by_cusp(regions, beside, params.threads, progress);
  if (params.pattern == Pattern::kContoursOutwards)
    std::reverse(found.rows.begin(), found.rows.end());
  result.least_stepover = found.least_stepover;
  result.largest_stepover = found.largest_stepover;
  return std::move(found.rows);
}

// Parts of passes along the outline, or of a spiral.
std::vector<PassPart> round_about(const Ground& ground, const FinishParams& params,
                                  double deflection, Finish& result, Progress& progress) {
  const std::vector<Region> regions =
      ground.extension ? ground.extension->regions() : covered_by_picked(*ground.mesh);
  const Bounds bounds = bounds_of(regions);
  demand(norm(bounds.high - bounds.low) < kMostPasses * params.stepover,
         "The stepover makes too many passes: raise it.");
  return passes_along(ground,
                      params.cusp_height > 0
                          ? rows_by_cusp(ground, regions, params, deflection, result, progress)
                          : even_rows(ground, regions, params, result, progress),
                      params, progress);
}

std::vector<PassPart> between_guides(const Ground& ground, const FinishParams& params,
                                     double deflection, Finish& result, Progress& progress) {
  const Guides guides(params.guides[0], params.guides[1]);
  const double count = params.cusp_height > 0
                           ? guides.count_for(StepBeside(ground, params.cusp_height, deflection),
                                              params.threads, progress)
                           : guides.count_for(params.stepover);
  const GuidedRows guided = guides.rows(count, params.extension);
  result.least_stepover = guided.least_stepover;
  result.largest_stepover = guided.largest_stepover;
  return passes_along(ground, guided.rows, params, progress);
}

std::vector<PassPart> all_parts(const Ground& ground, const FinishParams& params, double deflection,
                                Finish& result, Progress& progress) {
  if (is_parallel(params.pattern))
    return side_by_side(ground, params, deflection, result, progress);
  if (is_between_guides(params.pattern))
    return between_guides(ground, params, deflection, result, progress);
  return round_about(ground, params, deflection, result, progress);
}

}  // namespace

Finish finish_surface(const FacetMesh& mesh, const FinishParams& params, double deflection,
                      Progress& progress, const FacetMesh* fixtures) {
  check(params, deflection);
  std::optional<Extension> extension;
  if (params.extension > 0) extension.emplace(mesh, params.extension);
  const Ground ground{extension ? &extension->ground() : &mesh,
                      params.cutter,
                      params.allowance,
                      params.floor,
                      params.by_contact,
                      extension ? &*extension : nullptr,
                      fixtures,
                      params.fixture_clearance};
  Finish result;
  try {
    std::vector<PassPart> parts = all_parts(ground, params, deflection, result, progress);
    demand(!parts.empty() || !fixtures,
           "The fixtures leave the tool none of the picked faces: move them, or lower "
           "FixtureClearance.");
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
