// The middle of narrow passages: the parts of the region's medial axis that lie in them.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "strategy/places/narrow_passages.h"

namespace evenload {

// Points joined by straight lines; the branches into the corners of dead ends are left out, since
// a pass along the walls takes what lies there.
struct PassageAxis {
  struct Point {
    Vec2 p;
    double radius = 0;  // mm to the walls
    bool is_mouth = false;
    std::vector<std::size_t> next;
  };
  std::vector<Point> points;
  // mm: twice the smallest distance to the walls, mouths aside.
  double narrowest() const;
  double length() const;  // mm, of all branches
};

// The axes of all passages, in their order. Laws: every point lies in its passage, a mouth on the
// border of a room; neighbours are at most `spacing` mm apart. Tolerance: kAxisTolerance.
std::vector<PassageAxis> passage_axes(const Region& centres, const NarrowPlaces& places,
                                      double spacing);
inline constexpr double kAxisTolerance = 2e-4;  // mm

}  // namespace evenload
