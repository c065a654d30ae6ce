// The part of the tool's cylinder that touches material, as an arc of one depth.
#pragma once

namespace evenload {

// Angles are relative to the feed direction, seen from above, counter-clockwise positive: the left
// of the feed is +pi/2, its right -pi/2. The spindle turns clockwise, so a tooth enters at `high`
// and leaves at `low`. The arc reaches from the tool's tip upwards to `depth`.
// Condition: -pi/2 <= low <= high <= pi/2, depth >= 0.
struct EngagedArc {
  double low = 0, high = 0;  // rad
  double depth = 0;          // mm
};

}  // namespace evenload
