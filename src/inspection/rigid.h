// Measured points that move as one body over a part, and how far they lie from it.
//
// The part answers for points with the nearest ones on it and its normals there. Degrees of freedom
// are shifts along x, y, z and turns about axes along them, through `pivot`, of the frame `axes`;
// the turns are one vector, so that a turn that is not free stays 0.
// Laws: distances are exact where the answers are; gradients are exact whatever the part.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "inspection/certificate.h"
#include "inspection/feature.h"

namespace evenload {

struct Feet {
  Points points, normals;  // normals of length 1, out of the part
};
// The nearest points of the part. Points come by their numbers, too, for a part that is known at
// these alone.
using Part = std::function<Feet(const Points& points, const Which& which)>;

// The motion: p -> pivot + turn (p - pivot) + shift, in the caller's frame.
struct Motion {
  Eigen::Vector3d shift;
  Eigen::Matrix3d turn;
};

struct ProfileTask {
  std::array<bool, 6> is_free;  // shifts along, turns about x, y, z of `axes`
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
};

struct Profile {
  double width;  // twice the largest distance
  Motion motion;
  Eigen::VectorXd deviations;  // signed distances after the motion, > 0: outside
  std::vector<Contact> contacts;
  double imbalance;
  bool is_proved;
};

// Smallest width over the motions left free [ISO 1101, profile of any surface]. Throws
// std::invalid_argument for points that are not finite, and what `part` throws.
Profile profile(const Points& points, const Part& part, const ProfileTask& task);

}  // namespace evenload
