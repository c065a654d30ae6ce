#include "dynamics/element.h"

#include <Eigen/LU>
#include <cmath>

#include "dynamics/collocation.h"

namespace evenload {

Eigen::Matrix2d free_motion(const Oscillator& mode, double time) {
  const double decay = mode.damping_ratio * mode.frequency;
  const double damped = mode.frequency * std::sqrt(1 - mode.damping_ratio * mode.damping_ratio);
  const double size = std::exp(-decay * time);
  const double c = size * std::cos(damped * time), s = size * std::sin(damped * time) / damped;
  Eigen::Matrix2d result;
  result << c + decay * s, mode.frequency * s, -mode.frequency * s, c - decay * s;
  return result;
}

ElementResponse::ElementResponse(const std::vector<Oscillator>& modes, int width, double length) {
  const int states = 2 * static_cast<int>(modes.size()), forces = kStages * width;
  value_by_state.setZero(forces, states);
  speed_by_state.setZero(forces, states);
  value_by_force.setZero(forces, forces);
  speed_by_force.setZero(forces, forces);
  end_by_state.setZero(states, states);
  end_by_force.setZero(states, forces);
  value_of_state.setZero(width, states);
  for (std::size_t r = 0; r < modes.size(); ++r) add(modes[r], static_cast<int>(r), width, length);
}

void ElementResponse::add(const Oscillator& mode, int number, int width, double h) {
  const Collocation& g = collocation();
  const double w = mode.frequency, drag = 2 * mode.damping_ratio * w;
  const Collocation::Square lhs =
      Collocation::Square::Identity() + drag * h * g.once + w * w * h * h * g.twice;
  // The accelerations at the nodes are `inverse` (force/mass) + `own` (displacement, velocity).
  const Collocation::Square inverse = lhs.partialPivLu().inverse();
  Eigen::Matrix<double, kStages, 2> own;
  own.col(0).noalias() = inverse.rowwise().sum() * (-w * w);
  own.col(1).noalias() = inverse * (-drag * Collocation::Values::Ones() - w * w * h * g.node);

  Eigen::Matrix<double, kStages, 2> value = h * h * (g.twice * own), speed = h * (g.once * own);
  value.col(0).array() += 1;
  value.col(1) += h * g.node;
  speed.col(1).array() += 1;
  const Collocation::Square value_force = (h * h / mode.mass) * (g.twice * inverse);
  const Collocation::Square speed_force = (h / mode.mass) * (g.once * inverse);
  Eigen::Matrix2d end = Eigen::Matrix2d::Identity();
  end(0, 1) = h;
  end.row(0) += h * h * (g.weight_twice.transpose() * own);
  end.row(1) += h * (g.weight.transpose() * own);
  Eigen::Matrix<double, 2, kStages> end_force;
  end_force.row(0) = (h * h / mode.mass) * (g.weight_twice.transpose() * inverse);
  end_force.row(1) = (h / mode.mass) * (g.weight.transpose() * inverse);
  // Velocities are told over the frequency.
  value.col(1) *= w;
  speed.col(1) *= w;
  end.col(1) *= w;
  end.row(1) /= w;
  end_force.row(1) /= w;

  end_by_state.block<2, 2>(2 * number, 2 * number) = end;
  for (int a = 0; a < width; ++a) {
    const double along = mode.direction[a];
    value_of_state(a, 2 * number) = along;
    for (int i = 0; i < kStages; ++i) {
      value_by_state.block<1, 2>(i * width + a, 2 * number) = along * value.row(i);
      speed_by_state.block<1, 2>(i * width + a, 2 * number) = along * speed.row(i);
      end_by_force.block<2, 1>(2 * number, i * width + a) = along * end_force.col(i);
      for (int b = 0; b < width; ++b) {
        const double both = along * mode.direction[b];
        for (int j = 0; j < kStages; ++j) {
          value_by_force(i * width + a, j * width + b) += both * value_force(i, j);
          speed_by_force(i * width + a, j * width + b) += both * speed_force(i, j);
        }
      }
    }
  }
}

}  // namespace evenload
