// The method, for d of either sign:
//  1. every piece of the boundary is moved aside by d, and corners that open get an arc
//  (offset_pieces);
//  2. the moved pieces are cut wherever they meet, and parts nearer to the boundary than d are
//  dropped (offset_graph);
//  3. what is left is chained into loops; loops that turn counter-clockwise are outlines, the
//  others islands.
// A degenerate d, at which many pieces just touch, may leave a chain unclosed: then a d nearer by
// than the tolerance is tried.

#include <algorithm>
#include <stdexcept>

#include "geometry/box_tree.h"
#include "geometry/offset_graph.h"
#include "geometry/offset_pieces.h"
#include "geometry/region.h"

namespace evenload {

namespace {

// Other offsets to try, as shares of the tolerance; irregular, so that what coincides at one does
// not at the next.
constexpr double kDetours[] = {0.0, 0.37, -0.41, 0.83, -0.79};

OffsetTolerances tolerances_for(const Bounds& box, double d) {
  const double extent = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x),
                                  std::abs(box.high.y)}) +
                        std::abs(d);
  OffsetTolerances t;
  t.same = std::max(kOffsetTolerance, 1e-11 * extent);  // rounding grows with the coordinates
  t.depth = 0.1 * t.same;
  t.sure = 0.001 * t.same;
  return t;
}

Vec2 middle_of_longest_piece(const Curve& curve) {
  Segment longest = curve.segment(0);
  for (const Segment& s : curve.segments())
    if (s.length() > longest.length()) longest = s;
  return longest.point(0.5);
}

std::vector<Region> nested(std::vector<Curve> loops) {
  struct Outline {
    Region region;
    Bounds box;
    double area;
  };
  std::vector<Outline> outlines;
  std::vector<Curve> islands;
  for (Curve& loop : loops) {
    const double area = loop.signed_area();
    if (area > 0) {
      outlines.push_back({{std::move(loop), {}}, {}, area});
      outlines.back().box = bounds_of({outlines.back().region});
    } else {
      islands.push_back(std::move(loop));
    }
  }
  for (Curve& island : islands) {
    const Vec2 p = middle_of_longest_piece(island);
    Outline* home = nullptr;
    for (Outline& o : outlines)
      if (squared_distance(o.box, p) == 0 && (home == nullptr || o.area < home->area) &&
          o.region.outer.contains(p))
        home = &o;
    if (home != nullptr) home->region.islands.push_back(std::move(island));
  }
  std::vector<Region> regions;
  for (Outline& o : outlines) regions.push_back(std::move(o.region));
  return regions;
}

}  // namespace

std::vector<Region> offset(const std::vector<Region>& regions, double d) {
  if (!std::isfinite(d)) throw std::invalid_argument("The offset must be a finite number of mm.");
  std::vector<Curve> curves;
  for (const Region& region : regions)
    for (Curve& curve : region.curves()) curves.push_back(std::move(curve));
  const OffsetTolerances tolerances = tolerances_for(bounds_of(regions), d);
  if (curves.empty() || std::abs(d) <= tolerances.same) return regions;

  const BoundaryIndex boundary(curves);
  OffsetLoops best;
  for (const double detour : kDetours) {
    const double tried = d + detour * tolerances.same;
    OffsetNodes nodes;
    const std::vector<OffsetPiece> pieces =
        offset_pieces(curves, boundary, tried, tolerances, nodes);
    OffsetLoops found = offset_loops(pieces, nodes, boundary, tried, tolerances);
    if (detour == 0 || found.lost < best.lost) best = std::move(found);
    if (best.lost <= 100 * tolerances.same) break;
  }
  return nested(std::move(best.loops));
}

}  // namespace evenload
