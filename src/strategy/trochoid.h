// Trochoidal clearing of slots [Jacsó 2021, Thesis IV].
//
// 1. find_slots: the stretches of constant width, straight or bent.
// 2. The room at the start: the end of the longest stretch, or the ground about a pre-drilled hole,
//    up to the front that the pattern leaves, is cleared as any pocket is; at an open end the tool
//    starts outside.
// 3. slot_pattern is repeated along the stretch, and the room at its other end cleared; then along
//    every other stretch that it can begin in over cleared ground, whichever way.
// 4. What is left, the walls, and places of varying width, is cleared pass by pass.
//
// A note tells of every region in which no pattern is repeated, and of patterns that have not
// settled.
#pragma once

#include <vector>

#include "strategy/pocket.h"
#include "strategy/slot_pattern.h"

namespace evenload {

// Of the longest way along which a pattern was repeated at once, in any region; all 0 where none
// was.
struct TrochoidReport {
  double step = 0;          // mm, of its pattern
  int iterations = 0;       // passes that were steered; 0 for patterns found in one go
  double residual = 0;      // mm, at the end of the iteration
  double removal_rate = 0;  // mm^3/min at the first level: the slot's width times its depth over
                            // the time per mm, links and wall passes in it, entry and ends not
  double longest = 0;       // mm, of this way
  double length = 0;        // mm of slot along which patterns are repeated, all regions together
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
