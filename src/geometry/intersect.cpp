#include "geometry/intersect.h"

#include <algorithm>
#include <utility>

namespace evenload {

namespace {

// The parameter of p, which lies on the piece's line or circle; below 0 or above 1 where p is
// beyond the ends by more than `tolerance`.
double parameter_on(const Segment& s, Vec2 p, double tolerance) {
  if (!s.is_arc()) {
    const Vec2 along = s.b - s.a;
    const double length = norm(along);
    if (length == 0) return distance(p, s.a) <= tolerance ? 0.0 : -1.0;
    const double reached = dot(p - s.a, along) / length;
    if (reached < -tolerance) return -1;
    if (reached > length + tolerance) return 2;
    return std::clamp(reached / length, 0.0, 1.0);
  }
  const double angle = angle_of(p - s.centre);
  const double turn = std::abs(s.sweep);
  const double turned = wrap_positive(s.sweep > 0 ? angle - s.start_angle : s.start_angle - angle);
  if (turned <= turn) return turned / turn;
  const double past_end = (turned - turn) * s.radius, before_start = (2 * kPi - turned) * s.radius;
  if (std::min(past_end, before_start) > tolerance) return -1;
  return past_end < before_start ? 1.0 : 0.0;
}

void add_if_on_both(Meetings& found, const Segment& a, const Segment& b, Vec2 p, double tolerance) {
  const double ta = parameter_on(a, p, tolerance);
  if (ta < 0 || ta > 1) return;
  const double tb = parameter_on(b, p, tolerance);
  if (tb < 0 || tb > 1) return;
  found.add({ta, tb, p});
}

Meetings of_lines(const Segment& a, const Segment& b, double tolerance) {
  Meetings found;
  const Vec2 u = a.b - a.a, v = b.b - b.a;
  const double denominator = cross(u, v);
  const Vec2 between = b.a - a.a;
  const double length_u = norm(u), length_v = norm(v);
  if (length_u == 0 || length_v == 0) return found;
  // Over the shorter piece's length the lines part by no more than this.
  const double parting = std::abs(denominator) / std::max(length_u, length_v);
  if (parting <= 1e-15 * std::min(length_u, length_v)) return found;
  const double off_start = std::abs(cross(v, between)) / length_v;
  const double off_end = std::abs(cross(v, b.a - a.b)) / length_v;
  if (off_start <= tolerance && off_end <= tolerance &&
      std::abs(cross(u, between)) <= tolerance * length_u &&
      std::abs(cross(u, b.b - a.a)) <= tolerance * length_u)
    return found;
  const double t = cross(between, v) / denominator;
  if (t * length_u < -tolerance || (t - 1) * length_u > tolerance) return found;
  add_if_on_both(found, a, b, a.a + t * u, tolerance);
  return found;
}

Meetings of_line_and_arc(const Segment& line, const Segment& arc, double tolerance) {
  Meetings found;
  const Vec2 along = line.b - line.a;
  const double length = norm(along);
  if (length == 0) return found;
  const Vec2 u = along / length;
  const double off = cross(u, arc.centre - line.a);
  const Vec2 foot = arc.centre + off * Vec2{u.y, -u.x};
  const double beyond = std::abs(off) - arc.radius;
  if (beyond > tolerance) return found;
  const double half = std::sqrt(std::max(0.0, -beyond * (std::abs(off) + arc.radius)));
  add_if_on_both(found, line, arc, foot - half * u, tolerance);
  if (half > 0) add_if_on_both(found, line, arc, foot + half * u, tolerance);
  return found;
}

// Condition: a is not the larger.
Meetings of_arcs(const Segment& a, const Segment& b, double tolerance) {
  Meetings found;
  const Vec2 between = b.centre - a.centre;
  const double apart = norm(between);
  if (apart + std::abs(a.radius - b.radius) <= tolerance) return found;
  const double outside = apart - a.radius - b.radius;
  const double inside = std::abs(a.radius - b.radius) - apart;
  if (outside > tolerance || inside > tolerance || apart == 0) return found;
  const Vec2 u = between / apart;
  // From the centre of a along u to the common chord, and half that chord. Seen from the smaller
  // circle: from the larger one the chord may be lost in rounding.
  const double reach =
      0.5 * ((apart - b.radius) * (apart + b.radius) + a.radius * a.radius) / apart;
  if (outside >= 0 || inside >= 0) {  // a near miss: the touching point halves the gap
    const Vec2 on_a = a.centre + (reach >= 0 ? a.radius : -a.radius) * u;
    const Vec2 from_b = on_a - b.centre;
    const Vec2 on_b = b.centre + b.radius * (squared_norm(from_b) > 0 ? normalized(from_b) : u);
    add_if_on_both(found, a, b, 0.5 * (on_a + on_b), tolerance);
    return found;
  }
  const double half = std::sqrt(std::max(0.0, (a.radius - reach) * (a.radius + reach)));
  const Vec2 foot = a.centre + reach * u;
  add_if_on_both(found, a, b, foot + half * left_normal(u), tolerance);
  if (half > 0) add_if_on_both(found, a, b, foot - half * left_normal(u), tolerance);
  return found;
}

Meetings swapped(Meetings found) {
  for (std::size_t i = 0; i < found.count; ++i) std::swap(found.at[i].ta, found.at[i].tb);
  return found;
}

}  // namespace

Meetings meetings(const Segment& a, const Segment& b, double tolerance) {
  if (!a.is_arc() && !b.is_arc()) return of_lines(a, b, tolerance);
  if (!a.is_arc()) return of_line_and_arc(a, b, tolerance);
  if (!b.is_arc()) return swapped(of_line_and_arc(b, a, tolerance));
  if (a.radius <= b.radius) return of_arcs(a, b, tolerance);
  return swapped(of_arcs(b, a, tolerance));
}

}  // namespace evenload
