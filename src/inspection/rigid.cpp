#include "inspection/rigid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "inspection/smallest_peak.h"

namespace evenload {

namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d result;
  result << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return result;
}

Eigen::Matrix3d rotation(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (!(angle > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

// How the rotation turns on as its vector grows: R(v + dv) = R(J dv) R(v).
Eigen::Matrix3d turning(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const Eigen::Matrix3d cross = cross_matrix(turn);
  if (angle < 1e-4)  // the series, exact to the last digit there
    return Eigen::Matrix3d::Identity() + 0.5 * cross + cross * cross / 6;
  const double square = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / square * cross +
         (angle - std::sin(angle)) / (square * angle) * cross * cross;
}

// Lengths are in units of `size`, so that turns and shifts move the points alike.
struct Body {
  const Points& points;
  const Part& part;
  Eigen::Matrix3d axes;
  Eigen::Vector3d pivot;
  double size;
  std::vector<Eigen::Index> free;
};

class RigidDeviations final : public Deviations {
 public:
  RigidDeviations(const Body& body, Eigen::Matrix<double, 6, 1> state)
      : body_(body), state_(std::move(state)) {}

  Eigen::Index count() const override { return body_.points.cols(); }
  Eigen::Index freedom() const override { return static_cast<Eigen::Index>(body_.free.size()); }
  bool is_two_sided() const override { return true; }
  std::unique_ptr<Deviations> moved(const Eigen::VectorXd& step) const override {
    Eigen::Matrix<double, 6, 1> state = state_;
    for (Eigen::Index k = 0; k < step.size(); ++k)
      state[body_.free[static_cast<std::size_t>(k)]] += step[k];
    return std::make_unique<RigidDeviations>(body_, state);
  }
  Rows rows() const override {
    Which all(static_cast<std::size_t>(count()));
    std::iota(all.begin(), all.end(), Eigen::Index{0});
    return rows(all);
  }
  Rows rows(const Which& which) const override;

  Motion motion() const {
    return {body_.size * (body_.axes * state_.head<3>()), rotation(body_.axes * state_.tail<3>())};
  }

 private:
  const Body& body_;
  Eigen::Matrix<double, 6, 1> state_;  // shift / size, turn, along the axes
};

Rows RigidDeviations::rows(const Which& which) const {
  const auto size = static_cast<Eigen::Index>(which.size());
  const Motion now = motion();
  Points arms(3, size);
  for (Eigen::Index i = 0; i < size; ++i)
    arms.col(i) = now.turn * (body_.points.col(which[static_cast<std::size_t>(i)]) - body_.pivot);
  const Points places = arms.colwise() + (body_.pivot + now.shift);
  const Feet feet = body_.part(places, which);
  const Eigen::Matrix3d turned = turning(body_.axes * state_.tail<3>()) * body_.axes;
  Rows result{Eigen::VectorXd(size), Columns(freedom(), size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Vector3d n = feet.normals.col(i), arm = arms.col(i) / body_.size;
    result.values[i] = n.dot(places.col(i) - feet.points.col(i)) / body_.size;
    Eigen::Matrix<double, 6, 1> all;
    all << body_.axes.transpose() * n, turned.transpose() * arm.cross(n);
    for (Eigen::Index k = 0; k < freedom(); ++k)
      result.gradients(k, i) = all[body_.free[static_cast<std::size_t>(k)]];
  }
  return result;
}

}  // namespace

Profile profile(const Points& points, const Part& part, const ProfileTask& task) {
  if (points.cols() < 1) throw std::invalid_argument("There are no points: give one at least.");
  if (!points.allFinite())
    throw std::invalid_argument("A point has a coordinate that is not a number: leave it out.");
  Body body{points, part, task.axes, task.pivot, 0, {}};
  for (Eigen::Index k = 0; k < 6; ++k)
    if (task.is_free[static_cast<std::size_t>(k)]) body.free.push_back(k);
  // Where all shifts are free the pivot changes nothing but how well turns and shifts keep apart.
  if (task.is_free[0] && task.is_free[1] && task.is_free[2]) body.pivot = points.rowwise().mean();
  body.size = std::max((points.colwise() - body.pivot).colwise().norm().maxCoeff(), 1e-9);
  // The part answers in its own coordinates, which have their own last place.
  const double rounding = kRounding * std::max(1.0, points.cwiseAbs().maxCoeff() / body.size);
  Optimum best = smallest_peak(
      std::make_unique<RigidDeviations>(body, Eigen::Matrix<double, 6, 1>::Zero()), rounding);
  Motion motion = static_cast<const RigidDeviations&>(*best.at).motion();
  // Told about the caller's pivot.
  motion.shift += (body.pivot - task.pivot) - motion.turn * (body.pivot - task.pivot);
  return {2 * body.size * best.peak,  motion,
          body.size * best.values,    best.certificate.contacts,
          best.certificate.imbalance, best.certificate.is_proved};
}

}  // namespace evenload
