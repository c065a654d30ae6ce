// Clears the slots of one region of tool centres at one level by repeated patterns, and what they
// leave pass by pass: steps 1 to 4 of trochoid.h.
#pragma once

#include <optional>
#include <vector>

#include "strategy/plan/plan.h"
#include "strategy/plan/region_task.h"
#include "strategy/slots/slot_way.h"
#include "strategy/task/clearing_params.h"
#include "strategy/trochoid/pattern_cache.h"
#include "support/progress.h"

namespace evenload {

// Conditions as for clear_region. `report`: of all regions of one call; this one is added.
RegionResult clear_slots_of(const RegionTask& task, const ClearingParams& params,
                            PatternCache& patterns, TrochoidReport& report, Progress& progress);

// The same for pockets, some of which are slots in part: nothing where no pattern is repeated, for
// such as posts would write with corners are not, nor are those in hardly any room. What patterns
// leave is cleared as in any pocket.
std::optional<RegionResult> clear_where_patterns_serve(const RegionTask& task,
                                                       const ClearingParams& params,
                                                       PatternCache& patterns,
                                                       TrochoidReport& report, Progress& progress);

}  // namespace evenload
