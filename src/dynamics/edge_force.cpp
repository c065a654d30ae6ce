#include "dynamics/edge_force.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/collocation.h"

namespace evenload {

namespace {

constexpr double kTurn = 2 * M_PI;
constexpr double kStraight = 1e-9;  // rad of lag over the depth

}  // namespace

EdgeForces::EdgeForces(const Milling& milling, double speed, double feed_per_tooth, ChipModel chip)
    : milling_(milling),
      speed_(speed),
      feed_(feed_per_tooth),
      chip_(chip),
      positions_(milling.positions()) {
  check(milling);
  check_speed_and_depth(speed, 0);
  if (!milling.even())
    throw std::invalid_argument("Forced orbits know even pitch alone: set tooth_angles to None.");
  if (!(feed_per_tooth > 0) || !std::isfinite(feed_per_tooth))
    throw std::invalid_argument("The feed per tooth must be above 0 mm.");
}

EdgeForces::Chip EdgeForces::chip_at(double angle, const Eigen::Vector2d& velocity) const {
  const double s = std::sin(angle), c = std::cos(angle);
  if (chip_ == ChipModel::kCircular) return {feed_ * s, {c, -s}, {s, c}, milling_.radius * speed_};
  const Eigen::Vector2d way = milling_.radius * speed_ * Eigen::Vector2d(c, -s) + velocity +
                              feed_speed() * Eigen::Vector2d::UnitX();
  const double size = way.norm();
  const Eigen::Vector2d along = way / size, across(-along[1], along[0]);
  return {feed_ * across[0], along, across, size};
}

EdgeForces::Chip EdgeForces::chip(int tooth, double time, const Eigen::Vector2d& velocity) const {
  return chip_at(speed_ * time + positions_[static_cast<std::size_t>(tooth)], velocity);
}

double EdgeForces::inward_speed(int tooth, double time, const Eigen::Vector2d& velocity) const {
  const double angle = speed_ * time + positions_[static_cast<std::size_t>(tooth)];
  return std::sin(angle) * (velocity[0] + feed_speed()) + std::cos(angle) * velocity[1];
}

bool EdgeForces::is_engaged(int tooth, double time, double depth) const {
  return engaged_depth(milling_, speed_ * time + positions_[static_cast<std::size_t>(tooth)],
                       depth)[0] > 0;
}

// A piece of edge of this length at one angle.
void EdgeForces::add(double angle, double length, const Eigen::Vector2d& velocity,
                     double correction, EdgeForce& sum) const {
  const Chip cut = chip_at(angle, velocity);
  const double h = cut.thickness + correction;
  const Eigen::Vector2d push = milling_.tangential * cut.along + milling_.normal * cut.across;
  sum.value -= length * h * push;
  sum.stiffness += length * push * cut.across.transpose();
  if (chip_ == ChipModel::kVelocity) {
    const Eigen::Vector2d turned = milling_.tangential * cut.across - milling_.normal * cut.along;
    const double drawn = feed_ * cut.along[0];
    sum.damping += length / cut.speed * (turned * h - push * drawn) * cut.across.transpose();
  }
  if (milling_.process_damping == 0) return;
  const Eigen::Vector2d normal(std::sin(angle), std::cos(angle));
  const Eigen::Vector2d tangent(std::cos(angle), -std::sin(angle));
  const double inward = normal.dot(velocity) + normal[0] * feed_speed();
  if (inward <= 0) return;
  const Eigen::Vector2d flank = length * milling_.process_damping / (milling_.radius * speed_) *
                                (normal + milling_.flank_friction * tangent);
  sum.value -= flank * inward;
  sum.damping += flank * normal.transpose();
}

EdgeForce EdgeForces::at(double time, const Eigen::Vector2d& velocity, double depth,
                         const ThicknessCorrection& correction) const {
  EdgeForce sum;
  const double twist = milling_.twist(), lag = twist * depth;
  for (std::size_t j = 0; j < positions_.size(); ++j) {
    const double extra = correction ? correction(static_cast<int>(j), time) : 0;
    const double tip = speed_ * time + positions_[j];
    if (lag < kStraight) {
      const double rest = tip - kTurn * std::floor(tip / kTurn);
      if (rest > milling_.entry() && rest < milling_.exit()) add(rest, depth, velocity, extra, sum);
      continue;
    }
    // Of each turn of the helix the part between entry and exit.
    for (double turn = kTurn * std::floor((tip - lag) / kTurn); turn <= tip; turn += kTurn) {
      const double low = std::max(tip - lag, turn + milling_.entry());
      const double high = std::min(tip, turn + milling_.exit());
      if (high <= low) continue;
      for (int i = 0; i < kStages; ++i)
        add(low + (high - low) * collocation().node[i],
            (high - low) / twist * collocation().weight[i], velocity, extra, sum);
    }
  }
  return sum;
}

}  // namespace evenload
