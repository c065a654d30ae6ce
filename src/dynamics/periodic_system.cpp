#include "dynamics/periodic_system.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

// Of the period: instants that lie nearer are one, and H is wrong for as long.
constexpr double kOneInstant = 1e-9;
constexpr double kParallel = 1e-12;  // sine between two modes' directions

// Coefficients in components of q from the matrices of single teeth in the frame.
class ToothForces {
 public:
  ToothForces(const Milling& milling, double speed, double depth, const Eigen::Matrix2d& basis)
      : milling_(milling),
        speed_(speed),
        depth_(depth),
        basis_(basis),
        positions_(milling.positions()),
        flank_(milling.process_damping / (milling.radius * speed)) {}

  void operator()(double time, Coefficients& c) const {
    c.stiffness.setZero();
    c.damping.setZero();
    for (Eigen::Matrix2d& delayed : c.delayed) delayed.setZero();
    for (std::size_t j = 0; j < positions_.size(); ++j) {
      const Engaged engaged = engaged_depth(milling_, speed_ * time + positions_[j], depth_);
      if (engaged[0] == 0) continue;
      const Eigen::Matrix2d force =
          within(force_matrix(milling_.tangential, milling_.normal, engaged));
      c.stiffness += force;
      c.delayed[milling_.even() ? 0 : j] += force;
      if (flank_ > 0)
        c.damping += within(force_matrix(milling_.flank_friction * flank_, flank_, engaged));
    }
  }
  bool active(double time) const {
    return std::any_of(positions_.begin(), positions_.end(), [&](double position) {
      return engaged_depth(milling_, speed_ * time + position, depth_)[0] > 0;
    });
  }

 private:
  Eigen::Matrix2d within(const Eigen::Matrix2d& force) const {
    return basis_.transpose() * force * basis_;
  }

  Milling milling_;
  double speed_, depth_;
  Eigen::Matrix2d basis_;
  std::vector<double> positions_;
  double flank_;  // N s/m^2
};

// rad/s: no vibration under the force is faster.
double fastest_of(const Milling& m, double depth) {
  const double stiffness = m.teeth * depth * (m.tangential + m.normal);
  double fastest = 0;
  for (const Mode& mode : m.modes)
    fastest = std::max(fastest, std::hypot(mode.frequency, std::sqrt(0.5 * stiffness / mode.mass)));
  return fastest;
}

}  // namespace

Components components_of(const std::vector<Mode>& modes) {
  Components result{{}, Eigen::Matrix2d::Identity(), 2};
  const double first = modes.front().direction;
  const bool parallel = std::all_of(modes.begin(), modes.end(), [&](const Mode& mode) {
    return std::abs(std::sin(mode.direction - first)) < kParallel;
  });
  if (parallel) {
    result.width = 1;
    result.basis << std::cos(first), 0, std::sin(first), 0;
  }
  for (const Mode& mode : modes) {
    const Eigen::Vector2d along(std::cos(mode.direction), std::sin(mode.direction));
    result.modes.push_back(
        {mode.mass, mode.frequency, mode.damping_ratio, result.basis.transpose() * along});
  }
  return result;
}

std::vector<PeriodPiece> pieces_between(std::vector<double> instants, double period) {
  for (double& instant : instants) instant -= period * std::floor(instant / period);
  std::sort(instants.begin(), instants.end());
  std::vector<PeriodPiece> pieces;
  double start = 0;
  for (const double instant : instants) {
    if (instant - start < kOneInstant * period || period - instant < kOneInstant * period) continue;
    pieces.push_back({start, instant, true});
    start = instant;
  }
  pieces.push_back({start, period, true});
  return pieces;
}

PeriodicSystem milling_system(const Milling& milling, double speed, double depth) {
  const Components components = components_of(milling.modes_along_feed());
  PeriodicSystem system;
  system.modes = components.modes;
  system.width = components.width;
  system.period = milling.period_angle() / speed;
  system.fastest = fastest_of(milling, depth);
  if (milling.even()) {
    system.delays = {system.period};
  } else {
    for (const double angle : milling.tooth_angles) system.delays.push_back(angle / speed);
  }
  std::vector<double> instants;
  for (const double angle : switching_angles(milling, depth))
    for (const double position : milling.positions())
      instants.push_back((angle - position) / speed);
  const ToothForces forces(milling, speed, depth, components.basis);
  system.pieces = pieces_between(instants, system.period);
  for (PeriodPiece& piece : system.pieces)
    piece.active = forces.active(0.5 * (piece.start + piece.end));
  system.coefficients = forces;
  return system;
}

}  // namespace evenload
