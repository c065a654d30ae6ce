// The end of a milling tool: a flat disc with a rounded corner. A ball has no flat, a flat end mill
// no corner.
#pragma once

#include <algorithm>
#include <cmath>

namespace evenload {

struct Cutter {
  double radius = 0;  // mm, > 0
  double corner = 0;  // mm, 0 to radius: of the rounded corner

  double flat() const { return radius - corner; }  // mm: radius of the flat in the middle

  // mm by which the tool's underside lies above its tip, at a distance of 0 to `radius` from the
  // axis.
  double rise(double distance) const {
    const double beyond = distance - flat();
    if (!(beyond > 0)) return 0;
    return corner - std::sqrt(std::max(0.0, (corner - beyond) * (corner + beyond)));
  }

  // The tool whose contacts are `allowance` mm off this one's all around, tip included.
  Cutter grown(double allowance) const { return {radius + allowance, corner + allowance}; }
};

}  // namespace evenload
