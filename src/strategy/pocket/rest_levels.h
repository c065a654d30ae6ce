// Rest machining at several depths, where what earlier cuts left differs from level to level.
#pragma once

#include <vector>

#include "strategy/pocket/constant_engagement.h"

namespace evenload {

// The toolpath of clear_pocket with a stock for each of params.levels, or with one for all of them;
// params.stock is not looked at. Levels at which nothing stands are left out, neighbouring ones at
// which the same stands are cleared together, and the others one after the other, all regions of
// one before the next. No moves, and a note, where nothing stands at all. Throws
// std::invalid_argument for another number of stocks, and what clear_pocket throws.
Toolpath clear_rest(const std::vector<Region>& regions,
                    const std::vector<std::vector<Region>>& stocks, const ClearingParams& params,
                    Progress& progress);

}  // namespace evenload
