#include "geometry/united.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace evenload {
namespace {

namespace bp = boost::polygon;
namespace bg = boost::geometry;
using Ring = bg::model::ring<bg::model::d2::point_xy<double>>;
using Point = bp::point_data<int>;
using Outline = bp::polygon_data<int>;
using WithHoles = bp::polygon_with_holes_data<int>;

using bp::operators::operator-=;

constexpr double kReach = 2e9;  // of an int, with room for differences

int on_grid(double value) {
  const double scaled = std::round(value / kUnitedGrid);
  if (!(std::abs(scaled) < kReach))
    throw std::invalid_argument("A body reaches further than 20 m: move it to the origin.");
  return static_cast<int>(scaled);
}

template <typename Polygon>
std::vector<Vec2> points_of(const Polygon& polygon, double tolerance) {
  Ring ring, simple;
  for (auto p = polygon.begin(); p != polygon.end(); ++p)
    ring.emplace_back(kUnitedGrid * p->x(), kUnitedGrid * p->y());
  // Boost.Polygon repeats the first point of outlines, but not of holes.
  if (!bg::equals(ring.front(), ring.back())) ring.push_back(ring.front());
  bg::simplify(ring, simple, tolerance);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < simple.size(); ++i)
    points.push_back({simple[i].x(), simple[i].y()});
  return points;
}

Outline outline_of(const std::vector<Vec2>& polygon) {
  std::vector<Point> points;
  for (const Vec2 p : polygon) points.emplace_back(on_grid(p.x), on_grid(p.y));
  Outline outline;
  outline.set(points.begin(), points.end());
  return outline;
}

WithHoles with_holes(const Patch& patch) {
  WithHoles result;
  const Outline outline = outline_of(patch.outline);
  result.set(outline.begin(), outline.end());
  std::vector<Outline> holes;
  for (const std::vector<Vec2>& hole : patch.holes) holes.push_back(outline_of(hole));
  result.set_holes(holes.begin(), holes.end());
  return result;
}

}  // namespace

std::vector<std::vector<Vec2>> united(const std::vector<std::vector<Vec2>>& polygons,
                                      double tolerance) {
  bp::polygon_set_data<int> set;
  for (const std::vector<Vec2>& polygon : polygons) set.insert(outline_of(polygon));
  std::vector<WithHoles> found;
  set.get(found);
  std::vector<std::vector<Vec2>> outlines;
  const auto add = [&](const auto& polygon) {
    std::vector<Vec2> points = points_of(polygon, tolerance);
    if (points.size() >= 3) outlines.push_back(std::move(points));
  };
  for (const WithHoles& each : found) {
    add(each);
    for (auto hole = each.begin_holes(); hole != each.end_holes(); ++hole) add(*hole);
  }
  return outlines;
}

std::vector<Patch> cut_from(const std::vector<Patch>& patches, const std::vector<Patch>& cut,
                            double tolerance) {
  bp::polygon_set_data<int> set, other;
  for (const Patch& patch : patches) set.insert(with_holes(patch));
  for (const Patch& patch : cut) other.insert(with_holes(patch));
  set -= other;
  std::vector<WithHoles> found;
  set.get(found);
  std::vector<Patch> left;
  for (const WithHoles& each : found) {
    Patch patch{points_of(each, tolerance), {}};
    if (patch.outline.size() < 3) continue;
    for (auto hole = each.begin_holes(); hole != each.end_holes(); ++hole) {
      std::vector<Vec2> points = points_of(*hole, tolerance);
      if (points.size() >= 3) patch.holes.push_back(std::move(points));
    }
    left.push_back(std::move(patch));
  }
  return left;
}

}  // namespace evenload
