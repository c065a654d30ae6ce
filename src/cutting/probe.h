// What a tool meets where it is led: the question of its engagement, which everything that steers,
// joins, checks or prices moves asks.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/curve.h"

namespace evenload {

// mm: material thinner than this is not met by a tool that is steered: what has just been cut must
// not be found again by rounding.
inline constexpr double kThin = 1e-6;

// How many looks along `length` mm, one at least, are no further apart than `spacing` mm.
int looks_along(double length, double spacing);

// Asks one ground; the answer to a question lives until the next one.
class Probe {
 public:
  // As the ground is when it is asked.
  static constexpr std::size_t kNow = std::numeric_limits<std::size_t>::max();

  // `ground` must outlive this; it may change between two questions.
  explicit Probe(const ClearedGround& ground) : ground_(ground) {}

  // rad of the tool's leading half circle at `p`, led in the direction `heading` (rad), that touch
  // material thicker than `thin` mm; below 0: as if the tool were larger. As the ground was before
  // the move numbered `last`.
  double engagement(Vec2 p, double heading, double thin, std::size_t last = kNow);
  // The same at share `t` of a move.
  double engagement(const Segment& move, double t, double thin, std::size_t last = kNow);
  bool touches(const Segment& move, double t, double thin, std::size_t last = kNow) {
    look(move.point(t), angle_of(move.tangent(t)), thin, last);
    return !arcs_.empty();
  }
  // The same as arcs, in order, within [heading - pi/2, heading + pi/2].
  const std::vector<AngularInterval>& arcs(Vec2 p, double heading, double thin,
                                           std::size_t last = kNow) {
    look(p, heading, thin, last);
    return arcs_;
  }

 private:
  void look(Vec2 p, double heading, double thin, std::size_t last);

  const ClearedGround& ground_;
  std::vector<AngularInterval> arcs_;
};

}  // namespace evenload
