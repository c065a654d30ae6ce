// Nearest-boundary queries on many curves, by a tree of boxes that a grid of first guesses
// shortens. Read by any number of threads at once; copies share what was built. Laws: nearest() is
// exact up to rounding; contains() is, off the curves.
#pragma once

#include <memory>
#include <vector>

#include "geometry/region.h"

namespace evenload {

class BoundaryIndex {
 public:
  struct Hit {
    double distance = 0;      // mm
    Vec2 point;               // the nearest point on the boundary
    std::size_t curve = 0;    // index among the curves given
    std::size_t segment = 0;  // index of the segment within the curve
    double t = 0;             // parameter on the segment
  };

  explicit BoundaryIndex(const std::vector<Curve>& curves);

  bool empty() const;
  Hit nearest(Vec2 q) const;  // condition: not empty()
  // Distance to the boundary if it is below `limit`, else `limit`. Faster than nearest() for far
  // points.
  double distance_below(Vec2 q, double limit) const;
  // True where q lies inside by winding number over all curves (outer counter-clockwise, islands
  // clockwise).
  bool contains(Vec2 q) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace evenload
