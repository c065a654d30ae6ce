#include "cutting/swept_move.h"

#include <algorithm>
#include <array>
#include <utility>

namespace evenload {
namespace {

// mm^2: circles so near to each other's centre have no crossings that could be told.
constexpr double kSameCentre = 1e-24;

// A place where the border of a swept area crosses the circle: unit vector from the circle's
// centre.
struct Crossing {
  Vec2 direction;
  double angle = 0;
};

// A few arise per move at most: four circles or two circles and two lines, two crossings each.
struct Crossings {
  std::array<Crossing, 8> at;
  int count = 0;
  void push(Vec2 direction) { at[static_cast<std::size_t>(count++)].direction = direction; }
};

// Removes [low, high] from the ordered set.
void cut(std::vector<AngularInterval>& set, double low, double high) {
  std::size_t keep = 0;
  const std::size_t n = set.size();
  AngularInterval extra;
  bool has_extra = false;
  std::size_t extra_at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const AngularInterval piece = set[i];
    if (high <= piece.low || low >= piece.high) {
      set[keep++] = piece;
    } else {
      const bool left = low > piece.low, right = high < piece.high;
      if (left) set[keep++] = {piece.low, low};
      if (right) {
        if (left) {
          extra = {high, piece.high};
          extra_at = keep;
          has_extra = true;
          for (std::size_t j = i + 1; j < n; ++j) set[keep++] = set[j];
          break;
        }
        set[keep++] = {high, piece.high};
      }
    }
  }
  set.resize(keep);
  if (has_extra) set.insert(set.begin() + static_cast<std::ptrdiff_t>(extra_at), extra);
}

// The middle of the arc that runs counter-clockwise from unit vector `from` to unit vector `to`.
Vec2 between(Vec2 from, Vec2 to) {
  const Vec2 chord = to - from;
  const double length = norm(chord);
  return length > 1e-12 ? Vec2{chord.y / length, -chord.x / length} : from;
}

}  // namespace

void cut_wrapped(std::vector<AngularInterval>& set, double base, double low, double high) {
  const double width = high - low;
  const double start = base + wrap_positive(low - base);
  cut(set, start, start + width);
  if (start + width > base + 2 * kPi) cut(set, start - 2 * kPi, start - 2 * kPi + width);
}

SweptMove::SweptMove(const Segment& move, double swept_radius)
    : segment_(move), swept_radius_(swept_radius) {
  if (move.is_arc()) {
    const Vec2 start = (move.a - move.centre) / move.radius,
               end = (move.b - move.centre) / move.radius;
    first_ = move.sweep > 0 ? start : end;
    last_ = move.sweep > 0 ? end : start;
    reflex_ = std::abs(move.sweep) > kPi;
  } else {
    length_ = evenload::distance(move.a, move.b);
    direction_ = length_ > 0 ? (move.b - move.a) / length_ : Vec2{1, 0};
  }
}

Vec2 SweptMove::nearest(Vec2 x) const {
  const Segment& s = segment_;
  if (!s.is_arc()) return s.a + std::clamp(dot(x - s.a, direction_), 0.0, length_) * direction_;
  const Vec2 v = x - s.centre;
  const double d = norm(v);
  if (is_beside(v, 0) && d > 0) return s.centre + (s.radius / d) * v;
  return squared_norm(x - s.a) < squared_norm(x - s.b) ? s.a : s.b;
}

BorderView SweptMove::seen_from(Vec2 x) const {
  const Segment& s = segment_;
  const Vec2 foot = nearest(x);
  BorderView view;
  view.distance = evenload::distance(foot, x);
  view.beyond = view.distance - swept_radius_;
  view.away = view.distance > 0 ? (x - foot) / view.distance : Vec2{1, 0};
  if (!s.is_arc() && view.distance > 0) return view;
  view.bulge = std::max(dot(s.a - foot, view.away), dot(s.b - foot, view.away));
  if (s.is_arc() && is_beside(view.away, 0))
    view.bulge = std::max(view.bulge, dot(s.centre - foot, view.away) + s.radius);
  return view;
}

bool SweptMove::subtract(const CircleLook& look, std::vector<AngularInterval>& set) const {
  const Vec2 p = look.p;
  const double radius = look.radius;
  const Segment& s = segment_;
  const double reach = swept_radius_;
  // The border consists of circles about the ends, where an end is the nearest point of the move,
  // and of lines or circles beside it elsewhere. Crossings with the parts that are not border are
  // dropped.
  Crossings crossings;
  const auto cross_circle = [&](Vec2 centre, double r, const auto& on_border) {
    const Vec2 v = centre - p;
    const double square = squared_norm(v), sum = radius + r, difference = radius - r;
    if (square >= sum * sum || square <= difference * difference || square < kSameCentre) return;
    const double d = std::sqrt(square);
    const double c = (d * d + radius * radius - r * r) / (2 * d * radius);
    if (c <= -1 || c >= 1) return;
    const double h = std::sqrt(1 - c * c);
    const Vec2 towards = v / d, aside = left_normal(towards);
    for (const Vec2 to : {c * towards - h * aside, c * towards + h * aside})
      if (on_border(p + radius * to)) crossings.push(to);
  };
  constexpr double kJoint = 1e-9;  // mm: about the joints of the border's parts both count
  if (s.is_arc()) {
    const auto beside = [&](Vec2 x, double margin) { return is_beside(x - s.centre, margin); };
    const auto along = [&](Vec2 x) { return beside(x, kJoint); };
    cross_circle(s.centre, s.radius + reach, along);
    if (s.radius > reach) cross_circle(s.centre, s.radius - reach, along);
    const auto at_end = [&](Vec2 x, Vec2 end, Vec2 other) {
      return !beside(x, -kJoint) && squared_norm(x - end) <= squared_norm(x - other) + kJoint;
    };
    cross_circle(s.a, reach, [&](Vec2 x) { return at_end(x, s.a, s.b); });
    cross_circle(s.b, reach, [&](Vec2 x) { return at_end(x, s.b, s.a); });
  } else if (length_ > 0) {
    const auto along = [&](Vec2 x) { return dot(x - s.a, direction_); };
    cross_circle(s.a, reach, [&](Vec2 x) { return along(x) <= kJoint; });
    cross_circle(s.b, reach, [&](Vec2 x) { return along(x) >= length_ - kJoint; });
    const double aside = cross(direction_, p - s.a);
    const Vec2 normal = left_normal(direction_);
    for (const double side : {reach, -reach}) {
      const double v = (side - aside) / radius;
      if (v <= -1 || v >= 1) continue;
      const double h = std::sqrt(1 - v * v);
      for (const Vec2 to : {v * normal + h * direction_, v * normal - h * direction_}) {
        const double t = along(p + radius * to);
        if (t >= -kJoint && t <= length_ + kJoint) crossings.push(to);
      }
    }
  } else {
    cross_circle(s.a, reach, [](Vec2) { return true; });
  }
  const int count = crossings.count;
  if (count == 0) {
    if (distance(p + Vec2{radius, 0}) > reach) return false;
    set.clear();
    return true;
  }
  for (int i = 0; i < count; ++i)
    crossings.at[static_cast<std::size_t>(i)].angle =
        wrap_positive(angle_of(crossings.at[static_cast<std::size_t>(i)].direction));
  // At most eight: sorted by insertion.
  for (std::size_t i = 1; i < static_cast<std::size_t>(count); ++i)
    for (std::size_t k = i; k > 0 && crossings.at[k].angle < crossings.at[k - 1].angle; --k)
      std::swap(crossings.at[k], crossings.at[k - 1]);
  bool covers = false;
  for (int i = 0; i < count; ++i) {
    const Crossing& from = crossings.at[static_cast<std::size_t>(i)];
    const Crossing& to = crossings.at[static_cast<std::size_t>((i + 1) % count)];
    const double high = i + 1 < count ? to.angle : to.angle + 2 * kPi;
    if (high - from.angle < 1e-12) continue;
    const Vec2 middle = count > 1 ? between(from.direction, to.direction) : -from.direction;
    if (distance(p + radius * middle) > reach) continue;
    cut_wrapped(set, look.base, from.angle, high);
    covers = true;
  }
  return covers;
}

}  // namespace evenload
