#include "simulate/height_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/boundary_index.h"

namespace evenload {
namespace {

// mm^2, twice the area seen from above: what has less stands upright.
constexpr double kUpright = 1e-9;

// mm above a height, by which what reaches it counts as higher.
constexpr double kAbove = 1e-9;

// Places along each side of a region's box at which a body is looked for, at the most.
constexpr double kMostLooks = 400;

// Share of a triangle by which places beside it count as on it: neighbours leave no gap.
constexpr double kBeside = 1e-9;

double cross_of(const Point3& a, const Point3& b, Vec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Where a triangle's edge from a to b crosses the height z, from above; a where it does not.
Point3 cut_at(const Point3& a, const Point3& b, double z) {
  if (b.z >= z || a.z <= z) return b.z >= z ? b : a;
  const double t = (a.z - z) / (a.z - b.z);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), z};
}

// Of a triangle that is counter-clockwise from above.
Point3 normal_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double size = std::hypot(n.x, n.y, n.z);
  return {n.x / size, n.y / size, n.z / size};
}

Point3 mirrored(const Point3& p) { return {p.y, p.x, p.z}; }

}  // namespace

HeightMap::HeightMap(const std::vector<Point3>& points, const std::vector<Triangle>& triangles)
    : triangles_(triangles.size()) {
  for (const Point3& p : points)
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
      throw std::invalid_argument("A body's points must be numbers, in mm.");
  std::vector<Bounds> boxes;
  std::uint32_t number = 0;
  for (const Triangle& triangle : triangles) {
    const std::uint32_t mine = number++;
    for (const std::uint32_t corner : triangle)
      if (corner >= points.size())
        throw std::invalid_argument("A body's triangle has a point that is not there.");
    Face face{points[triangle[0]], points[triangle[1]], points[triangle[2]], mine};
    const double area = cross_of(face.a, face.b, {face.c.x, face.c.y});
    if (std::abs(area) < kUpright) continue;
    if (area < 0) std::swap(face.b, face.c);
    const auto [low_x, high_x] = std::minmax({face.a.x, face.b.x, face.c.x});
    const auto [low_y, high_y] = std::minmax({face.a.y, face.b.y, face.c.y});
    const auto [low_z, high_z] = std::minmax({face.a.z, face.b.z, face.c.z});
    const Bounds box{{low_x, low_y}, {high_x, high_y}};
    lowest_ = faces_.empty() ? low_z : std::min(lowest_, low_z);
    highest_ = faces_.empty() ? high_z : std::max(highest_, high_z);
    bounds_ = faces_.empty() ? box : joined(bounds_, box);
    faces_.push_back(face);
    boxes.push_back(box);
  }
  tree_ = BoxTree(boxes);
}

std::optional<double> HeightMap::height_on(const Face& face, Vec2 p) {
  const double area = cross_of(face.a, face.b, {face.c.x, face.c.y});
  const double u = cross_of(face.b, face.c, p) / area, v = cross_of(face.c, face.a, p) / area;
  const double w = 1 - u - v;
  if (u < -kBeside || v < -kBeside || w < -kBeside) return std::nullopt;
  return u * face.a.z + v * face.b.z + w * face.c.z;
}

double HeightMap::top_at(Vec2 p) const {
  double top = kNoMaterial;
  tree_.visit({p, p}, [&](std::uint32_t item) {
    if (const auto height = height_on(faces_[item], p)) top = std::max(top, *height);
  });
  return top;
}

std::optional<Top> HeightMap::highest_at(Vec2 p) const {
  std::optional<Top> best;
  const Face* highest = nullptr;
  tree_.visit({p, p}, [&](std::uint32_t item) {
    const Face& face = faces_[item];
    const auto z = height_on(face, p);
    if (!z) return;
    const bool is_higher = !best || *z > best->z || (*z == best->z && face.number < best->triangle);
    if (!is_higher) return;
    best = Top{*z, {}, face.number};
    highest = &face;
  });
  if (highest != nullptr) best->normal = normal_of(highest->a, highest->b, highest->c);
  return best;
}

std::vector<Point3> HeightMap::raster(const Bounds& corners, double step) const {
  if (!(step > 0)) throw std::invalid_argument("The step of a raster must be positive, in mm.");
  std::vector<Point3> places;
  const Vec2 extent = corners.high - corners.low;
  if (!(extent.x >= 0 && extent.y >= 0)) return places;
  const int columns = static_cast<int>(extent.x / step), rows = static_cast<int>(extent.y / step);
  const Vec2 first = corners.low + 0.5 * (extent - step * Vec2{static_cast<double>(columns),
                                                               static_cast<double>(rows)});
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const Vec2 p = first + step * Vec2{static_cast<double>(i), static_cast<double>(j)};
      const double top = top_at(p);
      if (top != kNoMaterial) places.push_back({p.x, p.y, top});
    }
  return places;
}

void HeightMap::raise(std::vector<DexelRow>& rows, double first, double spacing,
                      bool mirror) const {
  for (Face face : faces_) {
    if (mirror) face = {mirrored(face.a), mirrored(face.b), mirrored(face.c), face.number};
    const std::array<Point3, 3> corners{face.a, face.b, face.c};
    const auto [low, high] = std::minmax({face.a.y, face.b.y, face.c.y});
    int j = std::max(0, static_cast<int>(std::ceil((low - first) / spacing)));
    for (; j < static_cast<int>(rows.size()) && first + j * spacing <= high; ++j) {
      const double y = first + j * spacing;
      std::vector<Point3> ends;  // of the triangle's chord along the row
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = corners[k], &b = corners[(k + 1) % 3];
        if (a.y == b.y || std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
        const double t = (y - a.y) / (b.y - a.y);
        ends.push_back({a.x + t * (b.x - a.x), y, a.z + t * (b.z - a.z)});
      }
      if (ends.size() < 2) continue;
      const auto [left, right] = std::minmax_element(
          ends.begin(), ends.end(), [](const Point3& p, const Point3& q) { return p.x < q.x; });
      const double width = right->x - left->x, rise = right->z - left->z;
      const int steps = rise == 0 ? 1 : std::max(1, static_cast<int>(std::ceil(width / spacing)));
      for (int k = 0; k < steps; ++k) {
        const double t0 = static_cast<double>(k) / steps, t1 = static_cast<double>(k + 1) / steps;
        rows[static_cast<std::size_t>(j)].raise(left->x + t0 * width, left->x + t1 * width,
                                                std::max(left->z + t0 * rise, left->z + t1 * rise));
      }
    }
  }
}

std::optional<Point3> HeightMap::highest_within(const Region& region, double z, double inset,
                                                double spacing) const {
  if (empty() || highest_ <= z) return std::nullopt;
  const std::vector<Curve> curves = region.curves();
  const BoundaryIndex border(curves);
  const Bounds box = bounds_of({region});
  if (!overlap(box, bounds_)) return std::nullopt;
  spacing = std::max(
      {spacing, (box.high.x - box.low.x) / kMostLooks, (box.high.y - box.low.y) / kMostLooks});
  std::optional<Point3> found;
  const auto look = [&](Vec2 p, double height) {
    if (height <= z || (found && height <= found->z)) return;
    if (border.contains(p) && border.nearest(p).distance >= inset) found = {p.x, p.y, height};
  };
  const auto look_at = [&](Vec2 p) { look(p, top_at(p)); };
  tree_.visit(box, [&](std::uint32_t item) {
    const Face& face = faces_[item];
    if (std::max({face.a.z, face.b.z, face.c.z}) <= z) return;
    const std::array<Point3, 3> corners{face.a, face.b, face.c};
    Point3 sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = corners[k], &b = corners[(k + 1) % 3];
      const Point3 from = cut_at(b, a, z), to = cut_at(a, b, z);
      // A corner that lies below is replaced by where the edges leave the height.
      look({from.x, from.y}, from.z + kAbove);
      look({to.x, to.y}, to.z + kAbove);
      look({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}, 0.5 * (from.z + to.z) + kAbove);
      sum = {sum.x + (from.x + to.x) / 6, sum.y + (from.y + to.y) / 6, sum.z + (from.z + to.z) / 6};
    }
    look({sum.x, sum.y}, sum.z + kAbove);
  });
  for (double x = box.low.x + 0.5 * spacing; x < box.high.x; x += spacing)
    for (double y = box.low.y + 0.5 * spacing; y < box.high.y; y += spacing) look_at({x, y});
  for (const Curve& curve : curves) {
    for (const Segment& edge : curve.segments()) {
      const int steps = std::max(1, static_cast<int>(std::ceil(edge.length() / spacing)));
      for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        look_at(edge.point(t) + 1.5 * inset * left_normal(edge.tangent(t)));
      }
    }
  }
  return found;
}

}  // namespace evenload
