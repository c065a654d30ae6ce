#include "surface/contours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "geometry/united.h"
#include "support/parallel.h"

namespace evenload {

namespace {

constexpr double kChords = 0.002;    // mm, in plan, by which chords leave the arcs round corners
constexpr double kSamePlace = 1e-9;  // mm

// Regions of nested outlines: those within an even number of others bound ground, the rest islands.
std::vector<Region> nested(const std::vector<std::vector<Vec2>>& outlines) {
  std::vector<Curve> curves;
  for (const std::vector<Vec2>& outline : outlines) {
    std::vector<Vertex> vertices;
    for (const Vec2 p : outline) vertices.push_back({p});
    curves.emplace_back(std::move(vertices), true);
  }
  std::vector<std::vector<std::size_t>> around(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t k = 0; k < curves.size(); ++k)
      if (k != i && curves[k].contains(outlines[i].front())) around[i].push_back(k);
  std::vector<Region> regions;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (around[i].size() % 2 == 1) continue;
    std::vector<Curve> islands;
    for (std::size_t k = 0; k < curves.size(); ++k)
      if (around[k].size() == around[i].size() + 1 &&
          std::find(around[k].begin(), around[k].end(), i) != around[k].end())
        islands.push_back(curves[k]);
    regions.push_back(make_region(curves[i], islands));
  }
  return regions;
}

bool is_same(SpacePoint a, SpacePoint b) { return distance(a, b) < kSamePlace; }

// What a pass along a closed polygon cuts, piece by piece.
std::vector<PassPart> along(const Ground& ground, const std::vector<Vec2>& polygon, std::size_t row,
                            double tolerance) {
  std::vector<PassPart> parts;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 from = polygon[i], way = polygon[(i + 1) % polygon.size()] - from;
    const double length = norm(way);
    if (!(length > kSamePlace)) continue;
    const PlanLine line{from, way / length};
    const std::vector<DropSample> samples = samples_along(ground, line, 0, length, tolerance);
    for (const std::vector<DropSample>& part : parts_at_work(ground, line, samples)) {
      std::vector<SpacePoint> points = lines_of(line, part, tolerance, LineEnds::kFixed);
      if (!parts.empty() && is_same(parts.back().points.back(), points.front()))
        parts.back().points.insert(parts.back().points.end(), points.begin() + 1, points.end());
      else
        parts.push_back({row, std::move(points)});
    }
  }
  if (parts.empty() || !is_same(parts.back().points.back(), parts.front().points.front()))
    return parts;
  if (parts.size() == 1) {
    parts.front().is_closed = true;
    return parts;
  }
  // The last one goes on where the polygon begins.
  std::vector<SpacePoint>& last = parts.back().points;
  last.insert(last.end(), parts.front().points.begin() + 1, parts.front().points.end());
  parts.front().points = std::move(last);
  parts.pop_back();
  return parts;
}

}  // namespace

std::vector<Region> covered_by_picked(const FacetMesh& mesh) {
  std::vector<std::vector<Vec2>> triangles;
  for (const Facet& facet : mesh.facets())
    if (facet.is_picked && facet.normal.z > 0)
      triangles.push_back({plan(facet.corners[0]), plan(facet.corners[1]), plan(facet.corners[2])});
  std::vector<Region> regions;
  if (!triangles.empty()) regions = nested(united(triangles, kOutlineTolerance));
  if (regions.empty())
    throw std::invalid_argument(
        "None of the picked faces can be seen from above: pick others, or turn the model.");
  return regions;
}

std::vector<std::vector<std::vector<Vec2>>> contour_rows(const Ground& ground,
                                                         const std::vector<Region>& regions,
                                                         double stepover, Progress& progress) {
  const double reach = ground.by_contact ? ground.cutter.radius + ground.allowance : 0;
  std::vector<std::vector<std::vector<Vec2>>> rows;
  for (double off = std::floor(reach / stepover + 0.5) - 0.5;; --off) {
    progress.step();
    const std::vector<Region> moved = offset(regions, off * stepover);
    if (moved.empty()) return rows;
    rows.emplace_back();
    for (const Region& region : moved)
      for (const Curve& curve : region.curves()) rows.back().push_back(curve.flattened(kChords));
  }
}

std::vector<PassPart> contour_passes(const Ground& ground,
                                     const std::vector<std::vector<std::vector<Vec2>>>& rows,
                                     const FinishParams& params, Progress& progress) {
  std::vector<std::vector<PassPart>> found(rows.size());
  parallel_for(
      rows.size(), thread_count(params.threads),
      [&](std::size_t row) {
        for (const std::vector<Vec2>& polygon : rows[row]) {
          std::vector<PassPart> parts = along(ground, polygon, row, params.tolerance);
          std::move(parts.begin(), parts.end(), std::back_inserter(found[row]));
        }
      },
      progress);
  std::vector<PassPart> parts;
  for (std::vector<PassPart>& row : found)
    std::move(row.begin(), row.end(), std::back_inserter(parts));
  return parts;
}

}  // namespace evenload
