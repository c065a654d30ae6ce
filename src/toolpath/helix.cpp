#include "toolpath/helix.h"

namespace evenload {

std::vector<Segment> half_turn(const Descent& helix, bool second) {
  const double sign = second ? -1 : 1, radius = helix.radius;
  if (norm(helix.stretch) == 0)
    return {Segment::arc(helix.centre, radius,
                         angle_of(helix.at - helix.centre) + (second ? kPi : 0), kPi)};
  const Vec2 end = helix.centre + sign * helix.stretch, other = helix.centre - sign * helix.stretch;
  const double ahead = angle_of(sign * helix.stretch);
  const Segment first = Segment::arc(end, radius, ahead, kPi / 2),
                last = Segment::arc(other, radius, ahead + kPi / 2, kPi / 2);
  return {first, Segment::line(first.b, last.a), last};
}

double half_turn_length(const Descent& helix) {
  return kPi * helix.radius + 2 * norm(helix.stretch);
}

double cleared_area(const Descent& helix, double tool_radius) {
  const double reach = helix.radius + tool_radius;
  return kPi * reach * reach + 4 * norm(helix.stretch) * reach;
}

}  // namespace evenload
