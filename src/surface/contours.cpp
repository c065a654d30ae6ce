#include "surface/contours.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/united.h"

namespace evenload {

namespace {

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

std::vector<std::vector<Polyline>> contour_rows(const Ground& ground,
                                                const std::vector<Region>& regions, double stepover,
                                                Progress& progress) {
  const double reach = ground.by_contact ? ground.cutter.radius + ground.allowance : 0;
  std::vector<std::vector<Polyline>> rows;
  for (double off = std::floor(reach / stepover + 0.5) - 0.5;; --off) {
    progress.step();
    const std::vector<Region> moved = offset(regions, off * stepover);
    if (moved.empty()) return rows;
    rows.emplace_back();
    for (const Region& region : moved)
      for (const Curve& curve : region.curves())
        rows.back().push_back({curve.flattened(kChords), true});
  }
}

}  // namespace evenload
