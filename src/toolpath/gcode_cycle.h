// Drilling, tapping and boring cycles as straight moves.
#pragma once

#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

struct DrillStroke {
  MoveKind kind = MoveKind::kCut;  // kRapid or kCut
  double z = 0;                    // mm, end
};

struct DrillCycle {
  double retract = 0;      // mm, the plane R
  double bottom = 0;       // mm, below it
  double peck = 0;         // mm, 0: in one feed
  bool to_top = false;     // between pecks up to the retract plane (G83), otherwise a little (G73)
  bool feeds_out = false;  // back to the retract plane, as taps, reamers and G85 do
};

// From the retract plane to the bottom, and with feeds_out back; without a last rapid up.
std::vector<DrillStroke> strokes_of(const DrillCycle& cycle);

}  // namespace evenload
