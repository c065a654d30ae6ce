// The way from the air into a pass, and from a pass into the air.
#pragma once

#include <vector>

#include "surface/finish_params.h"
#include "surface/ground.h"
#include "surface/waypoint.h"

namespace evenload {

// The corners of a quarter arc that goes on from the first of a pass's points, away from it, and
// rises: upright, tangential to the pass, of `lead_radius` or, where the tool would meet the part,
// of a half, a quarter or an eighth of it; the one next to the pass comes first. Empty where none
// fits. Points: the pass from its end at the arc on, forwards or backwards.
std::vector<SpacePoint> lead_arc(const Ground& ground, const std::vector<Waypoint>& points,
                                 const FinishParams& params);

}  // namespace evenload
