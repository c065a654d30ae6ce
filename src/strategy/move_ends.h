// Shortens a way of moves at its ends.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

// Take `length` mm from the way's beginning, or its end, but never its last move. Condition: not
// empty.
void drop_first(std::vector<Segment>& moves, double length);
void drop_last(std::vector<Segment>& moves, double length);

}  // namespace evenload
