// Passes between two guides, which change from the shape of the one to that of the other.
#pragma once

#include <vector>

#include "surface/polylines.h"

namespace evenload {

struct GuidedRows {
  std::vector<std::vector<Polyline>> rows;          // one line each
  double least_stepover = 0, largest_stepover = 0;  // mm, in plan
};

// As many lines as keep within `stepover` mm where the guides are furthest apart, of which the
// first and the last are half a step off the guides; each divides the ways between places at the
// same share of both guides' lengths alike. Lines go on straight, and beyond the guides there are
// more of them, by `extension` mm. What follows a line lies to its left. Throws
// std::invalid_argument for guides that are no lines, or that cross.
GuidedRows guided_rows(std::vector<Vec2> first, std::vector<Vec2> second, double stepover,
                       double extension);

}  // namespace evenload
