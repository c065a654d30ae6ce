// Edges that meet end to end, in any order and sense, as curves.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/curve.h"

namespace evenload {

struct Piece {
  Curve curve;             // open
  double z = 0;            // mm
  double end_error = 0;    // mm, how far its ends may lie from those of its neighbours
  std::size_t member = 0;  // where it came from, for errors
};

struct Loop {
  Curve curve;  // of either sense
  double z = 0;
  std::size_t member = 0;  // of its first piece
};

// Ends further apart than this, in mm, do not meet unless their end errors say so: what CAD
// programs leave between ends that they draw as one, and a fifth of the tolerance that paths are
// made to by default.
inline constexpr double kJoinGap = 1e-3;

// Closed curves in the order of their first pieces. Throws ShapeError (kOpen, kBranching) with the
// place and the piece's member.
std::vector<Loop> join(const std::vector<Piece>& pieces);

// The same with open curves, which come first; where more than two ends meet the curves end.
std::vector<Loop> join_chains(const std::vector<Piece>& pieces);

}  // namespace evenload
