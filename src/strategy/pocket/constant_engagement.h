// Constant-engagement clearing of pockets [Jacsó 2021, Theses II, III and the hybrid path].
#pragma once

#include <vector>

#include "strategy/task/clearing_params.h"
#include "support/progress.h"
#include "toolpath/toolpath.h"

namespace evenload {

// The toolpath that clears `regions` (pocket floors: vertices' `open` marks pieces without a wall)
// level by level. Throws std::invalid_argument for parameters out of range, GeometryError for
// regions that the tool does not fit (the sentence names the largest tool that would fit) and for
// entries that cannot be used.
Toolpath clear_pocket(const std::vector<Region>& regions, const ClearingParams& params,
                      Progress& progress);

// What the tool's disc can reach of the regions: where stock matters to clear_pocket.
std::vector<Region> reachable_ground(const std::vector<Region>& regions, double tool_diameter,
                                     double stock_to_leave);

}  // namespace evenload
