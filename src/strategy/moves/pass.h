// A pass: a cut without a break, and where one can begin.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/curve.h"

namespace evenload {

struct Pose {
  Vec2 p;
  double heading = 0;  // rad
};

struct WallPlace {
  std::size_t curve = 0, segment = 0;  // of Stage::centres
  double t = 0;
};

struct Pass {
  std::vector<Segment> moves;  // tangent to each other but for sharp corners of the exact border
  double cut_length = 0;       // mm with material in contact
  double cut_area = 0;         // mm^2 removed, nearly
  // mm without contact at both ends
  double idle_before = 0, idle_after = 0;
  bool empty() const { return moves.empty(); }
  // Condition: not empty.
  Pose start() const { return {moves.front().a, angle_of(moves.front().tangent(0))}; }
  Pose end() const { return {moves.back().b, angle_of(moves.back().tangent(1))}; }
};

}  // namespace evenload
