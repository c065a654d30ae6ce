#include "strategy/corner_wall.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/intersect.h"

namespace evenload {
namespace {

// Of the wall's own radius, what may be cleared at the most; and to which that is found.
constexpr double kWidestCleared = 5;
constexpr double kExactRadius = 1e-4;
// A tighter arc than this share of the cleared one is no progress worth a pass.
constexpr double kLeastProgress = 0.9995;
// Of the way from the corner to where what is cleared leaves the walls: so far the walls must lead.
constexpr double kAlongWalls = 1.05;
constexpr double kFurthest = 3;
constexpr double kTangent = 1e-3;  // rad
// Walls that are arcs: the least of their radii, in radii of what is cleared, and rad of them that
// count, so that they are nearly straight there.
constexpr double kFlat = 4;
constexpr double kMostBend = 0.5;
constexpr double kShareOfBend = 0.8;  // of what a blunt corner's chord allows
// mm: by which a wall may be too short for an arc to touch it.
constexpr double kTouching = 1e-9;

// An arc that rounds a corner, and where it touches the walls.
struct Rounding {
  Vec2 centre;
  double in = 0, out = 0;  // parameters on the walls
};

// A corner between two walls, which an arc rounds so far.
struct Corner {
  Segment in, out;    // the walls that lead to the arc, and on from there
  double half = 0;    // rad: half its angle
  double radius = 0;  // mm, of the arc

  // mm from the tip to where an arc leaves the walls.
  double along(double arc) const { return arc / std::tan(half); }
  Vec2 tip() const { return in.b + along(radius) * in.tangent(1); }
  // mm from the tip along the shorter wall, but no more than are nearly straight: so far the chord
  // between their ends meets neither.
  double length() const {
    double least = std::min(in.length(), out.length());
    const double bend = std::min(kMostBend, kShareOfBend * (0.5 * kPi - half));
    for (const Segment& wall : {in, out})
      if (wall.is_arc()) least = std::min(least, bend * wall.radius);
    return along(radius) + least;
  }
};

Vec2 to_left(const Segment& wall, double t) {
  const Vec2 along = wall.tangent(t);
  return {-along.y, along.x};
}

// The wall moved to its left by `distance` mm, which is less than the radius of one that turns
// left.
Segment moved_left(const Segment& wall, double distance) {
  if (!wall.is_arc())
    return Segment::line(wall.a + distance * to_left(wall, 0),
                         wall.b + distance * to_left(wall, 1));
  return Segment::arc(wall.centre, wall.radius + (wall.sweep > 0 ? -distance : distance),
                      wall.start_angle, wall.sweep);
}

bool is_flat(const Segment& wall, double cleared) {
  return !wall.is_arc() || wall.radius > kFlat * cleared;
}

std::optional<Corner> corner_ahead(const Curve& wall, const WallPlace& start) {
  const std::size_t n = wall.segment_count();
  // The arc is where the start is, or after that.
  for (const std::size_t i : {start.segment, (start.segment + 1) % n}) {
    const Segment arc = wall.segment(i), before = wall.segment((i + n - 1) % n),
                  after = wall.segment((i + 1) % n);
    if (!arc.is_arc() || arc.sweep <= 0 || !is_flat(before, arc.radius) ||
        !is_flat(after, arc.radius))
      continue;
    if (norm(before.tangent(1) - arc.tangent(0)) > kTangent ||
        norm(after.tangent(0) - arc.tangent(1)) > kTangent)
      return std::nullopt;
    const Corner corner{before, after, 0.5 * (kPi - arc.sweep), arc.radius};
    return corner.half > 0 ? std::optional(corner) : std::nullopt;
  }
  return std::nullopt;
}

// The arc of `radius` mm, wider than what rounds the corner now, that touches both walls.
std::optional<Rounding> rounded_by(const Corner& corner, double radius) {
  std::optional<Rounding> nearest;
  for (const Meeting& m :
       meetings(moved_left(corner.in, radius), moved_left(corner.out, radius), kTouching))
    if (!nearest || m.ta > nearest->in) nearest = Rounding{m.p, m.ta, m.tb};
  return nearest;
}

// The place of such an arc next to the corner.
Vec2 next_to_corner(const Corner& corner, const Rounding& rounding, double radius) {
  const Vec2 inward = to_left(corner.in, rounding.in) + to_left(corner.out, rounding.out);
  return rounding.centre - radius * normalized(inward);
}

// mm: the widest arc that is looked for.
double widest_cleared(const Corner& corner) {
  double widest = kWidestCleared * corner.radius;
  for (const Segment& wall : {corner.in, corner.out})
    if (wall.is_arc()) widest = std::min(widest, wall.radius / kFlat);
  return widest;
}

// mm: the radius of the tightest arc in the corner along which the ground is cleared.
std::optional<double> cleared_radius(const Corner& corner, const ClearedGround& ground) {
  // Arcs too wide for the walls count as `beyond`.
  const auto is_clear = [&](double arc, bool beyond) {
    const std::optional<Rounding> rounding = rounded_by(corner, arc);
    return rounding ? ground.is_clear(next_to_corner(corner, *rounding, arc)) : beyond;
  };
  double low = corner.radius, high = widest_cleared(corner);
  if (is_clear(low, false) || !is_clear(high, true)) return std::nullopt;
  while (high - low > kExactRadius * high) {
    const double middle = 0.5 * (low + high);
    (is_clear(middle, true) ? high : low) = middle;
  }
  return high;
}

// rad: by how much an arc that rounds the corner turns.
double turn_of(const Corner& corner, const Rounding& rounding) {
  return wrap_positive(angle_of(corner.out.tangent(rounding.out)) -
                       angle_of(corner.in.tangent(rounding.in)));
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
  const double needed = kAlongWalls * std::max(reach, distance(from, corner->tip()));
  const double length = std::min(corner->length(), std::max(needed, kFurthest * reach));
  if (length < needed) return std::nullopt;
  const std::optional<Rounding> rounding = rounded_by(*corner, radius);
  if (!rounding) return std::nullopt;
  const double straight = length - corner->along(corner->radius);  // mm of both walls
  const double from_in = 1 - straight / corner->in.length(),
               to_out = straight / corner->out.length();
  if (from_in >= rounding->in || rounding->out >= to_out) return std::nullopt;
  const Segment in = corner->in.part(from_in, rounding->in);
  const Segment out = corner->out.part(rounding->out, to_out);
  const double turn = turn_of(*corner, *rounding);
  const Region region = make_region(Curve(
      {{in.a, in.bulge()}, {in.b, std::tan(0.25 * turn)}, {out.a, out.bulge()}, {out.b, 0}}, true));
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
