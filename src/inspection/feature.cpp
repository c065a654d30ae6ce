#include "inspection/feature.h"

#include <Eigen/Geometry>
#include <cmath>

namespace evenload {

Frame frame_of(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
               const Eigen::Vector3d& normal, double curvature) {
  Frame frame{origin, {}, curvature};
  const Eigen::Vector3d a = axis.normalized();
  Eigen::Vector3d n = normal - a.dot(normal) * a;
  if (!(n.norm() > 1e-12 * normal.norm())) n = a.unitOrthogonal();
  n.normalize();
  frame.axes << a, n, a.cross(n);
  return frame;
}

Eigen::Index freedom_of(Kind kind) {
  switch (kind) {
    case Kind::kPlanarLine:
      return 2;
    case Kind::kPlane:
    case Kind::kCircle:
      return 3;
    case Kind::kLine:
    case Kind::kSphere:
      return 4;
    case Kind::kCylinder:
      break;
  }
  return 5;
}

bool is_bent(Kind kind) {
  return kind == Kind::kCircle || kind == Kind::kSphere || kind == Kind::kCylinder;
}

std::unique_ptr<Deviations> FeatureDeviations::moved(const Eigen::VectorXd& step) const {
  Eigen::Vector3d shift(0, step[0], 0), turn = Eigen::Vector3d::Zero();
  switch (kind_) {
    case Kind::kPlanarLine:
    case Kind::kCircle:
      turn[0] = step[1];
      break;
    case Kind::kPlane:
    case Kind::kSphere:
      turn[0] = step[1];
      turn[2] = step[2];
      break;
    case Kind::kCylinder:
      turn = step.segment<3>(1);
      break;
    case Kind::kLine:
      shift[2] = step[1];
      turn.tail<2>() = step.tail<2>();
      break;
  }
  Frame frame = frame_;
  frame.origin += frame_.axes * shift;
  if (const double angle = turn.norm(); angle > 0)
    // By way of a unit quaternion, so that axes stay square after many steps.
    frame.axes = (Eigen::Quaterniond(frame_.axes) * Eigen::AngleAxisd(angle, turn / angle))
                     .normalized()
                     .toRotationMatrix();
  if (is_bent(kind_)) frame.curvature += step[step.size() - 1];
  return std::make_unique<FeatureDeviations>(kind_, points_, frame, usual_);
}

FeatureDeviations FeatureDeviations::parallel(double offset) const {
  Frame frame = frame_;
  frame.origin += offset * frame_.axes.col(1);
  frame.curvature /= 1 + offset * frame_.curvature;
  return {kind_, points_, frame};
}

double FeatureDeviations::row(const Eigen::Vector3d& point, double* gradient) const {
  const Eigen::Vector3d q = frame_.axes.transpose() * (point - frame_.origin);
  if (kind_ == Kind::kLine) {
    const double away = std::hypot(q[1], q[2]);
    // On the axis any direction is as good as another; none keeps the point where it is.
    const double inverse = usual_ > 0 ? 1 / usual_ : away > 0 ? 1 / away : 0;
    const double n = q[1] * inverse, t = q[2] * inverse;
    gradient[0] = -n;
    gradient[1] = -t;
    gradient[2] = t * q[0];
    gradient[3] = -n * q[0];
    return usual_ > 0 ? 0.5 * (away * away * inverse + usual_) : away;
  }
  const double k = frame_.curvature;
  const double along = kind_ == Kind::kSphere ? q[0] : 0;
  const double square = along * along + q[1] * q[1] + q[2] * q[2];
  const double a = k * square + 2 * q[1];
  const double root = std::sqrt(std::max(0.0, 1 + k * a));
  const double value = a / (1 + root);
  // Outwards at the point; at a centre there is no such direction.
  const double inverse = root > 0 ? 1 / root : 0;
  const Eigen::Vector3d u(k * along * inverse, (k * q[1] + 1) * inverse, k * q[2] * inverse);
  const double about_axis = u[1] * q[2] - u[2] * q[1], about_normal = u[2] * q[0] - u[0] * q[2],
               about_tangent = u[0] * q[1] - u[1] * q[0];
  const double by_curvature = 0.5 * (square - value * value) * inverse;
  *gradient++ = -u[1];
  *gradient++ = about_axis;
  if (kind_ == Kind::kCylinder) *gradient++ = about_normal;
  if (kind_ != Kind::kCircle && kind_ != Kind::kPlanarLine) *gradient++ = about_tangent;
  if (is_bent(kind_)) *gradient = by_curvature;
  return value;
}

Rows FeatureDeviations::rows() const {
  Rows result{Eigen::VectorXd(count()), Columns(freedom(), count())};
  for (Eigen::Index i = 0; i < count(); ++i)
    result.values[i] = row(points_.col(i), result.gradients.col(i).data());
  return result;
}

Rows FeatureDeviations::rows(const Which& which) const {
  const auto size = static_cast<Eigen::Index>(which.size());
  Rows result{Eigen::VectorXd(size), Columns(freedom(), size)};
  for (Eigen::Index i = 0; i < size; ++i)
    result.values[i] =
        row(points_.col(which[static_cast<std::size_t>(i)]), result.gradients.col(i).data());
  return result;
}

}  // namespace evenload
