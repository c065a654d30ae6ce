#include "strategy/constant_engagement.h"

#include <optional>
#include <utility>

#include "strategy/pocket.h"
#include "strategy/region_clearing.h"
#include "strategy/trochoid.h"

namespace evenload {
namespace {

// Stretches that are slots by a pattern, where one serves; the rest pass by pass.
RegionResult clear(const RegionTask& task, const ClearingParams& params, PatternCache& patterns,
                   TrochoidReport& report, Progress& progress) {
  std::optional<RegionResult> result =
      clear_where_patterns_serve(task, params, patterns, report, progress);
  return result ? std::move(*result) : clear_region(task, params, progress);
}

}  // namespace

Toolpath clear_pocket(const std::vector<Region>& regions, const ClearingParams& params,
                      Progress& progress) {
  PatternCache patterns(TrochoidKind::kConstantEngagement, params, &progress, Turns::kWished);
  TrochoidReport report;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    return clear(task, checked, patterns, report, share);
  };
  return clear_by(clearer, regions, params, progress);
}

}  // namespace evenload
