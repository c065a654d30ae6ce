// Features through measured points: by least squares, or of minimum zone.
//
// Zone: by how much the deviations differ; in the zone of a plane all points lie between two
// parallel planes, of a circle, sphere or cylinder between two with the same centre or axis, of a
// line in the plane between two parallel lines; a line in space has the diameter of the narrowest
// cylinder that holds all points (ISO 1101). Conditions: lengths in any unit; a circle's points in
// space are first projected on the plane of least squares through them.
// Laws: the minimum zone is never wider than that of least squares; is_proved is true only where
// `certificate.h` proves it. Points are centred and scaled first, so that their distance from the
// origin costs no digits but those that it has cost already.
#pragma once

#include <vector>

#include "inspection/certificate.h"
#include "inspection/feature.h"

namespace evenload {

enum class Method { kLeastSquares, kMinimumZone };

struct FittedFeature {
  double zone = 0;
  // On the line, plane or axis, nearest to the points' mean; or the centre.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  // Of the line or axis, or normal to the plane, or to a circle's; none for spheres. Its largest
  // number is positive.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double radius = 0;
  Eigen::VectorXd deviations;  // > 0: outside, on the side of the direction, to the left of a line
  std::vector<Contact> contacts;
  double imbalance = 0;
  bool is_proved = false;
};

// `is_spatial`: whether a circle's points have z. Throws std::invalid_argument, in a sentence, for
// points that are too few, not finite or do not determine the feature.
FittedFeature fit(Kind kind, Method method, const Points& points, bool is_spatial);

}  // namespace evenload
