// Rows of tangent moves as one bi-arc, without a look at what the tool meets along them.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

// What a bi-arc in place of a row may be.
struct BiArcLimits {
  double engagement = 0;      // rad, of a straight cut
  double tool_radius = 0;     // mm
  double shortest = 0;        // mm: no arc is shorter
  double most_curvature = 0;  // 1/mm, of either arc
};

// The bi-arc from where `row` begins to where it ends, in the same directions, along which the tool
// is expected to meet what differs least from what it meets along the row; empty where it would
// differ much along all that are tried. Condition: the row's moves are tangent to each other.
std::vector<Segment> likely_bi_arc(const std::vector<Segment>& row, const BiArcLimits& limits);

}  // namespace evenload
