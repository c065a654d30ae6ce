// Clears one connected region of tool centres at one level: spiral, then passes from wall to wall,
// stage by stage.
#pragma once

#include "strategy/plan/plan.h"
#include "strategy/plan/region_task.h"
#include "strategy/task/clearing_params.h"
#include "support/progress.h"

namespace evenload {

// Goes on from what `plan` has made of this region, if anything; not with `rest`. What it knows of
// other regions, with a pre-drilled hole elsewhere, is the way in. Condition: `params` checked;
// climb milling (the caller mirrors for conventional). Stops early when `progress` is cancelled, of
// which the plan's looks at its ground are steps from now on.
void clear_region(Plan& plan, const RegionTask& task, const ClearingParams& params,
                  Progress& progress);
// From nothing.
RegionResult clear_region(const RegionTask& task, const ClearingParams& params, Progress& progress);

}  // namespace evenload
