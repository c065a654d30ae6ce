#include "strategy/reach/free_place.h"

#include <algorithm>
#include <cmath>

#include "strategy/reach/links.h"

namespace evenload {
namespace {

// Shares of the turn radius wished for that are tried.
constexpr double kShares[] = {1, 0.5, 0.25};

}  // namespace

bool is_free_disc(const ClearedGround& ground, const std::vector<Region>& stock, Vec2 p) {
  const double radius = ground.tool_radius();
  for (int k = 0; k < kRings; ++k)
    if (!ground.is_clear(p, std::max(kCoverTolerance, radius * k / kRings))) return false;
  for (const Region& region : stock)
    for (const Curve& curve : region.curves())
      for (const Vertex& v : curve.vertices())
        if (distance(v.p, p) < radius - kCoverTolerance && !ground.is_cleared_since(v.p, 0))
          return false;
  return true;
}

std::optional<Segment> way_from_beside(const ClearedGround& ground,
                                       const std::vector<Region>& stock, const Area& centres,
                                       const Pose& to, double turn_radius) {
  for (const double share : kShares) {
    const double radius = share * turn_radius;
    const Vec2 centre = to.p + radius * left_normal(unit(to.heading));
    const Segment way = Segment::arc(centre, radius, to.heading - kPi, kPi / 2);
    if (is_free_disc(ground, stock, way.a) &&
        is_free({ground, ground.size()}, centres, {way}, way.length()))
      return way;
  }
  return std::nullopt;
}

bool has_free_place(const ClearedGround& ground, const std::vector<Region>& stock,
                    const Region& centres) {
  const Bounds box = bounds_of({centres});
  const double step = kLook * ground.tool_radius();
  for (double y = box.low.y; y <= box.high.y + step; y += step)
    for (double x = box.low.x; x <= box.high.x + step; x += step)
      if (centres.contains({x, y}) && is_free_disc(ground, stock, {x, y})) return true;
  return false;
}

}  // namespace evenload
