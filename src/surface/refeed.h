// The same path at other feeds, which may change within a move.
#pragma once

#include <cstddef>
#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

// A piece of a move, from the end of the piece before or the beginning of the move.
struct FedPiece {
  std::size_t move;
  double until;  // share of the move, 1 at its end
  double feed;   // mm/min
};

// Divides moves into pieces, in their order, with the feed of each, but downwards no faster than
// the plunge feed, mm/min, allows. Moves without a piece stay. Throws std::invalid_argument for
// pieces that are out of order, or do not fill their moves, and feeds that are not positive.
Toolpath with_feeds(const Toolpath& path, const std::vector<FedPiece>& pieces, double plunge_feed);

}  // namespace evenload
