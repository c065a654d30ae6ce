// Which part of the tool's circle touches material, found on dexels.
//
// Material touches the circle where stock stands higher than the tool's tip right outside of it.
// On the right and left quarters of the circle that is asked row by row, on the upper and lower
// quarters column by column, so that dexels always cross the circle at 45 degrees or more. Where
// the answer changes between two of them, the stock's old border crosses the circle; its place is
// taken from the exact points where that border, outside of the circle, meets rows and columns.
// Inside, the tool itself has cut it off. Tolerance: an arc's end is exact up to the border's
// curvature over two spacings; arcs and gaps narrower than one spacing may be missed.
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

// Replaces `arcs` by those of the leading half circle, in order from right to left; of the whole
// circle, from -pi to pi, where `all_round` says so. An arc's depth is its mean; where the height
// changes by more than the resolution, a new arc begins.
void find_engaged_arcs(const DexelStock& stock, const ToolCircle& tool, bool all_round,
                       std::vector<EngagedArc>& arcs);

}  // namespace evenload
