#include "strategy/trochoid.h"

#include <utility>

#include "strategy/pattern_cache.h"

namespace evenload {

TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress) {
  PatternCache patterns(kind, params, &progress);
  TrochoidReport report;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    return clear_slots_of(task, checked, patterns, report, share);
  };
  Toolpath path = clear_by(clearer, regions, params, progress);
  return {std::move(path), report};
}

}  // namespace evenload
