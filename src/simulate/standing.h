// What still stands above a height, as regions of lines and arcs: the stock for rest machining.
#pragma once

#include <vector>

#include "simulate/dexel_stock.h"
#include "simulate/rest.h"

namespace evenload {

// mm: how far the regions' borders may lie from the dexels' own. So little that a tool of 6 mm
// which goes along them meets no arc of one degree.
inline constexpr double kOutlineTolerance = 2e-4;

// mm: stock is followed so far beyond the reach, ten times the tolerance. A tool that stands at the
// reach's border, in a corner say, is to meet what stands there, and not a border fitted to its own
// circle.
inline constexpr double kBeyondReach = 2e-3;

// The regions of `reach`, grown by kBeyondReach, over which `stock` stands higher than `z`. What
// rises or is no wider than kRestTolerance is left out: walls and floors are cut with tolerances,
// and an earlier operation's would be cut again otherwise. Laws: borders lie within
// kOutlineTolerance of those of the dexels, but corners are cut off within a cell, and convex ones
// rounded by kBeyondReach; make_region accepts what comes back, and every piece is marked open.
std::vector<Region> standing_regions(const DexelStock& stock, double z,
                                     const std::vector<Region>& reach);

}  // namespace evenload
