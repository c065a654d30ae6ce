// The border of what dexels hold above a height, as polygons.
//
// Rows and columns meet the border in exact points. Neighbouring rows and columns bound a cell, and
// the points on its four sides are joined in pairs: so that no two joints cross, that as few as can
// be turn back to the side they come from, which keeps slivers whole and slits open, and that all
// together are as short as they can be. Laws: every vertex lies where a dexel begins or ends; the
// material lies to the left of travel; polygons do not cross; where a cell has one pair of points
// the border is met within second order of the resolution. Corners are cut off within a cell, and
// slivers and slits narrower than it may break where they run from node to node. What lies between
// the dexels is not seen. Our own; the joints are those of marching squares but for their choice.
#pragma once

#include <vector>

#include "simulate/dexel_stock.h"

namespace evenload {

// Of what stands higher than `z` mm within one region of each set; closed, the first point not
// repeated.
std::vector<std::vector<Vec2>> outlines_above(const DexelStock& stock, double z,
                                              const std::vector<std::vector<Region>>& within);

}  // namespace evenload
