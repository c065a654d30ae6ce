#include "geometry/voronoi.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <numeric>

#include "geometry/box_tree.h"

namespace evenload {

namespace {

using Whole = std::int64_t;
struct WholePoint {
  Whole x = 0, y = 0;
  bool operator==(const WholePoint& other) const { return x == other.x && y == other.y; }
};
struct Side {
  WholePoint a, b;
  std::size_t ring = 0, first = 0, last = 0;
};

Whole turn(WholePoint a, WholePoint b, WholePoint c) {
  // Coordinates stay within 2^29 of 0, so this is exact.
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
bool within_box(WholePoint a, WholePoint b, WholePoint q) {
  return std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= q.y &&
         q.y <= std::max(a.y, b.y);
}

// Whether the sides share a point other than an end of both.
bool clash(const Side& s, const Side& t) {
  const Whole sa = turn(t.a, t.b, s.a), sb = turn(t.a, t.b, s.b);
  const Whole ta = turn(s.a, s.b, t.a), tb = turn(s.a, s.b, t.b);
  if (((sa > 0 && sb < 0) || (sa < 0 && sb > 0)) && ((ta > 0 && tb < 0) || (ta < 0 && tb > 0)))
    return true;
  const auto touches = [](Whole side, WholePoint a, WholePoint b, WholePoint q) {
    return side == 0 && within_box(a, b, q) && !(q == a) && !(q == b);
  };
  if (touches(sa, t.a, t.b, s.a) || touches(sb, t.a, t.b, s.b)) return true;
  if (touches(ta, s.a, s.b, t.a) || touches(tb, s.a, s.b, t.b)) return true;
  return (s.a == t.a && s.b == t.b) || (s.a == t.b && s.b == t.a);
}

// From mm to whole numbers below 2^30, after a turn by an angle, and back.
class Grid {
 public:
  Grid(const Bounds& box, double angle) : angle_(angle), middle_(0.5 * (box.low + box.high)) {
    constexpr double kHalfRange =
        5.3e8;  // not a round share of 2^30: round sizes stay off half steps
    per_mm_ = kHalfRange / std::max(0.5 * distance(box.low, box.high), 1e-6);
  }
  WholePoint to_whole(Vec2 p) const {
    const Vec2 q = per_mm_ * rotated(p - middle_, angle_);
    return {std::llround(q.x), std::llround(q.y)};
  }
  Vec2 to_mm(double x, double y) const { return middle_ + rotated(Vec2{x, y} / per_mm_, -angle_); }

 private:
  double angle_;
  Vec2 middle_;
  double per_mm_;
};

InnerVoronoi::Ring ring_of(const Curve& curve, double tolerance) {
  InnerVoronoi::Ring ring;
  const std::vector<Segment> segments = curve.segments();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec2 u = segments[(i + segments.size() - 1) % segments.size()].tangent(1);
    const Vec2 v = segments[i].tangent(0);
    const std::vector<Vec2> points =
        Curve({{segments[i].a, segments[i].bulge()}, {segments[i].b}}, false).flattened(tolerance);
    ring.points.insert(ring.points.end(), points.begin(), points.end() - 1);
    ring.corner.push_back(std::atan2(cross(u, v), dot(u, v)) > kCornerTurn);
    ring.corner.resize(ring.points.size(), 0);
  }
  return ring;
}

std::vector<Side> sides_of(const std::vector<InnerVoronoi::Ring>& rings, const Grid& grid) {
  std::vector<Side> sides;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::size_t n = rings[r].points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      const Side side{grid.to_whole(rings[r].points[i]), grid.to_whole(rings[r].points[next]), r, i,
                      next};
      if (!(side.a == side.b)) sides.push_back(side);
    }
  }
  return sides;
}

// For each pair of sides that clash the number of one of the two.
std::vector<std::size_t> clashes(const std::vector<Side>& sides) {
  std::vector<Bounds> boxes;
  boxes.reserve(sides.size());
  for (const Side& s : sides)
    boxes.push_back(
        {{static_cast<double>(std::min(s.a.x, s.b.x)), static_cast<double>(std::min(s.a.y, s.b.y))},
         {static_cast<double>(std::max(s.a.x, s.b.x)),
          static_cast<double>(std::max(s.a.y, s.b.y))}});
  const BoxTree tree(boxes);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    bool bad = false;
    tree.visit(boxes[i], [&](std::size_t k) { bad = bad || (k < i && clash(sides[i], sides[k])); });
    if (bad) found.push_back(i);
  }
  return found;
}

using Diagram = boost::polygon::voronoi_diagram<double>;

// Whether p is as near to the one site of the edge as to the other.
bool midway(const InnerVoronoi::Edge& edge, Vec2 p, const std::vector<InnerVoronoi::Ring>& rings,
            double slack) {
  const auto to = [&](const InnerVoronoi::Site& site) {
    const std::vector<Vec2>& points = rings[site.ring].points;
    return Segment::line(points[site.first], points[site.last]).distance_to(p);
  };
  return std::abs(to(edge.left) - to(edge.right)) <= slack;
}

class Sites {
 public:
  explicit Sites(const std::vector<Side>& sides) : sides_(sides), first_(1, 0) {
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (sides[i].ring != sides[i - 1].ring) first_.push_back(i);
    first_.push_back(sides.size());
  }

  InnerVoronoi::Site site(const Diagram::cell_type& cell) const {
    const Side& side = sides_[cell.source_index()];
    if (cell.contains_segment()) return {side.ring, side.first, side.last};
    const std::size_t point = at_start(cell) ? side.first : side.last;
    return {side.ring, point, point};
  }

  // Whether what is nearest to the cell's site lies inside there: left of a side (x, y stands for
  // it), or around a point where the ring turns right. 0 where the site does not tell.
  int inside(const Diagram::cell_type& cell, double x, double y) const {
    const Side& side = sides_[cell.source_index()];
    if (cell.contains_segment()) {
      const double dx = static_cast<double>(side.b.x - side.a.x);
      const double dy = static_cast<double>(side.b.y - side.a.y);
      const double to_left =
          dx * (y - static_cast<double>(side.a.y)) - dy * (x - static_cast<double>(side.a.x));
      return to_left > 0 ? 1 : -1;
    }
    const std::size_t other = beside(cell.source_index(), at_start(cell));
    const Side& before = at_start(cell) ? sides_[other] : side;
    const Side& after = at_start(cell) ? side : sides_[other];
    if (before.ring != after.ring || !(before.b == after.a)) return 0;
    const Whole turned = turn(before.a, before.b, after.b);
    return turned < 0 ? 1 : turned > 0 ? -1 : 0;
  }

 private:
  static bool at_start(const Diagram::cell_type& cell) {
    return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
  }
  // The side before or after the one given in its ring.
  std::size_t beside(std::size_t side, bool before) const {
    const auto next_ring = std::upper_bound(first_.begin(), first_.end(), side);
    const std::size_t end = *next_ring, begin = *(next_ring - 1);
    if (before) return side > begin ? side - 1 : end - 1;
    return side + 1 < end ? side + 1 : begin;
  }

  const std::vector<Side>& sides_;
  std::vector<std::size_t> first_;  // of each ring; then their number
};

}  // namespace

std::vector<Vec2> InnerVoronoi::points_along(const Edge& edge, double tolerance) const {
  const Vec2 a = vertices[edge.from], b = vertices[edge.to];
  std::vector<Vec2> points{a};
  if (edge.curved) {
    const bool point_left = edge.left.first == edge.left.last;
    const Site &point = point_left ? edge.left : edge.right,
               &side = point_left ? edge.right : edge.left;
    const Vec2 focus = rings[point.ring].points[point.first];
    const Vec2 start = rings[side.ring].points[side.first];
    const Vec2 along = normalized(rings[side.ring].points[side.last] - start);
    // In the frame of the side, the parabola is y = ((x - x_focus)^2 + y_focus^2) / (2 y_focus).
    const double height = cross(along, focus - start);
    const double x0 = dot(along, a - focus), x1 = dot(along, b - focus);
    constexpr int kMostSteps = 1000;
    if (std::abs(height) > 1e-3 * tolerance) {
      const double steps =
          std::ceil(std::abs(x1 - x0) / std::sqrt(8 * tolerance * std::abs(height)));
      const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMostSteps)));
      const Vec2 base = focus - height * left_normal(along);
      for (int i = 1; i < count; ++i) {
        const double x = x0 + (x1 - x0) * i / count;
        points.push_back(base + x * along +
                         (x * x + height * height) / (2 * height) * left_normal(along));
      }
    }
  }
  points.push_back(b);
  return points;
}

namespace {

struct Attempt {
  InnerVoronoi voronoi;
  std::size_t faults = 0;
};

// How far the diagram is from what every diagram of a region is: in one piece, with one way around
// each island.
std::size_t faults_of(const InnerVoronoi& voronoi, std::size_t islands) {
  std::vector<std::size_t> parents(voronoi.vertices.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  const auto root = [&](std::size_t v) {
    while (parents[v] != v) v = parents[v] = parents[parents[v]];
    return v;
  };
  std::size_t pieces = parents.size(), ways_around = 0;
  for (const InnerVoronoi::Edge& e : voronoi.edges) {
    const std::size_t a = root(e.from), b = root(e.to);
    if (a == b) {
      ++ways_around;
    } else {
      parents[std::max(a, b)] = std::min(a, b);
      --pieces;
    }
  }
  return (pieces == 1 ? 0 : 1) + (ways_around == islands ? 0 : 1);
}

Attempt attempt(const Region& region, const BoundaryIndex& boundary, double tolerance,
                double angle) {
  const double slack = tolerance;
  Attempt result;
  InnerVoronoi& voronoi = result.voronoi;
  const Grid grid(bounds_of({region}), angle);
  const std::vector<Curve> curves = region.curves();
  std::vector<Side> sides;
  // Curves nearer to each other than the tolerance may cross when flattened, which the diagram's
  // construction does not bear. Finer flattening parts them; where even that fails, at touches, one
  // of the two sides is left out.
  constexpr int kFiner = 5;
  for (int finer = 0; finer <= kFiner; ++finer, tolerance /= 8) {
    voronoi.rings.clear();
    for (const Curve& curve : curves) voronoi.rings.push_back(ring_of(curve, tolerance));
    sides = sides_of(voronoi.rings, grid);
    if (clashes(sides).empty()) break;
  }
  for (std::vector<std::size_t> bad = clashes(sides); !bad.empty(); bad = clashes(sides))
    for (auto i = bad.rbegin(); i != bad.rend(); ++i)
      sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(*i));

  boost::polygon::default_voronoi_builder builder;
  for (const Side& s : sides)
    builder.insert_segment(static_cast<std::int32_t>(s.a.x), static_cast<std::int32_t>(s.a.y),
                           static_cast<std::int32_t>(s.b.x), static_cast<std::int32_t>(s.b.y));
  Diagram diagram;
  builder.construct(&diagram);

  const Sites sites(sides);
  constexpr std::size_t kUnused = ~std::size_t{0};
  std::vector<std::size_t> number(diagram.num_vertices(), kUnused);
  const auto vertex = [&](const Diagram::vertex_type* v) {
    std::size_t& n = number[static_cast<std::size_t>(v - diagram.vertices().data())];
    if (n == kUnused) {
      n = voronoi.vertices.size();
      voronoi.vertices.push_back(grid.to_mm(v->x(), v->y()));
    }
    return n;
  };
  for (std::size_t i = 0; i < diagram.num_edges(); i += 2) {  // edges stand beside their twins
    const Diagram::edge_type& e = diagram.edges()[i];
    if (!e.is_primary() || !e.is_finite()) continue;
    const double x = 0.5 * (e.vertex0()->x() + e.vertex1()->x());
    const double y = 0.5 * (e.vertex0()->y() + e.vertex1()->y());
    int inside = sites.inside(*e.cell(), x, y);
    if (inside == 0 || !e.cell()->contains_segment()) {
      const int other = sites.inside(*e.twin()->cell(), x, y);
      if (other != 0) inside = other;
    }
    if (inside == 0) inside = boundary.contains(grid.to_mm(x, y)) ? 1 : -1;
    if (inside < 0) continue;
    InnerVoronoi::Edge edge;
    edge.left = sites.site(*e.cell());
    edge.right = sites.site(*e.twin()->cell());
    edge.curved = e.is_curved();
    const Vec2 from = grid.to_mm(e.vertex0()->x(), e.vertex0()->y());
    const Vec2 to = grid.to_mm(e.vertex1()->x(), e.vertex1()->y());
    if (!midway(edge, from, voronoi.rings, slack) || !midway(edge, to, voronoi.rings, slack)) {
      ++result.faults;
      continue;
    }
    edge.from = vertex(e.vertex0());
    edge.to = vertex(e.vertex1());
    voronoi.edges.push_back(edge);
  }
  result.faults += faults_of(voronoi, region.islands.size());
  return result;
}

}  // namespace

InnerVoronoi inner_voronoi(const Region& region, const BoundaryIndex& boundary, double tolerance) {
  // Boost's diagram now and then is wrong, above all near sides along the y axis
  // (github.com/boostorg/polygon/issues/43 and 72). A turned region then gives a right one.
  Attempt best = attempt(region, boundary, tolerance, 0);
  for (const double angle : {0.61, 1.97, 2.83, 4.39}) {
    if (best.faults == 0) break;
    Attempt turned = attempt(region, boundary, tolerance, angle);
    if (turned.faults < best.faults) best = std::move(turned);
  }
  return std::move(best.voronoi);
}

}  // namespace evenload
