// What still stands above a height, as regions of lines and arcs: the stock for rest machining.
#pragma once

#include <vector>

#include "simulate/dexel_stock.h"
#include "simulate/rest.h"

namespace evenload {

// mm: how far the regions' borders may lie from the dexels' own. So little that a tool of 6 mm
// which goes along them meets no arc of one degree.
inline constexpr double kOutlineTolerance = 2e-4;

// The regions of `reach` over which `stock` stands higher than `z`. What rises or is no wider than
// kRestTolerance is left out: walls and floors are cut with tolerances, and an earlier operation's
// would be cut again otherwise. Laws: borders lie within kOutlineTolerance of those of the dexels
// but for corners, which are cut off within a cell, and convex ones rounded to half of
// kRestTolerance; make_region accepts what comes back, and every piece is marked open.
std::vector<Region> standing_regions(const DexelStock& stock, double z,
                                     const std::vector<Region>& reach);

}  // namespace evenload
