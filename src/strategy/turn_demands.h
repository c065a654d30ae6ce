// What moves in place of a tight turn must fulfil.
#pragma once

#include <cstddef>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/curve.h"
#include "strategy/area.h"

namespace evenload {

struct TurnDemands {
  const Area& centres;    // inside which they stay
  const Area& exact;      // turns along whose border they must not replace
  double widening;        // mm: how far the old moves may be to the right of them
  double deepening;       // mm: and to the left
  ClearedGround& ground;  // before the moves
  double engagement;      // rad, the most that is met
};

// A place of a row of moves, as the share `t` of one of them.
struct MoveCut {
  std::size_t move = 0;
  double t = 0;
};

// Of unit vectors along moves between which the way counts as smooth: a third of what is a corner
// in a posted program.
inline constexpr double kSmoothJoint = 6e-3;

// What stays of a move is long enough to be posted as it is, and no tight turn itself.
bool can_stay(const Segment& move, double from, double to);

// True for an arc off the border of `exact`.
bool may_give_way(const Segment& move, const TurnDemands& demands);

// The moves from one place to the other, the first and the last as parts.
std::vector<Segment> parts_between(const std::vector<Segment>& moves, const MoveCut& from,
                                   const MoveCut& to);

// The moves with `way` in place of what lies between.
std::vector<Segment> replaced(const std::vector<Segment>& moves, const MoveCut& from,
                              const MoveCut& to, const std::vector<Segment>& way);

// True where every look along the old moves is as near to the new ones as is demanded.
bool is_near(const std::vector<Segment>& way, const std::vector<Segment>& old,
             const TurnDemands& demands);

// True where a mean over kMeanLength mm that ends on `way`, which is made after `before`, is above
// the limit, or over a shorter `way` alone: what follows may be met as well. The ground is left as
// it was.
bool meets_too_much(const std::vector<Segment>& before, const std::vector<Segment>& way,
                    const TurnDemands& demands);

}  // namespace evenload
