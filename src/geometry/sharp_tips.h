// Tips between walls that are nearly parallel. A tool that keeps a small distance from both stays
// many times that distance away from where it would touch them: between teeth that meet at two
// degrees 0.0008 mm of a gap cost 0.05 mm of depth, all across the tool.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// `regions` shrunk by `distance` + `gap` mm, with their sharpest tips lengthened: where that leaves
// more than a few hundredths of a millimetre to be had between two lines, the tip comes as near as
// `gap` to where those shrunk by `distance` alone end. Laws: only such tips are moved, along their
// axes, by less than a quarter of either line; the result lies inside what is shrunk by `distance`
// alone, and where that goes on beyond a tip, as in a neck, the tip stays.
std::vector<Region> shrunk_to_tips(const std::vector<Region>& regions, double distance, double gap);

}  // namespace evenload
