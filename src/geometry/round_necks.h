// Openings by a disc whose necks have no corners.
//
// Where a region is a little narrower than the disc, the places on both sides of the neck overlap,
// and their arcs meet in corners that point at each other across it. A way along such a border
// would turn there all at once. Our own.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"

namespace evenload {

// `opened`: regions opened by a disc of `radius` mm. Each such corner of kNeckCorner rad and more
// is rounded, outwards, by an arc of half the radius, or of the first of smaller ones that touches
// both arcs that meet and that `may_be_border` allows: what is rounded need not lie within the
// region that was opened where walls turn more tightly than the arc. Necks that are narrower than
// twice `narrowest` mm from corner to corner keep them.
std::vector<Region> with_round_necks(const std::vector<Region>& opened, double radius,
                                     double narrowest,
                                     const std::function<bool(const Segment&)>& may_be_border);
inline constexpr double kNeckCorner = 0.25 * kPi / 180;

}  // namespace evenload
