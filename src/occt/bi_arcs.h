// A smooth plane curve as arcs: bi-arcs, which have the curve's own points and directions at their
// outer ends.
#pragma once

#include <functional>
#include <vector>

#include "geometry/bi_arc.h"

namespace evenload {

// The open chain from curve(from) to curve(to), both ends included, for a curve whose direction is
// continuous in between. Laws: the chain stays within `tolerance` mm of the curve; its direction is
// continuous; no arc turns by more than a half circle; a straight line gives one line and an arc of
// up to a half circle gives one arc. `spans`: how many pieces of one formula the curve consists of
// (the knot spans of a spline): each is looked at.
Curve bi_arcs(const std::function<PlanePoint(double)>& curve, double from, double to,
              double tolerance, int spans);

}  // namespace evenload
