// A path in the plane of one level, before it is given depths and feeds.
#pragma once

#include <optional>
#include <vector>

#include "geometry/curve.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct PlanarMove {
  MoveKind kind = MoveKind::kCut;  // kLink or kCut
  Segment segment;
  double feed = 0;        // mm/min, set by feed control
  int passage = -1;       // number of the narrow passage that a cut is made in
  double feed_limit = 0;  // mm/min, what feed control sets is lowered to; 0: none
  bool in_pattern = false;  // of a trochoid that repeats itself

  bool operator==(const PlanarMove&) const = default;
};

enum class DescentKind {
  kPlunge,  // straight down, in ground that holds no material
  kHelix,
  kRamp,
};

// How the tool comes down to the level.
struct Descent {
  DescentKind kind = DescentKind::kPlunge;
  Vec2 at;            // where it arrives; a helix's circle starts and ends here, and a ramp's way
  Vec2 centre;        // helix
  double radius = 0;  // mm, helix; it turns counter-clockwise
  std::vector<Vec2> ramp_by = {};    // ramp: the tool goes round by these, or to and fro
  bool over_cleared_ground = false;  // plunge where this level is already cleared by our own moves
  // helix: from its centre to the centre of the half circle that `at` is the middle of; zero for a
  // circle
  Vec2 stretch = {};
  std::optional<double> new_area =
      {};  // mm^2 that nothing cleared before; none: all that it clears

  bool operator==(const Descent&) const = default;
};

// What is cut between coming down and going up. The moves follow each other without gaps.
struct PlanarRun {
  Descent descent;
  std::vector<PlanarMove> moves;
  bool new_region = false;  // the first run of its region
};

}  // namespace evenload
