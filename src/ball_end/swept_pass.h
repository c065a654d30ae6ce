// How far a point lies from the curve along which the ball's centre went in an earlier pass.
#pragma once

#include "ball_end/worked_surface.h"

namespace evenload {

// A pass that is straight in step coordinates, through `through` in the direction `along`,
// length 1. Condition: points that are asked for lie no farther from the pass than the ball's
// surface does, on its lower half; there the nearest place is the only one. Tolerance: 1e-8 mm. Not
// for two threads at once: the nearest place is looked for from the last one on.
class SweptPass {
 public:
  SweptPass(const WorkedSurface& surface, Vec2 through, Vec2 along)
      : surface_(&surface), through_(through), along_(along) {}

  double distance(const Eigen::Vector3d& point) const;

 private:
  const WorkedSurface* surface_;
  Vec2 through_, along_;
  mutable double last_ = 0;
};

}  // namespace evenload
