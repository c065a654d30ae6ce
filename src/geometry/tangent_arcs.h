// A smooth curve as few arcs within a tolerance, each tangent to the next.
#pragma once

#include <vector>

#include "geometry/curve_looks.h"

namespace evenload {

struct TangentArcs {
  std::vector<Segment> moves;
  std::vector<double> until;  // the curve's parameter at the end of each move, nearly
};

// The curve place(u), 0 <= u <= end, whose directions are those of its points' travel. No arc spans
// more than `most_step` of u. Laws: the arcs begin and end where the curve does, in its directions;
// no place of the curve is farther than `tolerance` mm from them where it is looked at, which is
// often enough for curves whose curvature changes evenly along each arc.
// Conditions: end, most_step, tolerance > 0.
TangentArcs tangent_arcs(const CurvePlace& place, double end, double most_step, double tolerance);

}  // namespace evenload
