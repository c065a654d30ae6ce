// What a path left standing that should have gone.
//
// The part's corners that no disc of the tool's radius reaches are left by nature: they are the
// part grown by the radius and shrunk again, less the part. What stands beyond that is rest.
#pragma once

#include <vector>

#include "simulate/dexel_stock.h"

namespace evenload {

// A patch of rest, connected row by row.
struct RestPatch {
  double area = 0;   // mm^2
  double depth = 0;  // mm: the highest it stands above what should be there
  Vec2 at;           // the middle of its longest row
};

struct Rest {
  double area = 0;                          // mm^2
  double unreachable_area = 0;              // mm^2 that stands where the tool cannot get
  double depth = 0;                         // mm
  std::vector<RestPatch> patches;           // the largest first
  std::vector<std::vector<Vec2>> outlines;  // polygons that tile it
};

// mm: walls and floors are cut with tolerances, and G-code is rounded: what stands out less is no
// rest.
inline constexpr double kRestTolerance = 0.01;

// The rest of `stock` against `part`, whose prisms may touch and overlap; without a part all of the
// stock should have gone.
Rest find_rest(const DexelStock& stock, const std::vector<Prism>& part, double tool_radius);

}  // namespace evenload
