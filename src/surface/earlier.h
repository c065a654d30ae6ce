// How far from places on a path an earlier pass has cut, in plan.
//
// Laws: the same numbers on any number of threads; a place's own pass is no neighbour of it, nor is
// what comes later.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/vec2.h"
#include "support/progress.h"

namespace evenload {

struct PlanSegment {
  Vec2 from, to;
};

struct PlaceOnPath {
  Vec2 at;
  Vec2 way;             // along the feed; of length 0 where it is upright
  std::size_t segment;  // on which it lies
};

// mm to the left and to the right of the feed; infinite where there is none.
struct EarlierBeside {
  double left = HUGE_VAL, right = HUGE_VAL;
};

// What is nearer than this share of the reach is the same pass.
inline constexpr double kOwnPass = 0.02;

// Where the lines across the feed meet segments before a place's own, no further off than `reach`,
// mm. Throws Cancelled.
std::vector<EarlierBeside> earlier_beside(const std::vector<PlanSegment>& segments,
                                          const std::vector<PlaceOnPath>& places, double reach,
                                          int threads, Progress& progress);

}  // namespace evenload
