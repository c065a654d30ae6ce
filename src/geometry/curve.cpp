#include "geometry/curve.h"

#include <algorithm>
#include <stdexcept>

namespace evenload {

namespace {

// How far `angle` lies behind `start` in the direction of `sweep`, in [0, 2 pi).
double turned_from(double start, double angle, double sweep) {
  return wrap_positive(sweep > 0 ? angle - start : start - angle);
}

// Whether a ray from q towards +x crosses the chord, +1 for upwards; 0 if it does not.
int chord_crossing(Vec2 a, Vec2 b, Vec2 q) {
  if (a.y <= q.y && q.y < b.y) return cross(b - a, q - a) > 0 ? 1 : 0;
  if (b.y <= q.y && q.y < a.y) return cross(b - a, q - a) < 0 ? -1 : 0;
  return 0;
}

// Whether q counts as left of the chord, with ties broken just as chord_crossing breaks them.
bool left_of_chord(Vec2 a, Vec2 b, Vec2 q) {
  const double side = cross(b - a, q - a);
  if (side != 0) return side > 0;
  return a.y == b.y ? b.x > a.x : b.y < a.y;
}

}  // namespace

// The winding number of a closed chain is that of its chords, corrected for q between a chord and
// its arc.
int winding_of(const Segment& s, Vec2 q) {
  int winding = chord_crossing(s.a, s.b, q);
  if (s.is_arc()) {
    const bool in_disc = squared_norm(q - s.centre) < s.radius * s.radius;
    const bool left = left_of_chord(s.a, s.b, q);
    if (in_disc && s.sweep > 0 && !left) ++winding;
    if (in_disc && s.sweep < 0 && left) --winding;
  }
  return winding;
}

Segment Segment::line(Vec2 from, Vec2 to) {
  Segment s;
  s.a = from;
  s.b = to;
  return s;
}

Segment Segment::arc(Vec2 arc_centre, double arc_radius, double from_angle, double turn) {
  Segment s;
  s.centre = arc_centre;
  s.radius = arc_radius;
  s.start_angle = from_angle;
  s.sweep = turn;
  s.a = arc_centre + arc_radius * unit(from_angle);
  s.b = arc_centre + arc_radius * unit(from_angle + turn);
  return s;
}

Segment Segment::from_bulge(Vec2 from, Vec2 to, double bulge) {
  Segment s = line(from, to);
  const Vec2 chord = to - from;
  const double chord_length = norm(chord);
  if (std::abs(bulge) < kStraightBulge || std::abs(bulge) * chord_length < 2 * kStraightSagitta)
    return s;
  s.sweep = 4 * std::atan(bulge);
  s.centre = 0.5 * (from + to) + left_normal(chord) * ((1 - bulge * bulge) / (4 * bulge));
  s.radius = chord_length * (1 + bulge * bulge) / (4 * std::abs(bulge));
  s.start_angle = angle_of(from - s.centre);
  return s;
}

double Segment::length() const { return is_arc() ? radius * std::abs(sweep) : distance(a, b); }

double Segment::curvature() const {
  if (!is_arc()) return 0;
  return sweep > 0 ? 1 / radius : -1 / radius;
}

double Segment::bulge() const { return is_arc() ? std::tan(sweep / 4) : 0.0; }

Vec2 Segment::point(double t) const {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return is_arc() ? centre + radius * unit(start_angle + t * sweep) : a + t * (b - a);
}

Vec2 Segment::tangent(double t) const {
  if (is_arc()) {
    const Vec2 outward = unit(start_angle + t * sweep);
    return sweep > 0 ? left_normal(outward) : -left_normal(outward);
  }
  return a == b ? Vec2{1, 0} : normalized(b - a);
}

Segment Segment::reversed() const {
  Segment s = *this;
  std::swap(s.a, s.b);
  s.start_angle = start_angle + sweep;
  s.sweep = -sweep;
  return s;
}

Segment Segment::part(double t0, double t1) const {
  Segment s = *this;
  s.a = point(t0);
  s.b = point(t1);
  s.start_angle = start_angle + t0 * sweep;
  s.sweep = (t1 - t0) * sweep;
  return s;
}

double Segment::nearest(Vec2 q) const {
  if (!is_arc()) {
    const Vec2 along = b - a;
    const double squared_length = squared_norm(along);
    if (squared_length == 0) return 0;
    return std::clamp(dot(q - a, along) / squared_length, 0.0, 1.0);
  }
  const double turned = turned_from(start_angle, angle_of(q - centre), sweep);
  if (turned <= std::abs(sweep)) return turned / std::abs(sweep);
  return squared_norm(q - a) <= squared_norm(q - b) ? 0.0 : 1.0;
}

double Segment::distance_to(Vec2 q) const { return distance(q, point(nearest(q))); }

Bounds Segment::bounds() const {
  Bounds box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  if (!is_arc()) return box;
  const auto passes = [this](double angle) {
    return turned_from(start_angle, angle, sweep) <= std::abs(sweep);
  };
  if (passes(0)) box.high.x = std::max(box.high.x, centre.x + radius);
  if (passes(kPi / 2)) box.high.y = std::max(box.high.y, centre.y + radius);
  if (passes(kPi)) box.low.x = std::min(box.low.x, centre.x - radius);
  if (passes(-kPi / 2)) box.low.y = std::min(box.low.y, centre.y - radius);
  return box;
}

Segment Curve::segment(std::size_t i) const {
  const Vertex& from = vertices_[i];
  const Vertex& to = vertices_[i + 1 < vertices_.size() ? i + 1 : 0];
  Segment s = Segment::from_bulge(from.p, to.p, from.bulge);
  s.open = from.open;
  return s;
}

std::vector<Segment> Curve::segments() const {
  std::vector<Segment> all;
  all.reserve(segment_count());
  for (std::size_t i = 0; i < segment_count(); ++i) all.push_back(segment(i));
  return all;
}

double Curve::length() const {
  double sum = 0;
  for (std::size_t i = 0; i < segment_count(); ++i) sum += segment(i).length();
  return sum;
}

double Curve::signed_area() const {
  double sum = 0;
  for (std::size_t i = 0; i < segment_count(); ++i) {
    const Segment s = segment(i);
    const Vec2 origin =
        vertices_[0].p;  // near the curve: far from zero the products would lose digits
    sum += 0.5 * cross(s.a - origin, s.b - origin);
    if (s.is_arc()) sum += 0.5 * s.radius * s.radius * (s.sweep - std::sin(s.sweep));
  }
  return sum;
}

bool Curve::contains(Vec2 q) const {
  int winding = 0;
  for (std::size_t i = 0; i < segment_count(); ++i) winding += winding_of(segment(i), q);
  return winding != 0;
}

Curve Curve::reversed() const {
  const std::size_t n = vertices_.size();
  std::vector<Vertex> turned(n);
  for (std::size_t i = 0; i < n; ++i) {
    // The piece that starts at the new vertex i ran, in the old order, from the vertex before the
    // one it stands on.
    const std::size_t here = n - 1 - i;
    const Vertex& piece = vertices_[(here + n - 1) % n];
    turned[i] = {vertices_[here].p, -piece.bulge, piece.open};
  }
  if (!closed_ && n > 0) turned[n - 1].bulge = 0;
  return Curve(std::move(turned), closed_);
}

std::vector<Vec2> Curve::flattened(double tolerance) const {
  if (!(tolerance > 0)) throw std::invalid_argument("The flattening tolerance must be above 0.");
  std::vector<Vec2> points;
  if (vertices_.size() == 1) points.push_back(vertices_[0].p);
  for (std::size_t i = 0; i < segment_count(); ++i) {
    const Segment s = segment(i);
    points.push_back(s.a);
    if (!s.is_arc()) continue;
    const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / s.radius));
    const auto count = static_cast<std::size_t>(std::ceil(std::abs(s.sweep) / step));
    for (std::size_t k = 1; k < count; ++k)
      points.push_back(s.point(static_cast<double>(k) / static_cast<double>(count)));
  }
  if (!closed_ && segment_count() > 0) points.push_back(vertices_.back().p);
  return points;
}

}  // namespace evenload
