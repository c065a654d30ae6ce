#include "strategy/places/area.h"

#include <algorithm>
#include <limits>

#include "support/tolerances.h"

namespace evenload {
namespace {

std::vector<Curve> curves_of(const std::vector<Region>& regions) {
  std::vector<Curve> curves;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves()) curves.push_back(curve);
  return curves;
}

double inward_curvature_of(const std::vector<Segment>& chain) {
  double most = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Segment &piece = chain[i], &next = chain[(i + 1) % chain.size()];
    if (cross(piece.tangent(1), next.tangent(0)) < -kSameDirection)
      return std::numeric_limits<double>::infinity();
    most = std::max(most, -piece.curvature());
  }
  return most;
}

}  // namespace

Area::Area(const std::vector<Region>& regions) : curves_(curves_of(regions)), index_(curves_) {
  for (const Curve& curve : curves_) {
    segments_.push_back(curve.segments());
    inward_curvature_ = std::max(inward_curvature_, inward_curvature_of(segments_.back()));
  }
}

double Area::signed_distance(Vec2 q) const { return signed_distance(q, index_.nearest(q)); }

double Area::signed_distance(Vec2 q, const BoundaryIndex::Hit& hit) const {
  const std::vector<Segment>& chain = segments_[hit.curve];
  const std::size_t n = chain.size();
  const Vec2 v = q - hit.point;
  bool inside = cross(chain[hit.segment].tangent(hit.t), v) >= 0;
  // At a corner the two pieces may disagree: at a corner that sticks out both must say inside, at
  // one that sticks in one is enough.
  const bool at_start = hit.t<kRounding, at_end = hit.t> 1 - kRounding;
  if (at_start || at_end) {
    const Segment& before = at_start ? chain[(hit.segment + n - 1) % n] : chain[hit.segment];
    const Segment& after = at_start ? chain[hit.segment] : chain[(hit.segment + 1) % n];
    const Vec2 in = before.tangent(1), out = after.tangent(0);
    const bool left_of_in = cross(in, v) >= 0, left_of_out = cross(out, v) >= 0;
    inside = cross(in, out) >= 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }
  return inside ? hit.distance : -hit.distance;
}

}  // namespace evenload
