#include "toolpath/gcode_cycle.h"

#include <algorithm>

namespace evenload {
namespace {

// mm that the drill stays clear of the bottom on its way back down, and rises to break a chip:
// LinuxCNC's figure, 0.01 inch.
constexpr double kPeckClearance = 0.254;

}  // namespace

std::vector<DrillStroke> strokes_of(const DrillCycle& cycle) {
  std::vector<DrillStroke> strokes;
  if (cycle.peck > 0) {
    int i = 1;
    for (double z = cycle.retract - cycle.peck; z > cycle.bottom;
         z = cycle.retract - ++i * cycle.peck) {
      strokes.push_back({MoveKind::kCut, z});
      const double back = std::min(z + kPeckClearance, cycle.retract);
      if (cycle.to_top) strokes.push_back({MoveKind::kRapid, cycle.retract});
      strokes.push_back({MoveKind::kRapid, back});
    }
  }
  strokes.push_back({MoveKind::kCut, cycle.bottom});
  if (cycle.feeds_out) strokes.push_back({MoveKind::kCut, cycle.retract});
  return strokes;
}

}  // namespace evenload
