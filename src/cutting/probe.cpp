#include "cutting/probe.h"

#include <algorithm>
#include <cmath>

namespace evenload {

int looks_along(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

void Probe::look(Vec2 p, double heading, double thin, std::size_t last) {
  const double right = heading - kPi / 2;
  ground_.uncovered(p, right, right + kPi, arcs_, thin, std::min(last, ground_.size()));
}

double Probe::engagement(Vec2 p, double heading, double thin, std::size_t last) {
  look(p, heading, thin, last);
  double engaged = 0;
  for (const AngularInterval& arc : arcs_) engaged += arc.width();
  return engaged;
}

double Probe::engagement(const Segment& move, double t, double thin, std::size_t last) {
  return engagement(move.point(t), angle_of(move.tangent(t)), thin, last);
}

}  // namespace evenload
