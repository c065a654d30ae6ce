// Trochoidal clearing of slots [Jacsó 2021, Thesis IV].
//
// 1. find_slots: the stretches of constant width, straight or bent.
// 2. The room at the start: the end of the longest stretch, or the ground about a pre-drilled hole,
//    up to the front that the pattern leaves, is cleared as any pocket is; at an open end the tool
//    starts outside.
// 3. slot_pattern is repeated along the stretch, and the room at its other end cleared; then along
//    every other stretch that it can begin in over cleared ground, whichever way.
// 4. What is left, the walls, and places of varying width, is cleared pass by pass.
#pragma once

#include <vector>

#include "strategy/pocket.h"
#include "strategy/slot_pattern.h"

namespace evenload {

struct TrochoidReport {
  double step = 0;      // mm, of the pattern that was used on the longest way; 0: none was
  int iterations = 0;   // passes until the pattern was settled; 0 for those found in one go
  double residual = 0;  // mm, at the end of the iteration
  double removal_rate =
      0;              // mm^3/min at the first level: walls finished, entry and ends not counted
  double length = 0;  // mm of slot along which a pattern is repeated
};

struct TrochoidalPath {
  Toolpath path;
  TrochoidReport report;
};

// Slots wider than this many tool diameters are pockets: they are cleared pass by pass.
inline constexpr double kWidestSlot = 4;

// Arguments and errors as for clear_pocket.
TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress);

}  // namespace evenload
