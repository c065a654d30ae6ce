// Lines, planes, circles, spheres and cylinders, and how far points lie from them.
//
// A feature stands in a frame on its surface: `axis`, `normal` outwards and `tangent`, and is bent
// by `curvature`. A point q from the frame's origin (less its part along a cylinder's axis) then
// lies A/(1 + sqrt(1 + k A)), A = k q.q + 2 q.normal, outside: exact for any curvature k, down to
// flat arcs whose centre is far away, and 0 for a plane.
// Source: G. Lukács, R. Martin, D. Marshall, Faithful least-squares fitting of spheres, cylinders,
// cones and tori, ECCV 1998. A line in space stands in its own axis; its distances have no sign.
#pragma once

#include "inspection/deviations.h"

namespace evenload {

enum class Kind { kPlanarLine, kLine, kPlane, kCircle, kSphere, kCylinder };

// Points in columns. Those of planar lines and circles have z = 0.
using Points = Eigen::Matrix3Xd;

struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: axis, normal, tangent
  double curvature = 0;
};

// A frame with this axis and this normal, which is made square to the axis; any where it has no
// such part.
Frame frame_of(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
               const Eigen::Vector3d& normal, double curvature);

// The number of numbers that place a feature.
Eigen::Index freedom_of(Kind kind);
bool is_bent(Kind kind);

class FeatureDeviations final : public Deviations {
 public:
  // Condition: `points` outlives this and what is made by `moved`.
  // `usual`: for lines in space; where it is above 0 a distance d counts as (d^2 / usual + usual)
  // / 2. That rises with d, is the same and as steep where d is usual, and all points bend it
  // alike.
  FeatureDeviations(Kind kind, const Points& points, const Frame& frame, double usual = 0)
      : kind_(kind), points_(points), frame_(frame), usual_(usual) {}

  Eigen::Index count() const override { return points_.cols(); }
  Eigen::Index freedom() const override { return freedom_of(kind_); }
  bool is_two_sided() const override { return kind_ != Kind::kLine; }
  std::unique_ptr<Deviations> moved(const Eigen::VectorXd& step) const override;
  Rows rows() const override;
  Rows rows(const Which& which) const override;

  const Frame& frame() const { return frame_; }
  // The parallel feature whose deviations are smaller by `offset`. Condition: it is no line in
  // space.
  FeatureDeviations parallel(double offset) const;

 private:
  // The deviation of a point; `gradient` is a column of freedom() numbers.
  double row(const Eigen::Vector3d& point, double* gradient) const;

  Kind kind_;
  const Points& points_;
  Frame frame_;
  double usual_;
};

}  // namespace evenload
