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

#include "strategy/pattern_cache.h"
#include "strategy/pocket.h"
#include "strategy/slot_clearing.h"
#include "strategy/slot_pattern.h"

namespace evenload {

struct TrochoidalPath {
  Toolpath path;
  TrochoidReport report;
};

// Arguments and errors as for clear_pocket.
TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress);

}  // namespace evenload
