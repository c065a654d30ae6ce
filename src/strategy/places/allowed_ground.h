// Where the tool may be: the pocket, and room outside its open edges.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.h"
#include "toolpath/finding.h"

namespace evenload {

// The regions within which the tool's whole disc must stay; no two of them overlap. Those of
// `regions` that are open all round become one where their rooms meet; other rooms end before other
// regions. `findings` gets those open edges that had to be taken for walls, since no room outside
// is free; `shown`: where a place is shown to the user.
std::vector<Region> allowed_ground(const std::vector<Region>& regions, double tool_diameter,
                                   const std::function<Vec2(Vec2)>& shown,
                                   std::vector<Finding>& findings);

bool has_open_edges(const std::vector<Region>& regions);
// The same with nothing but open pieces: all of its border lies against cleared ground.
std::vector<Region> bared(std::vector<Region> regions);

}  // namespace evenload
