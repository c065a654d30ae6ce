// Which part of the tool's circle touches material, found on dexels.
//
// Material touches the circle where stock stands higher than the tool's tip on it. On the right and
// left quarters of the circle that is asked row by row, on the upper and lower quarters column by
// column, so that dexels always cross the circle at 45 degrees or more. Where the answer changes
// between two of them, the stock's old border crosses the circle; its place is taken from the exact
// points where that border, outside of the circle, meets rows and columns. Inside, the tool itself
// has cut it off. Tolerance: an arc's end is exact up to the border's curvature over two spacings;
// arcs and gaps narrower than one spacing may be missed.
#pragma once

#include <vector>

#include "cutting/engaged_arc.h"
#include "simulate/dexel_stock.h"

namespace evenload {

// The circle of `radius` about `centre`, its tip at `z`, as seen along `feed_angle` (rad).
struct ToolCircle {
  Vec2 centre;
  double radius = 0;      // mm
  double z = 0;           // mm
  double feed_angle = 0;  // rad
};

// Replaces `arcs` by those between the angles `low` and `high` from the feed, in order from right
// to left. An arc's depth is its mean; where the height changes by more than the resolution, a new
// arc begins. Condition: -pi <= low < high <= pi.
void find_engaged_arcs(const DexelStock& stock, const ToolCircle& tool, double low, double high,
                       std::vector<EngagedArc>& arcs);

}  // namespace evenload
