#include "strategy/constant_engagement.h"

#include "strategy/pocket.h"
#include "strategy/region_clearing.h"

namespace evenload {

Toolpath clear_pocket(const std::vector<Region>& regions, const ClearingParams& params,
                      Progress& progress) {
  return clear_by(&clear_region, regions, params, progress);
}

}  // namespace evenload
