// Walls between two stages in one corner.
//
// In corners of some degrees, and in all whose stages are far apart, passes that turn round the
// corner by one arc each, which posts can write however tight it is, would need more stages than
// all the rest of a region together. So there they follow walls of their own: the corner alone,
// rounded by an arc that is as much tighter than what is cleared as keeps them to the engagement
// angle. Our own.
#pragma once

#include <optional>

#include "cutting/cleared_ground.h"
#include "strategy/stage.h"
#include "strategy/steering.h"

namespace evenload {

struct CornerWall {
  Stage stage;      // the corner alone
  WallPlace start;  // on its wall
};

// For a pass that starts at `start` on the wall of `stage` before a corner between walls that are
// straight or nearly so, which is cleared up to an arc. Nothing where the wall does not lead into
// such a corner, or no more than what the stage's own wall takes is to be taken at `engagement`
// rad.
std::optional<CornerWall> corner_wall(const Stage& stage, const WallPlace& start,
                                      const ClearedGround& ground, double engagement);

}  // namespace evenload
