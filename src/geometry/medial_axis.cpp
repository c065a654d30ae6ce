#include "geometry/medial_axis.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "geometry/boundary_index.h"
#include "geometry/voronoi.h"

namespace evenload {

namespace {

// Vertices nearer than this share of the tolerance, where an edge joins them, are one node: in the
// middle of a regular shape the diagram has many edges of no length.
constexpr double kContraction = 0.1;
// Flattening moves what a circle touches by the tolerance on either side of it.
constexpr double kSlack = 4;

// Whether the boundary from one site on to the other hugs the circle around p: the two are then one
// place of contact, which only flattening split. A corner on the way makes them two.
bool hugs(const InnerVoronoi::Ring& ring, const InnerVoronoi::Site& from,
          const InnerVoronoi::Site& to, Vec2 p, double reach) {
  const std::size_t n = ring.points.size();
  for (std::size_t i = from.last, walked = 0;; i = i + 1 < n ? i + 1 : 0, ++walked) {
    if (walked > n || ring.corner[i] || distance(ring.points[i], p) > reach) return false;
    if (i == to.first) return true;
  }
}

bool comes_from_flattening(const InnerVoronoi& voronoi, const InnerVoronoi::Edge& edge,
                           const BoundaryIndex& boundary, double slack) {
  if (edge.left.ring != edge.right.ring) return false;
  const InnerVoronoi::Ring& ring = voronoi.rings[edge.left.ring];
  const Vec2 p = 0.5 * (voronoi.vertices[edge.from] + voronoi.vertices[edge.to]);
  const double reach = boundary.nearest(p).distance + slack;
  return hugs(ring, edge.left, edge.right, p, reach) || hugs(ring, edge.right, edge.left, p, reach);
}

// The edges without the branches that only come from flattening. They go from their free ends
// inwards, so that the axis stays in one piece and keeps its way around every island.
std::vector<InnerVoronoi::Edge> without_twigs(const InnerVoronoi& voronoi,
                                              const BoundaryIndex& boundary, double slack) {
  std::vector<std::vector<std::size_t>> at(voronoi.vertices.size());
  for (std::size_t i = 0; i < voronoi.edges.size(); ++i) {
    at[voronoi.edges[i].from].push_back(i);
    at[voronoi.edges[i].to].push_back(i);
  }
  std::vector<std::size_t> ends;
  for (std::size_t v = 0; v < at.size(); ++v)
    if (at[v].size() == 1) ends.push_back(v);
  std::vector<std::uint8_t> gone(voronoi.edges.size(), 0);
  while (!ends.empty()) {
    const std::size_t v = ends.back();
    ends.pop_back();
    if (at[v].size() != 1) continue;
    const std::size_t i = at[v][0];
    const InnerVoronoi::Edge& e = voronoi.edges[i];
    if (!comes_from_flattening(voronoi, e, boundary, slack)) continue;
    gone[i] = 1;
    std::erase(at[e.from], i);
    std::erase(at[e.to], i);
    const std::size_t other = e.from == v ? e.to : e.from;
    if (at[other].size() == 1) ends.push_back(other);
  }
  std::vector<InnerVoronoi::Edge> kept;
  for (std::size_t i = 0; i < voronoi.edges.size(); ++i)
    if (!gone[i]) kept.push_back(voronoi.edges[i]);
  return kept;
}

class Groups {
 public:
  explicit Groups(std::size_t n) : parents_(n) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void merge(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parents_;
};

struct Half {
  std::size_t edge = 0;
  bool forward = true;  // leaves the edge's `from`
};

// Joins edges at vertices where just two meet.
class Tracer {
 public:
  Tracer(const InnerVoronoi& voronoi, std::vector<InnerVoronoi::Edge> edges,
         const BoundaryIndex& boundary, double tolerance)
      : voronoi_(voronoi),
        edges_(std::move(edges)),
        boundary_(boundary),
        tolerance_(tolerance),
        leaving_(voronoi.vertices.size()),
        done_(edges_.size(), 0),
        node_(voronoi.vertices.size(), kNone) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      leaving_[edges_[i].from].push_back({i, true});
      leaving_[edges_[i].to].push_back({i, false});
    }
  }

  MedialAxis trace() {
    for (std::size_t v = 0; v < leaving_.size(); ++v)
      if (!leaving_[v].empty() && leaving_[v].size() != 2)
        for (const Half& h : leaving_[v]) follow(v, h);
    // What is left runs in circles without a node: each gets one, where it is leftmost.
    std::vector<std::size_t> order(leaving_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const Vec2 p = voronoi_.vertices[a], q = voronoi_.vertices[b];
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    for (const std::size_t v : order)
      for (const Half& h : leaving_[v]) follow(v, h);
    return std::move(axis_);
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  std::size_t node_at(std::size_t vertex) {
    if (node_[vertex] == kNone) {
      node_[vertex] = axis_.nodes.size();
      const Vec2 p = voronoi_.vertices[vertex];
      axis_.nodes.push_back({p, boundary_.nearest(p).distance});
    }
    return node_[vertex];
  }

  void follow(std::size_t start, Half half) {
    if (done_[half.edge]) return;
    MedialAxis::Edge traced;
    traced.from = node_at(start);
    std::size_t vertex = start;
    traced.points.push_back(voronoi_.vertices[start]);
    while (true) {
      const InnerVoronoi::Edge& e = edges_[half.edge];
      done_[half.edge] = 1;
      std::vector<Vec2> points = voronoi_.points_along(e, tolerance_);
      if (!half.forward) std::reverse(points.begin(), points.end());
      traced.points.insert(traced.points.end(), points.begin() + 1, points.end());
      vertex = half.forward ? e.to : e.from;
      traced.points.back() = voronoi_.vertices[vertex];
      if (leaving_[vertex].size() != 2 || vertex == start) break;
      const Half &first = leaving_[vertex][0], &second = leaving_[vertex][1];
      half = first.edge == half.edge ? second : first;
    }
    traced.to = node_at(vertex);
    for (const Vec2 p : traced.points) traced.radii.push_back(boundary_.nearest(p).distance);
    axis_.edges.push_back(std::move(traced));
  }

  const InnerVoronoi& voronoi_;
  std::vector<InnerVoronoi::Edge> edges_;
  const BoundaryIndex& boundary_;
  double tolerance_;
  std::vector<std::vector<Half>> leaving_;  // by vertex
  std::vector<std::uint8_t> done_;          // by edge
  std::vector<std::size_t> node_;           // by vertex
  MedialAxis axis_;
};

}  // namespace

MedialAxis medial_axis(const Region& region, double tolerance) {
  if (!(tolerance > 0)) throw std::invalid_argument("The medial axis needs a tolerance above 0.");
  const BoundaryIndex boundary(region.curves());
  const InnerVoronoi voronoi = inner_voronoi(region, boundary, tolerance);

  std::vector<InnerVoronoi::Edge> kept;
  Groups groups(voronoi.vertices.size());
  for (const InnerVoronoi::Edge& e : without_twigs(voronoi, boundary, kSlack * tolerance)) {
    if (distance(voronoi.vertices[e.from], voronoi.vertices[e.to]) < kContraction * tolerance)
      groups.merge(e.from, e.to);
    else
      kept.push_back(e);
  }
  for (InnerVoronoi::Edge& e : kept) {
    e.from = groups.find(e.from);
    e.to = groups.find(e.to);
  }
  MedialAxis axis = Tracer(voronoi, std::move(kept), boundary, tolerance).trace();
  if (axis.nodes.empty()) {  // a disc
    const Circle circle = largest_circle(region, tolerance);
    axis.nodes.push_back({circle.centre, circle.radius});
  }
  return axis;
}

}  // namespace evenload
