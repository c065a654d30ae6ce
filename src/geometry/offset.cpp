// The method, for d of either sign:
//  1. every piece of the boundary is moved aside by d, and corners that open get an arc
//  (offset_pieces);
//  2. the moved pieces are cut wherever they meet, and parts nearer to the boundary than d are
//  dropped (offset_graph);
//  3. what is left is chained into loops; loops that turn counter-clockwise are outlines, the
//  others islands.
// At a degenerate d, where fronts just touch, loops may touch too or stay unclosed: then others
// that differ by less than the tolerance are tried.

#include <algorithm>
#include <stdexcept>

#include "geometry/box_tree.h"
#include "geometry/offset_graph.h"
#include "geometry/offset_pieces.h"
#include "geometry/region.h"

namespace evenload {

namespace {

// Other offsets to try, as shares of kOffsetTolerance; irregular, so that what coincides at one
// does not at the next, and large enough that two fronts which touch then part or meet by more than
// kSame.
constexpr double kDetours[] = {0.0, 0.43, -0.47, 0.91, -0.87};
constexpr double kSame = 0.5;  // below this share of kOffsetTolerance points are one point

OffsetTolerances tolerances_for(const Bounds& box, double d) {
  const double extent = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x),
                                  std::abs(box.high.y)}) +
                        std::abs(d);
  OffsetTolerances t;
  t.whole = std::max(kOffsetTolerance, 1e-11 * extent);  // rounding grows with the coordinates
  t.same = kSame * t.whole;
  t.depth = 0.1 * t.whole;
  t.sure = 0.001 * t.whole;
  return t;
}

Segment longest_piece(const Curve& curve) {
  Segment longest = curve.segment(0);
  for (const Segment& s : curve.segments())
    if (s.length() > longest.length()) longest = s;
  return longest;
}

// Whether the piece of an island lies in the outline. They may touch in a point, so most of three
// points decide.
bool lies_in(const Curve& outline, const Segment& piece) {
  int inside = 0;
  for (const double t : {0.31, 0.5, 0.73}) inside += outline.contains(piece.point(t)) ? 1 : 0;
  return inside >= 2;
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
    const Segment piece = longest_piece(island);
    Outline* home = nullptr;
    for (Outline& o : outlines)
      if (squared_distance(o.box, piece.point(0.31)) == 0 &&
          (home == nullptr || o.area < home->area) && lies_in(o.region.outer, piece))
        home = &o;
    if (home != nullptr) home->region.islands.push_back(std::move(island));
  }
  std::vector<Region> regions;
  regions.reserve(outlines.size());
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
  if (curves.empty() || std::abs(d) <= tolerances.whole) return regions;

  const BoundaryIndex boundary(curves);
  OffsetLoops best;
  for (const double detour : kDetours) {
    const double tried = d + detour * tolerances.whole;
    OffsetNodes nodes;
    const std::vector<OffsetPiece> pieces =
        offset_pieces(curves, boundary, tried, tolerances, nodes);
    OffsetLoops found = offset_loops(pieces, nodes, boundary, tried, tolerances);
    const bool better =
        found.lost < best.lost - tolerances.whole ||
        (found.lost <= best.lost + tolerances.whole && found.touches < best.touches);
    if (detour == 0 || better) best = std::move(found);
    if (best.lost <= 100 * tolerances.whole && best.touches == 0) break;
  }
  return nested(std::move(best.loops));
}

}  // namespace evenload
