#include "surface/facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace evenload {

namespace {

constexpr std::uint32_t kMostInLeaf = 4;
// mm: coordinates that differ by less are one point's. Rounding at 1e4 mm is ten times finer.
constexpr double kWelded = 1e-7;
constexpr double kNoArea = 1e-12;   // mm^2
constexpr double kNoHeight = 1e-9;  // mm over a triangle's longest side
// mm by which a corner must lie below its neighbour's plane for the ground to fall away there; the
// tool would be lower by less if the edge were left out.
constexpr double kInPlane = 1e-9;

struct SharedEdge {
  std::uint32_t from, to;  // welded points, from < to
  std::uint32_t facet;
  std::uint32_t side;
};

// For each point the first one at its place.
std::vector<std::uint32_t> welded(const std::vector<SpacePoint>& points) {
  const auto key = [&](std::uint32_t i) {
    return std::array<double, 3>{std::round(points[i].x / kWelded),
                                 std::round(points[i].y / kWelded),
                                 std::round(points[i].z / kWelded)};
  };
  std::vector<std::uint32_t> order(points.size()), result(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto ka = key(a), kb = key(b);
    return ka != kb ? ka < kb : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && key(order[i]) == key(order[i - 1]);
    result[order[i]] = is_same ? result[order[i - 1]] : order[i];
  }
  return result;
}

// The corner of a facet that is not an end of its edge.
SpacePoint opposite(const Facet& facet, std::uint32_t side) {
  return facet.corners[(side + 2) % 3];
}

// Whether a tool from above can touch the edge between two facets without touching either.
bool falls_away(const Facet& a, std::uint32_t side, const Facet& b, std::uint32_t side_of_b) {
  if (a.normal.z < kUpright || b.normal.z < kUpright) return true;
  const SpacePoint from = a.corners[side], beyond = opposite(b, side_of_b);
  const Vec2 along = plan(a.corners[(side + 1) % 3] - from);
  const double side_of_mine = cross(along, plan(opposite(a, side) - from));
  const double side_of_other = cross(along, plan(beyond - from));
  if (side_of_mine * side_of_other >= 0) return true;  // the ground folds back
  return dot(a.normal, beyond - from) < -kInPlane;
}

// Returns for each point whether it lies on the border of what is picked.
std::vector<bool> mark_edges(std::vector<Facet>& facets, std::vector<SharedEdge> edges,
                             std::size_t points) {
  std::vector<bool> is_on_border(points, false);
  std::sort(edges.begin(), edges.end(), [](const SharedEdge& a, const SharedEdge& b) {
    return std::array{a.from, a.to, a.facet} < std::array{b.from, b.to, b.facet};
  });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].from == edges[i].from && edges[end].to == edges[i].to)
      ++end;
    Facet& first = facets[edges[i].facet];
    const std::uint32_t side = edges[i].side;
    first.is_touchable[side] = true;
    if (end == i + 2) {
      Facet& second = facets[edges[i + 1].facet];
      first.is_touchable[side] = falls_away(first, side, second, edges[i + 1].side);
      first.is_within[side] = first.is_picked && second.is_picked;
    }
    if (!first.is_within[side]) is_on_border[edges[i].from] = is_on_border[edges[i].to] = true;
    i = end;
  }
  return is_on_border;
}

bool is_finite(SpacePoint p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

FacetMesh::FacetMesh(const std::vector<SpacePoint>& points, const std::vector<Triangle>& triangles,
                     const std::vector<bool>& picked) {
  if (picked.size() != triangles.size())
    throw std::invalid_argument("For each triangle it must be said whether it is picked.");
  for (const SpacePoint& p : points)
    if (!is_finite(p)) throw std::invalid_argument("A triangle's coordinate is not finite.");
  const std::vector<std::uint32_t> same = welded(points);
  std::vector<SharedEdge> edges;
  std::vector<Triangle> corners_of;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle corners = triangles[t];
    for (const std::uint32_t k : corners)
      if (k >= points.size())
        throw std::invalid_argument("A triangle names a point that is not there.");
    const auto at = [&](int k) { return points[corners[static_cast<std::size_t>(k)]]; };
    SpacePoint normal = cross(at(1) - at(0), at(2) - at(0));
    const double area = norm(normal);
    const double longest =
        std::max({norm(at(1) - at(0)), norm(at(2) - at(1)), norm(at(0) - at(2))});
    // Three points on a line span an area by rounding alone, with a normal that means nothing.
    if (!(area > kNoArea && area > kNoHeight * longest)) continue;
    if (normal.z < 0) {
      std::swap(corners[1], corners[2]);
      normal = -1.0 * normal;
    }
    normal = (1 / area) * normal;
    if (normal.z < kUpright) normal.z = 0;
    const auto number = static_cast<std::uint32_t>(facets_.size());
    facets_.push_back(
        {{at(0), at(1), at(2)}, normal, std::max({at(0).z, at(1).z, at(2).z}), picked[t], {}, {}});
    corners_of.push_back({same[corners[0]], same[corners[1]], same[corners[2]]});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = same[corners[k]], b = same[corners[(k + 1) % 3]];
      edges.push_back({std::min(a, b), std::max(a, b), number, k});
    }
  }
  const std::vector<bool> is_on_border = mark_edges(facets_, std::move(edges), points.size());
  for (std::size_t i = 0; i < facets_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      facets_[i].is_corner_within[k] = !is_on_border[corners_of[i][k]];
  if (!facets_.empty()) build(0, static_cast<std::uint32_t>(facets_.size()));
}

void FacetMesh::build(std::uint32_t from, std::uint32_t to) {
  const std::size_t mine = nodes_.size();
  FacetNode node{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, from, to - from};
  for (std::uint32_t i = from; i < to; ++i) {
    for (const SpacePoint& p : facets_[i].corners) {
      node.x0 = std::min(node.x0, p.x);
      node.x1 = std::max(node.x1, p.x);
      node.y0 = std::min(node.y0, p.y);
      node.y1 = std::max(node.y1, p.y);
    }
    node.top = std::max(node.top, facets_[i].top);
  }
  nodes_.push_back(node);
  if (node.count <= kMostInLeaf) return;
  const bool along_x = node.x1 - node.x0 >= node.y1 - node.y0;
  const auto centre = [along_x](const Facet& f) {
    return along_x ? f.corners[0].x + f.corners[1].x + f.corners[2].x
                   : f.corners[0].y + f.corners[1].y + f.corners[2].y;
  };
  // A stable sort: the same tree wherever it is built.
  const auto begin = facets_.begin() + from;
  std::stable_sort(begin, facets_.begin() + to,
                   [&](const Facet& a, const Facet& b) { return centre(a) < centre(b); });
  const std::uint32_t middle = from + node.count / 2;
  nodes_[mine].count = 0;
  build(from, middle);
  nodes_[mine].first = static_cast<std::uint32_t>(nodes_.size());
  build(middle, to);
}

}  // namespace evenload
