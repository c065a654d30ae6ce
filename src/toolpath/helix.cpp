#include "toolpath/helix.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm: no part of a segment is shorter.
constexpr double kShortest = 1e-6;

}  // namespace

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

std::vector<Segment> way_round(const Descent& helix, double from, double to) {
  const double half = half_turn_length(helix);
  std::vector<Segment> way;
  for (int i = static_cast<int>(std::ceil(from / half)); i > 0 && i * half > to; --i) {
    double before = i * half;  // mm from the segment's beginning to the way's end
    for (const Segment& segment : half_turn(helix, i % 2 != 0)) {
      const double length = segment.length();
      const double begin = std::clamp(before - from, 0.0, length),
                   end = std::clamp(before - to, 0.0, length);
      if (end - begin > kShortest)
        way.push_back(end - begin > length - kShortest
                          ? segment
                          : segment.part(begin / length, end / length));
      before -= length;
    }
  }
  return way;
}

double half_turn_length(const Descent& helix) {
  return kPi * helix.radius + 2 * norm(helix.stretch);
}

double cleared_area(const Descent& helix, double tool_radius) {
  const double reach = helix.radius + tool_radius;
  return kPi * reach * reach + 4 * norm(helix.stretch) * reach;
}

}  // namespace evenload
