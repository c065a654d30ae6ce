#include "simulate/part_gauge.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace evenload {
namespace {

// mm: a tip this near to a top stands on it.
constexpr double kOnTop = 1e-6;

// mm: regions nearer than twice this are one; no tool fits between.
constexpr double kUniting = 0.005;

// The parameter of an arc at an angle, or a value outside of [0, 1].
double parameter_at(const Segment& arc, double angle) {
  const double turned = arc.sweep > 0 ? wrap_positive(angle - arc.start_angle)
                                      : -wrap_positive(arc.start_angle - angle);
  return turned / arc.sweep;
}

// Regions that touch or overlap as one, so that no border runs inside.
std::vector<Region> united(const std::vector<Region>& regions) {
  if (regions.size() < 2) return regions;
  return offset(offset(regions, kUniting), -kUniting);
}

}  // namespace

PartGauge::PartGauge(const std::vector<Prism>& part, double tool_radius, double stock_top)
    : radius_(tool_radius), stock_top_(stock_top) {
  std::map<double, std::vector<Region>> by_top;
  std::vector<Region> all;
  for (const Prism& prism : part) {
    by_top[prism.top].push_back(prism.region);
    all.push_back(prism.region);
  }
  box_ = bounds_of(all);
  for (const auto& [top, regions] : by_top) {
    std::vector<Curve> curves;
    std::vector<Segment> edges;
    std::vector<Bounds> boxes;
    for (const Region& region : united(regions)) {
      for (const Curve& curve : region.curves()) {
        curves.push_back(curve);
        for (const Segment& edge : curve.segments()) {
          edges.push_back(edge);
          boxes.push_back(edge.bounds());
        }
      }
    }
    levels_.push_back({top, BoundaryIndex(curves), std::move(edges), BoxTree(boxes)});
  }
}

double PartGauge::depth(Vec2 p, double z) const {
  double deepest = 0;
  for (const Level& level : levels_) {
    const double below = level.top - z;
    if (below <= kOnTop) continue;
    const double distance = level.index.distance_below(p, radius_);
    double sideways = radius_ - distance;
    if (level.index.contains(p)) sideways = radius_ + level.index.nearest(p).distance;
    const bool is_wall = level.top >= stock_top_ - kOnTop;
    deepest = std::max(deepest, is_wall ? sideways : std::min(sideways, below));
  }
  return deepest;
}

// The distance between two pieces is least at an end of either or on a common normal.
template <typename Visit>
void PartGauge::visit_nearest(const Segment& path, const Segment& edge, Visit visit) {
  visit(path.nearest(edge.a));  // its other end is the next edge's
  if (edge.is_arc()) {
    if (!path.is_arc()) {
      visit(path.nearest(edge.centre));
    } else if (edge.centre != path.centre) {
      const double angle = angle_of(edge.centre - path.centre);
      visit(parameter_at(path, angle));
      visit(parameter_at(path, angle + kPi));
    }
  } else if (path.is_arc()) {
    const double normal = angle_of(left_normal(edge.b - edge.a));
    visit(parameter_at(path, normal));
    visit(parameter_at(path, normal + kPi));
  }
}

Gouge PartGauge::deepest(const Segment& path, double z0, double z1, double step) const {
  Gouge worst;
  const Bounds near = grown(path.bounds(), radius_);
  if (levels_.empty() || std::min(z0, z1) >= levels_.back().top - kOnTop || !overlap(near, box_))
    return worst;
  const auto look = [&](double t) {
    if (!(t >= 0 && t <= 1)) return;
    const double found = depth(path.point(t), z0 + t * (z1 - z0));
    if (found > worst.depth) worst = {found, t};
  };
  const int pieces = std::max(1, static_cast<int>(std::ceil(path.length() / step)));
  for (int k = 0; k <= pieces; ++k) look(static_cast<double>(k) / pieces);
  if (!(path.length() > 0)) return worst;
  for (const Level& level : levels_) {
    if (level.top - std::min(z0, z1) <= kOnTop) continue;
    level.tree.visit(near,
                     [&](std::uint32_t edge) { visit_nearest(path, level.edges[edge], look); });
  }
  return worst;
}

}  // namespace evenload
