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
// Slots that are longer than that takes are made shorter first, and their paths longer after
// (slot_abridging.h): the time to compute does not grow with a slot's length, but for the output.
//
// A note tells of every region in which no pattern is repeated, and of patterns that have not
// settled.
#pragma once

#include <functional>
#include <optional>
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

// How the slots of a region are cleared: as clear_slots_of does it.
using SlotClearer = std::function<RegionResult(const RegionTask&, const ClearingParams&,
                                               PatternCache&, SlotsDone&, Progress&)>;

// Its two ways to get there. By way of shorter slots; nothing where none is long enough, or their
// path cannot be made longer.
std::optional<TrochoidalPath> clear_abridged_slots(const std::vector<Region>& regions,
                                                   PatternCache& patterns,
                                                   const SlotClearer& clear_slots,
                                                   const ClearingParams& params,
                                                   Progress& progress);
// As they are.
TrochoidalPath clear_whole_slots(const std::vector<Region>& regions, PatternCache& patterns,
                                 const ClearingParams& params, Progress& progress);

}  // namespace evenload
