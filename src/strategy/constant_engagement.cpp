#include "strategy/constant_engagement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "strategy/move_checks.h"
#include "strategy/pocket.h"
#include "strategy/region_clearing.h"
#include "strategy/trochoid.h"

namespace evenload {
namespace {

// rad: passes may exceed the engagement angle by this for the sake of fewer moves, which with what
// posts round stays below two degrees; at angles below kFullAngle, where it is more of the load, in
// proportion less beyond kSmoothOverload. Chords in place of arcs need that room themselves.
constexpr double kOverload = 1.5 * kSmoothOverload;
constexpr double kFullAngle = kPi / 3;

double overload(const ClearingParams& params) {
  if (!params.arcs) return kSmoothOverload;
  const double share = std::min(1.0, params.engagement_angle / kFullAngle);
  return kSmoothOverload + (kOverload - kSmoothOverload) * share;
}

// Stretches that are slots by a pattern, where one serves; the rest pass by pass.
RegionResult clear(const RegionTask& given, const ClearingParams& params, PatternCache& patterns,
                   SlotsDone& done, Progress& progress) {
  RegionTask task = given;
  task.overload = overload(params);
  task.rows = Rows::kQuick;
  std::optional<RegionResult> result =
      clear_where_patterns_serve(task, params, patterns, done, progress);
  return result ? std::move(*result) : clear_region(task, params, progress);
}

}  // namespace

Toolpath clear_pocket(const std::vector<Region>& regions, const ClearingParams& params,
                      Progress& progress) {
  PatternCache patterns(TrochoidKind::kConstantEngagement, params, &progress, Turns::kWished);
  if (std::optional<TrochoidalPath> path =
          clear_abridged_slots(regions, patterns, clear, params, progress))
    return std::move(path->path);
  SlotsDone done;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    return clear(task, checked, patterns, done, share);
  };
  return clear_by(clearer, regions, params, progress);
}

}  // namespace evenload
