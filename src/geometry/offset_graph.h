// The second half of offset(): pieces cut where they meet, the parts on the true offset chained
// into loops. Internal to offset.cpp.
#pragma once

#include <vector>

#include "geometry/offset_pieces.h"

namespace evenload {

struct OffsetLoops {
  std::vector<Curve> loops;  // closed; the inside lies left of travel
  std::size_t touches = 0;   // points where loops touch themselves or each other
  double lost = 0;  // mm of pieces that belong to the offset beyond doubt and ended in no loop
};

// `d` as for offset_pieces, whose result the pieces are.
OffsetLoops offset_loops(const std::vector<OffsetPiece>& pieces, OffsetNodes& nodes,
                         const BoundaryIndex& boundary, double d,
                         const OffsetTolerances& tolerances);

}  // namespace evenload
