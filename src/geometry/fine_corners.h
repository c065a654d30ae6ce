// Borders without rows of fine corners. A round wall that was drawn as many short lines comes back
// from the offset with a corner at each of them: a tool that follows it turns at all of these, and
// pieces of a hundredth of a millimetre make a program long. Arcs that touch the lines from inside
// take their place.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// rad: corners between lines that turn to the inside by less are fine.
inline constexpr double kFineCorner = 0.21;

// `regions` with each row of fine corners replaced by tangent arcs. Laws: the result lies inside
// the regions, but for rounding, and no place of their border is further from its than `tolerance`
// mm; arcs, corners to the outside and edges marked `open` stay as they are.
std::vector<Region> without_fine_corners(const std::vector<Region>& regions, double tolerance);

}  // namespace evenload
