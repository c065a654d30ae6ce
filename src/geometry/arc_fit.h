// Points to tangent-friendly chains of lines and arcs.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

// The open chain of as few lines and arcs as a greedy search finds that passes through the first
// and last point and stays within `tolerance` mm of the polyline `points`. Laws: no point of the
// polyline is farther than `tolerance` from the chain, nor any point of the chain from the
// polyline; every vertex of the chain is one of the points, in their order; arcs turn by half a
// circle at most. Within the tolerance each piece starts as nearly as it can in the direction in
// which the one before it ends. Throws std::invalid_argument for fewer than two points or tolerance
// <= 0.
Curve fit_arcs(const std::vector<Vec2>& points, double tolerance);

}  // namespace evenload
