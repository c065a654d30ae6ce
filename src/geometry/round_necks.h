// Openings by a disc whose necks have no corners.
//
// Where a region is a little narrower than the disc, the places on both sides of the neck overlap,
// and their arcs meet in corners that point at each other across it. A way along such a border
// would turn there all at once. Our own.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// `opened`: regions opened by a disc of `radius` mm. Each such corner of kNeckCorner rad and more
// is rounded, outwards, by an arc of half the radius, or less where the arcs that meet are short;
// but for those of necks that are narrower than twice `narrowest` mm at their corners.
// What is added lies between the corner and the wall behind it: in the region that was opened.
std::vector<Region> with_round_necks(const std::vector<Region>& opened, double radius,
                                     double narrowest);
inline constexpr double kNeckCorner = 0.25 * kPi / 180;

}  // namespace evenload
