// The Voronoi diagram of regions' flattened boundaries, inside the regions only. Internal to the
// medial axis and the largest circle.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/region.h"

namespace evenload {

struct InnerVoronoi {
  // A closed curve as a polygon. A corner is a vertex of the curve itself where it turns left by
  // more than kCornerTurn.
  struct Ring {
    std::vector<Vec2> points;
    std::vector<std::uint8_t> corner;
  };
  // A side of a ring, or a point of it: the points `first` to `last` (the same for a point; `last`
  // wraps to 0).
  struct Site {
    std::size_t ring = 0, first = 0, last = 0;
  };
  struct Edge {
    std::size_t from = 0, to = 0;  // vertices
    Site left, right;              // what the edge lies midway between
    bool curved = false;           // a piece of a parabola: one site is a point, the other a side
  };
  std::vector<Ring> rings;
  std::vector<Vec2> vertices;
  std::vector<Edge> edges;

  // Points along the edge's parabola or line, from its start to its end, with chords off by
  // `tolerance` at most.
  std::vector<Vec2> points_along(const Edge& edge, double tolerance) const;
};

// Splines come as chains of arcs and lines with tangent breaks up to about this; what turns more
// was meant as a corner.
inline constexpr double kCornerTurn = 0.01;  // rad

// `boundary`: of the region's curves. `tolerance` mm: of the flattening; finer where the flattened
// curves would cross.
InnerVoronoi inner_voronoi(const Region& region, const BoundaryIndex& boundary, double tolerance);

}  // namespace evenload
