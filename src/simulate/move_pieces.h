// A move as pieces of the plane: a line, or arcs of a quarter circle at the most.
#pragma once

#include <vector>

#include "geometry/curve.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct MovePiece {
  Segment path;           // of no length in a vertical move
  double z0 = 0, z1 = 0;  // mm
};

// The pieces of `to`, which begins at the end of `from`, joined without gaps: where rounding made
// an arc's radii differ, they lead from one to the other.
std::vector<MovePiece> pieces_of(const Move& from, const Move& to);

}  // namespace evenload
