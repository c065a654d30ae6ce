// Passes along the outline of the picked faces: the outline seen from above, moved inwards stepover
// by stepover.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "support/progress.h"
#include "surface/ground.h"
#include "surface/polylines.h"

namespace evenload {

// What the picked triangles cover, seen from above, to kOutlineTolerance. Throws
// std::invalid_argument where that is nothing, GeometryError where it bounds no region.
std::vector<Region> covered_by_picked(const FacetMesh& mesh);
inline constexpr double kOutlineTolerance =
    0.001;  // mm; of plan alone, heights are as exact as ever

// Closed polygons, for each row those at one distance from the outline: the outermost row first,
// half a stepover within the border, and as far beyond it as the tool may touch the faces from
// there. The ground lies to the left of each. Throws Cancelled.
std::vector<std::vector<Polyline>> contour_rows(const Ground& ground,
                                                const std::vector<Region>& regions, double stepover,
                                                Progress& progress);

}  // namespace evenload
