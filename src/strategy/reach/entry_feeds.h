// The feeds of helix entries.
#pragma once

#include <vector>

#include "strategy/task/clearing_params.h"
#include "toolpath/level_turn.h"
#include "toolpath/planar.h"

namespace evenload {

// Of helix entries. Where the removal rate is held, the level turn gets as fast as gives chips as
// thick as a cut gets at the largest feed; with other controls it keeps the plunge feed, above
// which a slot's chips would be thicker than nominal.
LevelTurnFeeds entry_feeds(const ClearingParams& params);
// The level turn of a helix through a layer of `depth` mm.
std::vector<LevelPiece> level_turn(const Descent& helix, double depth,
                                   const ClearingParams& params);

}  // namespace evenload
