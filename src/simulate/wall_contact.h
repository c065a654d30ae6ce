// Which cuts leave a wall: what still stands beside the tool's places when all is done.
#pragma once

#include <vector>

#include "simulate/engaged_arcs.h"

namespace evenload {

// mm of material above the tip that make a wall of what stands: less is the unevenness of floors.
inline constexpr double kLeastWall = 0.01;

// For each circle of a tool whether `stock` stands beside it, to the left or to the right of the
// feed, within two spacings of the dexels: 1 or 0. What the tool left there is on its circle, and
// so is, for a tool that rolls about it, a corner, which is met by dexels only where it reaches in
// by more than one spacing.
std::vector<char> stands_beside(const DexelStock& stock, const std::vector<ToolCircle>& tools);

}  // namespace evenload
