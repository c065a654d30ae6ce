// Points to tangent-friendly chains of lines and arcs.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

// The open chain of as few lines and arcs as a greedy search finds that passes through the first and last point and stays within
// `tolerance` mm of the polyline `points`. Throws std::invalid_argument for fewer than two points or tolerance <= 0.
Curve fit_arcs(const std::vector<Vec2>& points, double tolerance);

}  // namespace evenload
