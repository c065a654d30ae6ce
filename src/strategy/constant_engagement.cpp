#include "strategy/constant_engagement.h"

#include <algorithm>

#include "strategy/move_checks.h"
#include "strategy/pocket.h"
#include "strategy/region_clearing.h"

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

}  // namespace

Toolpath clear_pocket(const std::vector<Region>& regions, const ClearingParams& params,
                      Progress& progress) {
  const RegionClearer clearer = [](const RegionTask& given, const ClearingParams& checked,
                                   Progress& share) {
    RegionTask task = given;
    task.overload = overload(checked);
    task.rows = Rows::kQuick;
    return clear_region(task, checked, share);
  };
  return clear_by(clearer, regions, params, progress);
}

}  // namespace evenload
