// How fast a spiral's turns may be cut, by the width that they cut.
#pragma once

#include <optional>

#include "geometry/monotone_spline.h"
#include "strategy/task/clearing_params.h"

namespace evenload {

// min/mm by mm: what the feed control makes of straight cuts of some widths; nothing where a
// constant feed or removal rate says it at once. Condition: `params` checked. `mirrored`: of the
// work of conventional milling.
std::optional<MonotoneSpline> pace_of(const ClearingParams& params, bool mirrored);

}  // namespace evenload
