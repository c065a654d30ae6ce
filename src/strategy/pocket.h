// From pockets to a toolpath: what every strategy shares. The strategy itself clears one connected
// region of tool centres at one level.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"
#include "strategy/constant_engagement.h"
#include "strategy/region_clearing.h"
#include "support/progress.h"
#include "toolpath/toolpath.h"

namespace evenload {

using RegionClearer =
    std::function<RegionResult(const RegionTask&, const ClearingParams&, Progress&)>;

// The toolpath that clears `regions` level by level; `clearer` is asked once for each region of
// tool centres that holds no narrow passage to be cut at a reduced feed: those are cleared at
// constant engagement. Laws: the clearer always sees climb milling, and parameters that were
// checked; feeds, levels, depths and the report are made here. Arguments and errors as for
// clear_pocket.
Toolpath clear_by(const RegionClearer& clearer, const std::vector<Region>& regions,
                  const ClearingParams& params, Progress& progress);

}  // namespace evenload
