// Tight turns between arcs that are nearly as tight: a bi-arc takes their place and a part of their
// neighbours'. Where the curvature only rises along such a row, as along a pass into a corner, no
// single arc is tangent to the moves before and after [Kneser 1912: the circles of curvature of a
// spiral lie within each other].
#pragma once

#include <cstddef>
#include <vector>

#include "strategy/moves/turn_demands.h"

namespace evenload {

// `moves` with [first, last), tight turns tangent to each other, replaced by a bi-arc of which
// posts make no corners, from a place before them to one after, in the directions there; of those
// that fulfil the demands the one that replaces least. Empty where none does. Law: the moves begin
// and end where they did, in the same directions.
std::vector<Segment> with_wider_bi_arc(const std::vector<Segment>& moves, std::size_t first,
                                       std::size_t last, const TurnDemands& demands);

}  // namespace evenload
