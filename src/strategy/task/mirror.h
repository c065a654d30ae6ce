// Mirror images, x to -x: conventional milling is climb milling of the mirror image.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "toolpath/planar.h"

namespace evenload {

Vec2 mirrored(Vec2 p);
// The sense of rotation of closed curves stays.
std::vector<Region> mirrored(const std::vector<Region>& regions);
void mirror_run(PlanarRun& run);

}  // namespace evenload
