// Medial axis of regions, from Boost.Polygon's Voronoi diagram of the flattened boundary.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// Laws: radii are exact distances to the boundary; every point touches it in two places, to within
// a few tolerances; the axis of a region is in one piece, with one way around each island; its ends
// on the boundary are the region's corners. The axis of a disc is one node.
struct MedialAxis {
  struct Node {
    Vec2 p;
    double radius = 0;  // mm, distance to the boundary
  };
  struct Edge {
    std::size_t from = 0, to = 0;  // nodes
    std::vector<Vec2> points;      // from ... to, both included
    std::vector<double> radii;     // mm, one per point
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

// `tolerance` mm: of the flattening. Branches that end in a corner are kept; those that only come
// from the flattening are not.
MedialAxis medial_axis(const Region& region, double tolerance);

struct Circle {
  Vec2 centre;
  double radius = 0;  // mm
};
// The largest circle inside the region (the first in order of x, then y, where several are equal).
// Error at most `tolerance` mm.
Circle largest_circle(const Region& region, double tolerance);
// Width in mm of the largest tool that fits anywhere in any of the regions: twice the radius of the
// largest circle.
double largest_tool(const std::vector<Region>& regions);

}  // namespace evenload
