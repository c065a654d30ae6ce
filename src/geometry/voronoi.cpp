#include "geometry/voronoi.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>

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
  // Coordinates stay below 2^30, so this is exact.
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

// From mm to whole numbers below 2^30 and back.
struct Grid {
  Vec2 origin;
  double per_mm = 1;

  explicit Grid(const Bounds& box) {
    const double extent = std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-6});
    constexpr double kRange = 1.0e9;
    origin = box.low - Vec2{0.01 * extent, 0.01 * extent};
    per_mm = kRange / (1.02 * extent);
  }
  WholePoint to_whole(Vec2 p) const {
    return {std::llround((p.x - origin.x) * per_mm), std::llround((p.y - origin.y) * per_mm)};
  }
  Vec2 to_mm(double x, double y) const { return origin + Vec2{x, y} / per_mm; }
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

InnerVoronoi::Site site_of(const Diagram::cell_type& cell, const std::vector<Side>& sides) {
  const Side& side = sides[cell.source_index()];
  if (cell.contains_segment()) return {side.ring, side.first, side.last};
  const bool start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
  const std::size_t point = start ? side.first : side.last;
  return {side.ring, point, point};
}

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

InnerVoronoi inner_voronoi(const Region& region, const BoundaryIndex& boundary, double tolerance) {
  InnerVoronoi result;
  const Grid grid(bounds_of({region}));
  const std::vector<Curve> curves = region.curves();
  std::vector<Side> sides;
  // Curves nearer to each other than the tolerance may cross when flattened, which the diagram's
  // construction does not bear. Finer flattening parts them; where even that fails, at touches, one
  // of the two sides is left out.
  constexpr int kFiner = 5;
  for (int attempt = 0; attempt <= kFiner; ++attempt, tolerance /= 8) {
    result.rings.clear();
    for (const Curve& curve : curves) result.rings.push_back(ring_of(curve, tolerance));
    sides = sides_of(result.rings, grid);
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

  constexpr std::size_t kUnused = ~std::size_t{0};
  std::vector<std::size_t> number(diagram.num_vertices(), kUnused);
  const auto vertex = [&](const Diagram::vertex_type* v) {
    std::size_t& n = number[static_cast<std::size_t>(v - diagram.vertices().data())];
    if (n == kUnused) {
      n = result.vertices.size();
      result.vertices.push_back(grid.to_mm(v->x(), v->y()));
    }
    return n;
  };
  for (std::size_t i = 0; i < diagram.num_edges();
       i += 2) {  // every other one: edges stand beside their twins
    const Diagram::edge_type& e = diagram.edges()[i];
    if (!e.is_primary() || !e.is_finite()) continue;
    const Vec2 middle = grid.to_mm(0.5 * (e.vertex0()->x() + e.vertex1()->x()),
                                   0.5 * (e.vertex0()->y() + e.vertex1()->y()));
    InnerVoronoi::Edge edge;
    edge.left = site_of(*e.cell(), sides);
    edge.right = site_of(*e.twin()->cell(), sides);
    edge.curved = e.is_curved();
    if (!boundary.contains(middle)) continue;
    edge.from = vertex(e.vertex0());
    edge.to = vertex(e.vertex1());
    result.edges.push_back(edge);
  }
  return result;
}

}  // namespace evenload
