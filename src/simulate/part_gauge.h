// How deep the tool is in what must stay.
//
// Exact from the geometry of the part, not from dexels: a wall is gouged by hundredths of a
// millimetre. The depth at a position is the way out sideways, to the part's border; for what does
// not reach up to the stock's top, such as a floor, it is the way up where that is shorter.
#pragma once

#include <optional>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/box_tree.h"
#include "simulate/dexel_stock.h"

namespace evenload {

struct Gouge {
  double depth = 0;  // mm
  double t = 0;      // parameter on the path
};

class PartGauge {
 public:
  PartGauge(const std::vector<Prism>& part, double tool_radius, double stock_top);

  bool empty() const { return levels_.empty(); }
  // mm, at most the tool's radius plus the way out of the part; 0 where the tool is clear of it.
  double depth(Vec2 p, double z) const;
  // The deepest along a path that goes from z0 to z1. Looks at points hardly further apart than
  // `step` mm and at all at which the distance to an edge can be least.
  Gouge deepest(const Segment& path, double z0, double z1, double step) const;

 private:
  struct Level {
    double top = 0;
    BoundaryIndex index;
    std::vector<Segment> edges;
    BoxTree tree;
  };
  // Calls visit(t) for every parameter at which the path may come nearest to an edge.
  template <typename Visit>
  static void visit_nearest(const Segment& path, const Segment& edge, Visit visit);

  double radius_;
  double stock_top_;
  Bounds box_;  // around all of the part
  std::vector<Level> levels_;
};

}  // namespace evenload
