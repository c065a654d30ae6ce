#include "strategy/move_checks.h"

#include <cmath>

namespace evenload {

bool is_tangent(const Segment& a, const Segment& b, double difference) {
  return norm(a.tangent(1) - b.tangent(0)) < difference;
}

bool follows_border(const Segment& move, const Area& centres) {
  for (const double t : {0.25, 0.5, 0.75})
    if (std::abs(centres.signed_distance(move.point(t))) > kOnBorder) return false;
  return true;
}

bool is_inside(const Segment& move, const Area& centres, double tolerance, int looks) {
  for (int i = 0; i <= looks; ++i)
    if (centres.signed_distance(move.point(static_cast<double>(i) / looks)) < -tolerance)
      return false;
  return true;
}

}  // namespace evenload
