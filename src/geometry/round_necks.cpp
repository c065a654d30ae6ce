#include "geometry/round_necks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace evenload {
namespace {

// Of the disc's radius; how often it is halved.
constexpr double kFirstShare = 0.5;
constexpr int kHalvings = 4;
constexpr double kSameRadius = 1e-6;  // mm

bool is_of_disc(const Segment& s, double radius) {
  return s.sweep > 0 && std::abs(s.radius - radius) < kSameRadius;
}

double turn_between(const Segment& a, const Segment& b) {
  const Vec2 from = a.tangent(1), to = b.tangent(0);
  return std::atan2(cross(from, to), dot(from, to));
}

struct Rounding {
  Segment before, arc, after;
};

// The arc that touches both, which turn left, from outside, and what is left of them.
std::optional<Rounding> rounded(const Segment& before, const Segment& after, double radius) {
  const Vec2 apart = after.centre - before.centre, middle = 0.5 * (before.centre + after.centre);
  const double to_centre = before.radius + radius;
  const double height = std::sqrt(to_centre * to_centre - 0.25 * squared_norm(apart));
  // Who travels counter-clockwise has the outside on the right.
  const Vec2 centre = middle - height * left_normal(normalized(apart));
  const double until = wrap_positive(angle_of(centre - before.centre) - before.start_angle);
  const double from = wrap_positive(angle_of(centre - after.centre) - after.start_angle);
  if (!(until > 0 && until < before.sweep && from > 0 && from < after.sweep)) return std::nullopt;
  const double start = angle_of(before.centre - centre);
  const double sweep = wrap_signed(angle_of(after.centre - centre) - start);
  if (sweep >= 0) return std::nullopt;
  return Rounding{before.part(0, until / before.sweep), Segment::arc(centre, radius, start, sweep),
                  after.part(from / after.sweep, 1)};
}

using IsAllowed = std::function<bool(const Segment&)>;

std::optional<Rounding> rounded(const Segment& before, const Segment& after,
                                const IsAllowed& may_be_border) {
  double radius = kFirstShare * before.radius;
  for (int i = 0; i <= kHalvings; ++i, radius *= 0.5) {
    std::optional<Rounding> found = rounded(before, after, radius);
    if (found && may_be_border(found->arc)) return found;
  }
  return std::nullopt;
}

// mm from corner to corner of the neck, halved: where the circles about both places cross.
double half_width(const Segment& before, const Segment& after) {
  const double to_middle = 0.5 * distance(before.centre, after.centre);
  return std::sqrt(std::max(0.0, before.radius * before.radius - to_middle * to_middle));
}

Curve with_round_necks(const Curve& curve, double radius, double narrowest,
                       const IsAllowed& may_be_border) {
  const std::vector<Segment> pieces = curve.segments();
  std::vector<Segment> result;
  const auto round_into = [&](Segment& next) {
    const Segment& last = result.back();
    if (!is_of_disc(last, radius) || !is_of_disc(next, radius)) return;
    if (turn_between(last, next) > -kNeckCorner || half_width(last, next) < narrowest) return;
    if (const std::optional<Rounding> found = rounded(last, next, may_be_border)) {
      result.back() = found->before;
      result.push_back(found->arc);
      next = found->after;
    }
  };
  for (Segment piece : pieces) {
    if (!result.empty()) round_into(piece);
    result.push_back(piece);
  }
  Segment first = result.front();
  round_into(first);
  result.front() = first;
  if (result.size() == pieces.size()) return curve;
  std::vector<Vertex> vertices;
  vertices.reserve(result.size());
  for (const Segment& s : result) vertices.push_back({s.a, s.bulge(), s.open});
  return Curve(std::move(vertices), true);
}

}  // namespace

std::vector<Region> with_round_necks(const std::vector<Region>& opened, double radius,
                                     double narrowest, const IsAllowed& may_be_border) {
  std::vector<Region> result;
  for (const Region& region : opened) {
    result.push_back({with_round_necks(region.outer, radius, narrowest, may_be_border), {}});
    for (const Curve& island : region.islands)
      result.back().islands.push_back(with_round_necks(island, radius, narrowest, may_be_border));
  }
  return result;
}

}  // namespace evenload
