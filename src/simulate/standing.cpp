#include "simulate/standing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/arc_fit.h"
#include "simulate/dexel_outline.h"

namespace evenload {
namespace {

// mm: so far the thin ends of what is thick enough are kept. They run out along walls that a larger
// tool was tangent to, and a link there would cut them unawares.
constexpr double kTip = 1;
// mm: what is thinner than this within the reach is no tip, but the tolerance of two fitted borders
// and the rounding of G-code.
constexpr double kThinnestTip = 1e-3;

// The points' polygon as lines and arcs, which begin at its sharpest corner.
Curve fitted(std::vector<Vec2> points) {
  const std::size_t n = points.size();
  std::size_t sharpest = 0;
  double least = 2;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = normalized(points[i] - points[(i + n - 1) % n]);
    const Vec2 out = normalized(points[(i + 1) % n] - points[i]);
    if (dot(in, out) < least - 1e-9) {
      least = dot(in, out);
      sharpest = i;
    }
  }
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(sharpest), points.end());
  points.push_back(points.front());
  std::vector<Vertex> vertices = fit_arcs(points, kOutlineTolerance).vertices();
  vertices.pop_back();
  for (Vertex& v : vertices) v.open = true;
  return Curve(std::move(vertices), true);
}

// Outlines with the islands in them; those in nothing are left out.
std::vector<Region> nested(const std::vector<Curve>& curves) {
  std::vector<Region> regions;
  std::vector<double> areas;
  for (const Curve& curve : curves)
    if (const double area = curve.signed_area(); area > 0) {
      regions.push_back({curve, {}});
      areas.push_back(area);
    }
  for (const Curve& curve : curves) {
    if (!(curve.signed_area() < 0)) continue;
    std::size_t home = regions.size();
    for (std::size_t i = 0; i < regions.size(); ++i)
      if (regions[i].outer.contains(curve.segment(0).point(0.5)) &&
          (home == regions.size() || areas[i] < areas[home]))
        home = i;
    if (home < regions.size()) regions[home].islands.push_back(curve);
  }
  return regions;
}

std::vector<Region> regions_above(const DexelStock& stock, double z,
                                  const std::vector<std::vector<Region>>& within) {
  std::vector<Curve> curves;
  for (std::vector<Vec2>& outline : outlines_above(stock, z, within)) {
    Curve curve = fitted(std::move(outline));
    if (curve.segment_count() > 1) curves.push_back(std::move(curve));
  }
  return nested(curves);
}

// Less what is no wider than `width`.
std::vector<Region> opened(const std::vector<Region>& regions, double width) {
  return offset(offset(regions, -0.5 * width), 0.5 * width);
}

}  // namespace

std::vector<Region> standing_regions(const DexelStock& stock, double z,
                                     const std::vector<Region>& reach) {
  const std::vector<Region> thick =
      opened(regions_above(stock, z + kRestTolerance, {reach}), kRestTolerance);
  if (thick.empty()) return {};
  const std::vector<Region> near = offset(thick, kTip), wider = offset(reach, kBeyondReach);
  return opened(regions_above(stock, z + kRestTolerance, {wider, near}),
                kBeyondReach + kThinnestTip);
}

}  // namespace evenload
