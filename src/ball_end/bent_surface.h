// A place of any smooth face: its two curvatures, and how it lies to the tool's axis.
//
// The face is taken for the part of a torus that has both curvatures there, whose offsets are tori
// again: a plane, a cylinder and a sphere are among them. Step coordinates run along both principal
// directions. Laws: one curvature of 0 makes a cylinder's chips; both equal make a sphere's, which
// do not depend on the direction of feed.
#pragma once

#include "ball_end/worked_surface.h"

namespace evenload {

struct BentPlace {
  double first = 0, second = 0;  // principal curvatures, 1/mm, > 0: convex
  double slope = 0;              // rad from the tool's axis to the normal
  double towards = 0;            // rad from the first principal direction to where the normal leans
};

class BentSurface final : public WorkedSurface {
 public:
  // Throws std::invalid_argument where the ball does not fit, and for Steps::kPlan.
  BentSurface(const BentPlace& place, double ball_radius, Steps steps);

  PathPoint centre(Vec2 at, Vec2 along) const override;
  double distance(const Eigen::Vector3d& point) const override;
  Eigen::Vector3d normal(Vec2 at) const override;

 private:
  double first_, second_, ball_radius_;
  Vec2 stretch_;             // mm of the centre's way for a mm of the step coordinates
  Eigen::Matrix3d to_tool_;  // from principal directions and normal to the tool's frame
};

}  // namespace evenload
