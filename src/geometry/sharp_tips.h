// Tips between walls that are nearly parallel. A tool that keeps a small distance from both stays
// many times that distance away from where it would touch them: between teeth that meet at two
// degrees 0.0008 mm of a gap cost 0.05 mm of depth, all across the tool.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// `regions`, whose border is `gap` mm inside another one, with their sharpest tips lengthened:
// where that leaves more than a few hundredths of a millimetre to be had between two lines, the tip
// comes as near to the other border's as `gap`. Laws: only such tips are moved, along their axes,
// by less than a quarter of either line; the result lies inside the border at `gap` from its own.
std::vector<Region> with_sharp_tips(const std::vector<Region>& regions, double gap);

}  // namespace evenload
