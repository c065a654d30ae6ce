#include "strategy/trochoid/slot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "support/tolerances.h"

namespace evenload {
namespace {

// rad: of walls that run beside each other.
constexpr double kParallel = 1e-4;
// Looks along a stretch, in halves of its room; where it ends is found to kSame mm.
constexpr double kLook = 0.5;
// rad: no stretch goes further round.
constexpr double kMostSweep = 1.9 * kPi;

Segment line_or_arc(const Segment& middle, double from, double to) {  // mm along it, beyond it too
  if (!middle.is_arc()) {
    const Vec2 u = middle.tangent(0);
    return Segment::line(middle.a + from * u, middle.a + to * u);
  }
  const double per_mm = (middle.sweep > 0 ? 1 : -1) / middle.radius;
  return Segment::arc(middle.centre, middle.radius, middle.start_angle + from * per_mm,
                      (to - from) * per_mm);
}

// The middle of what two walls share; both have the inside on their left.
std::optional<SlotStretch> between_lines(const Segment& right, const Segment& left) {
  const Vec2 u = right.tangent(0), n = left_normal(u);
  if (dot(u, left.tangent(0)) > -1 + 0.5 * kParallel * kParallel) return std::nullopt;
  const double first = dot(left.a - right.a, n), last = dot(left.b - right.a, n);
  if (std::min(first, last) <= kOnWall || std::abs(first - last) > kSameWidth) return std::nullopt;
  const double from = std::max(0.0, dot(left.b - right.a, u)),
               to = std::min(right.length(), dot(left.a - right.a, u));
  if (to <= from) return std::nullopt;
  const double half = 0.5 * std::min(first, last);
  const Vec2 start = right.a + half * n;
  return SlotStretch{Segment::line(start + from * u, start + to * u), half};
}

std::optional<SlotStretch> between_arcs(const Segment& right, const Segment& left) {
  const double side = right.sweep > 0 ? 1 : -1;
  const double aside = distance(right.centre, left.centre);
  if (left.sweep * side > 0 || aside > 0.5 * kSameWidth) return std::nullopt;
  const double across = side * (right.radius - left.radius) - aside;  // at the narrowest place
  if (across <= kOnWall) return std::nullopt;
  // Angles from the right wall's start on, in its sense.
  const double whole = std::abs(right.sweep);
  double from = wrap_positive(side * (left.start_angle + left.sweep - right.start_angle));
  const double to_end = from + std::abs(left.sweep);
  double to = std::min(whole, to_end);
  if (from >= whole) {  // the left wall may begin before the right one
    if (to_end - 2 * kPi <= 0) return std::nullopt;
    from = 0;
    to = std::min(whole, to_end - 2 * kPi);
  }
  const double radius = right.radius - side * 0.5 * across;
  return SlotStretch{Segment::arc(right.centre, radius, right.start_angle + side * from,
                                  side * std::min(to - from, kMostSweep)),
                     0.5 * across};
}

bool fits(const Area& centres, const SlotStretch& stretch, double s) {
  return centres.signed_distance(pose_on(stretch, s).p) >= stretch.half_room - kOnWall;
}

// mm from `s` on, in steps of `step` mm, negative ones go back, as far as the disc fits.
double fitting_end(const Area& centres, const SlotStretch& stretch, double s, double step,
                   double most) {
  double good = s;
  while (std::abs(good + step - s) < most && fits(centres, stretch, good + step)) good += step;
  double bad = good + step;
  if (std::abs(bad - s) >= most) return good;
  while (std::abs(bad - good) > kSame) {
    const double middle = 0.5 * (good + bad);
    (fits(centres, stretch, middle) ? good : bad) = middle;
  }
  return good;
}

// The stretch as far as the disc fits to both sides of its middle place; nothing where it does not
// fit there.
std::optional<SlotStretch> whole(const Area& centres, const SlotStretch& found, double longest) {
  const double at = 0.5 * found.middle.length(), step = kLook * found.half_room;
  if (!fits(centres, found, at)) return std::nullopt;
  const double most = found.middle.is_arc() ? 0.5 * kMostSweep * found.middle.radius : longest;
  const double from = fitting_end(centres, found, at, -step, most),
               to = fitting_end(centres, found, at, step, most);
  return SlotStretch{line_or_arc(found.middle, from, to), found.half_room};
}

bool is_same(const SlotStretch& a, const SlotStretch& b) {
  return std::abs(a.half_room - b.half_room) < kSameWidth &&
         b.middle.distance_to(a.middle.point(0.5)) < kSameWidth &&
         a.middle.distance_to(b.middle.point(0.5)) < kSameWidth;
}

}  // namespace

Pose pose_on(const SlotStretch& stretch, double s) {
  const Segment piece = line_or_arc(stretch.middle, 0, s);
  if (s == 0) return {stretch.middle.a, angle_of(stretch.middle.tangent(0))};
  if (!stretch.middle.is_arc()) return {piece.b, angle_of(stretch.middle.tangent(0))};
  const double angle = piece.start_angle + piece.sweep;
  return {piece.b, angle + (stretch.middle.sweep > 0 ? kPi / 2 : -kPi / 2)};
}

std::vector<SlotStretch> find_slots(const Area& centres, double widest) {
  std::vector<Segment> walls;
  for (const Curve& curve : centres.curves())
    for (const Segment& wall : curve.segments()) walls.push_back(wall);
  double longest = 0;
  for (const Segment& wall : walls) longest += wall.length();
  std::vector<SlotStretch> found;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = i + 1; j < walls.size(); ++j) {
      if (walls[i].is_arc() != walls[j].is_arc()) continue;
      const std::optional<SlotStretch> pair =
          walls[i].is_arc() ? between_arcs(walls[i], walls[j]) : between_lines(walls[i], walls[j]);
      if (!pair || pair->half_room > widest) continue;
      const std::optional<SlotStretch> stretch = whole(centres, *pair, longest);
      if (!stretch || stretch->middle.length() < 2 * stretch->half_room) continue;
      if (std::none_of(found.begin(), found.end(),
                       [&](const SlotStretch& known) { return is_same(known, *stretch); }))
        found.push_back(*stretch);
    }
  std::stable_sort(found.begin(), found.end(), [](const SlotStretch& a, const SlotStretch& b) {
    return a.middle.length() > b.middle.length() + kOnWall;
  });
  return found;
}

std::vector<Segment> border_between(const Curve& border, const WallPlace& from,
                                    const WallPlace& to) {
  std::vector<Segment> pieces;
  const auto push = [&](std::size_t i, double t0, double t1) {
    if ((t1 - t0) * border.segment(i).length() > kZeroLength)
      pieces.push_back(border.segment(i).part(t0, t1));
  };
  if (from.segment == to.segment && from.t <= to.t) {
    push(from.segment, from.t, to.t);
    return pieces;
  }
  push(from.segment, from.t, 1);
  const std::size_t n = border.segment_count();
  for (std::size_t i = (from.segment + 1) % n; i != to.segment; i = (i + 1) % n) push(i, 0, 1);
  push(to.segment, 0, to.t);
  return pieces;
}

}  // namespace evenload
