#include "strategy/corner_wall.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evenload {
namespace {

// Of the wall's own radius, what may be cleared at the most; and to which that is found.
constexpr double kWidestCleared = 2;
constexpr double kExactRadius = 1e-4;
// A tighter arc than this share of the cleared one is no progress worth a pass.
constexpr double kLeastProgress = 0.9995;
// Of the way from the corner to where what is cleared leaves the walls: so far the walls must lead.
constexpr double kAlongWalls = 1.05;
constexpr double kFurthest = 3;
constexpr double kTangent = 1e-3;  // rad

// A corner between two straight walls, the first of which leads to it.
struct Corner {
  Vec2 tip, in, out;             // directions of travel along the walls
  double half = 0;               // rad: half its angle
  double radius = 0;             // mm, of the arc that rounds it
  double before = 0, after = 0;  // mm of straight wall to the tip, and from there

  Vec2 bisector() const { return normalized(out - in); }
  // mm from the tip to where an arc leaves the walls.
  double along(double arc) const { return arc / std::tan(half); }
  Vec2 nearest(double arc) const { return tip + (arc / std::sin(half) - arc) * bisector(); }
};

std::optional<Corner> corner_ahead(const Curve& wall, const WallPlace& start) {
  const std::size_t n = wall.segment_count();
  std::size_t i = start.segment;
  if (!wall.segment(i).is_arc()) i = (i + 1) % n;
  const Segment arc = wall.segment(i), before = wall.segment((i + n - 1) % n),
                after = wall.segment((i + 1) % n);
  if (!arc.is_arc() || arc.sweep <= 0 || before.is_arc() || after.is_arc()) return std::nullopt;
  if (norm(before.tangent(1) - arc.tangent(0)) > kTangent ||
      norm(after.tangent(0) - arc.tangent(1)) > kTangent)
    return std::nullopt;
  Corner corner;
  corner.in = before.tangent(1);
  corner.out = after.tangent(0);
  corner.half = 0.5 * (kPi - arc.sweep);
  corner.radius = arc.radius;
  if (corner.half <= 0) return std::nullopt;
  const double along = corner.along(arc.radius);
  corner.tip = arc.a + along * corner.in;
  corner.before = along + before.length();
  corner.after = along + after.length();
  return corner;
}

// mm: the radius of the tightest arc in the corner along which the ground is cleared.
std::optional<double> cleared_radius(const Corner& corner, const ClearedGround& ground) {
  const auto is_clear = [&](double arc) { return ground.is_clear(corner.nearest(arc)); };
  double low = corner.radius, high = kWidestCleared * corner.radius;
  if (is_clear(low) || !is_clear(high)) return std::nullopt;
  while (high - low > kExactRadius * high) {
    const double middle = 0.5 * (low + high);
    (is_clear(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::optional<CornerWall> corner_wall(const Stage& stage, const WallPlace& start,
                                      const ClearedGround& ground, double engagement) {
  const Curve& wall = stage.centres.curves()[start.curve];
  const std::optional<Corner> corner = corner_ahead(wall, start);
  if (!corner) return std::nullopt;
  const std::optional<double> cleared = cleared_radius(*corner, ground);
  if (!cleared) return std::nullopt;
  const double radius = held_ratio(corner->half, engagement) * *cleared;
  if (radius <= corner->radius || radius > kLeastProgress * *cleared) return std::nullopt;
  const Vec2 from = wall.segment(start.segment).point(start.t);
  const double reach = corner->along(*cleared);
  const double length = std::min({corner->before, corner->after, kFurthest * reach});
  if (length < kAlongWalls * std::max(reach, distance(from, corner->tip))) return std::nullopt;
  const double along = corner->along(radius);
  const Region region = make_region(
      Curve({{corner->tip - length * corner->in, 0},
             {corner->tip - along * corner->in, std::tan(0.25 * (kPi - 2 * corner->half))},
             {corner->tip + along * corner->out, 0},
             {corner->tip + length * corner->out, 0}},
            true));
  CornerWall result;
  result.stage.turn_radius = radius / kOpeningRatio;
  result.stage.rooms = {region};
  result.stage.centres = Area({region});
  result.stage.turns = Area(offset({region}, -result.stage.turn_radius));
  const BoundaryIndex::Hit hit = result.stage.centres.nearest(from);
  result.start = {hit.curve, hit.segment, hit.t};
  return result;
}

}  // namespace evenload
