// Passes with fewer moves. Steering makes one arc after the other and cannot see what comes next;
// where three to five of its arcs can be two, a program has fewer blocks.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"
#include "strategy/constant_engagement.h"

namespace evenload {

// mm of a pass, from its beginning: what may be replaced.
struct Stretch {
  double from = 0, to = 0;
};

// `moves` with rows of three to five replaced by a bi-arc, from where the row began to where it
// ended, in the same directions: only within `stretch` mm, inside `centres`, with no tighter turn,
// at no more than `params`' engagement angle and a tolerance, and where the time that it costs at a
// constant removal rate is worth the blocks. `ground`: before the moves.
// Laws: the moves follow each other as before, and begin and end where they did; moves along the
// border of `centres` stay as they are, and so do passes that come back to where they were, which
// meet what they themselves have left.
std::vector<Segment> with_fewer_moves(const std::vector<Segment>& moves, const Stretch& stretch,
                                      const Area& centres, const ClearedGround& ground,
                                      const ClearingParams& params);

}  // namespace evenload
