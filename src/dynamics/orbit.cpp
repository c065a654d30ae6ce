#include "dynamics/orbit.h"

#include <algorithm>
#include <cmath>

#include "dynamics/collocation.h"
#include "dynamics/element.h"
#include "dynamics/stability.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kElement = 0.9;  // rad of the fastest vibration in an element
constexpr int kNewton = 25;
constexpr double kConverged = 1e-11;  // relative
constexpr int kSwitchRounds = 6;      // until the instants at which the flank lets go are right
constexpr int kBisections = 50;
constexpr double kEntry = 1e-7;  // of the period
constexpr int kLooks = 32;       // at an element, for the amplitude

}  // namespace

Eigen::Vector2d Orbit::interpolated(const std::vector<Eigen::MatrixXd>& of, double time) const {
  const auto after = std::upper_bound(starts.begin(), starts.end(), time);
  const auto e = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - starts.begin() - 1));
  return of[e].transpose() * collocation().interpolation((time - starts[e]) / lengths[e]);
}

Eigen::Vector2d Orbit::value(double time) const { return interpolated(values, time); }
Eigen::Vector2d Orbit::speed(double time) const { return interpolated(speeds, time); }

double Orbit::amplitude() const {
  Eigen::Vector2d low = values[0].row(0), high = low;
  for (std::size_t e = 0; e < values.size(); ++e) {
    const double step = lengths[e] / kLooks;
    Eigen::Vector2d before = values[e].row(0), here = value(starts[e] + step);
    for (int i = 2; i <= kLooks; ++i) {
      const Eigen::Vector2d after =
          i < kLooks ? value(starts[e] + i * step) : Eigen::Vector2d(values[e].row(kStages + 1));
      for (int a = 0; a < 2; ++a) {
        // The parabola through three neighbours has its extreme among them.
        const double slope = 0.5 * (after[a] - before[a]);
        const double bend = before[a] - 2 * here[a] + after[a];
        const double extreme = std::abs(slope) < std::abs(bend)
                                   ? here[a] - 0.5 * slope * slope / bend
                                   : std::max(before[a], after[a]);
        low[a] = std::min({low[a], extreme, before[a], after[a]});
        high[a] = std::max({high[a], extreme, before[a], after[a]});
      }
      before = here;
      here = after;
    }
  }
  return 0.5 * (high - low).maxCoeff();
}

OrbitSolver::OrbitSolver(const EdgeForces& forces)
    : forces_(forces),
      components_(components_of(forces.milling().modes_along_feed())),
      period_(forces.milling().period_angle() / forces.speed()),
      fastest_(0) {
  for (const Mode& mode : forces.milling().modes) fastest_ = std::max(fastest_, mode.frequency);
  // Directions and chips turn with the spindle, too.
  fastest_ = std::max(fastest_, 4 * forces.speed());
}

std::vector<PeriodPiece> OrbitSolver::pieces(double depth, const std::vector<double>& more) const {
  std::vector<double> instants = more;
  for (const double angle : switching_angles(forces_.milling(), depth))
    for (const double position : forces_.milling().positions())
      instants.push_back((angle - position) / forces_.speed());
  std::vector<PeriodPiece> result;
  for (const PeriodPiece& piece : pieces_between(instants, period_)) {
    const double length = piece.end - piece.start;
    const int count = std::max(1, static_cast<int>(std::ceil(length * fastest_ / kElement)));
    for (int i = 0; i < count; ++i)
      result.push_back(
          {piece.start + length * i / count, piece.start + length * (i + 1) / count, true});
  }
  return result;
}

// One element: the forces at its nodes by Newton's method.
void OrbitSolver::pass(const PeriodPiece& piece, Orbit& orbit, End& end) const {
  const int width = components_.width, forces = kStages * width;
  const double length = piece.end - piece.start;
  const ElementResponse response(components_.modes, width, length);
  const Eigen::MatrixXd basis = components_.basis.leftCols(width);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(forces), speed;
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(forces, forces), lhs;
  for (int step = 0; step < kNewton; ++step) {
    speed = response.speed_by_state * end.state + response.speed_by_force * force;
    Eigen::VectorXd wanted(forces);
    for (int i = 0; i < kStages; ++i) {
      const EdgeForce found =
          forces_.at(piece.start + length * collocation().node[i],
                     basis * speed.segment(i * width, width), orbit.depth, orbit.correction);
      wanted.segment(i * width, width) = basis.transpose() * found.value;
      damping.block(i * width, i * width, width, width) = basis.transpose() * found.damping * basis;
    }
    lhs = Eigen::MatrixXd::Identity(forces, forces) + damping * response.speed_by_force;
    const Eigen::VectorXd change = solved(lhs, wanted - force);
    force += change;
    if (change.norm() <= kConverged * (force.norm() + 1e-9)) break;
  }
  speed = response.speed_by_state * end.state + response.speed_by_force * force;
  const Eigen::VectorXd value =
      response.value_by_state * end.state + response.value_by_force * force;
  Eigen::MatrixXd values(kStages + 2, 2), speeds(kStages + 2, 2);
  const auto place = [&](int row, const Eigen::VectorXd& state) {
    values.row(row) = (basis * (response.value_of_state * state)).transpose();
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(states());
    for (int r = 0; 2 * r < states(); ++r)
      moved[2 * r] = state[2 * r + 1] * components_.modes[static_cast<std::size_t>(r)].frequency;
    speeds.row(row) = (basis * (response.value_of_state * moved)).transpose();
  };
  place(0, end.state);
  for (int i = 0; i < kStages; ++i) {
    values.row(i + 1) = (basis * value.segment(i * width, width)).transpose();
    speeds.row(i + 1) = (basis * speed.segment(i * width, width)).transpose();
  }
  const Eigen::MatrixXd by_state =
      columns_solved(lhs, -damping * response.speed_by_state);  // of the forces
  end.by_start = (response.end_by_state + response.end_by_force * by_state) * end.by_start;
  end.state = response.end_by_state * end.state + response.end_by_force * force;
  place(kStages + 1, end.state);
  orbit.starts.push_back(piece.start);
  orbit.lengths.push_back(length);
  orbit.values.push_back(values);
  orbit.speeds.push_back(speeds);
}

OrbitSolver::End OrbitSolver::run(Orbit& orbit, const std::vector<double>& switches) const {
  orbit.starts.clear();
  orbit.lengths.clear();
  orbit.values.clear();
  orbit.speeds.clear();
  End end{orbit.start, Eigen::MatrixXd::Identity(states(), states())};
  for (const PeriodPiece& piece : pieces(orbit.depth, switches)) pass(piece, orbit, end);
  return end;
}

bool OrbitSolver::solve(Orbit& orbit) const {
  std::vector<double> instants;
  for (int round = 0; round < kSwitchRounds; ++round) {
    bool is_found = false;
    for (int step = 0; step < kNewton && !is_found; ++step) {
      const End end = run(orbit, instants);
      const Eigen::MatrixXd lhs = end.by_start - Eigen::MatrixXd::Identity(states(), states());
      const Eigen::VectorXd change = solved(lhs, orbit.start - end.state);
      if (!change.allFinite()) return false;
      orbit.start += change;
      is_found = change.norm() <= kConverged * (orbit.start.norm() + 1e-12);
    }
    if (!is_found) return false;
    run(orbit, instants);
    if (forces_.milling().process_damping == 0) break;
    std::vector<double> found = switches(orbit);
    double moved = found.size() == instants.size() ? 0 : 1;
    for (std::size_t i = 0; i < found.size() && found.size() == instants.size(); ++i)
      moved = std::max(moved, std::abs(found[i] - instants[i]) / period_);
    instants = std::move(found);
    if (moved < 1e-10) break;
  }
  return true;
}

std::vector<double> OrbitSolver::switches(const Orbit& orbit) const {
  std::vector<double> result;
  if (forces_.milling().process_damping == 0) return result;
  for (int tooth = 0; tooth < forces_.milling().teeth; ++tooth) {
    const auto inward = [&](double time) {
      return forces_.inward_speed(tooth, time, orbit.speed(time));
    };
    for (std::size_t e = 0; e < orbit.starts.size(); ++e)
      for (int i = 0; i < 2 * kStages; ++i) {
        double low = orbit.starts[e] + orbit.lengths[e] * i / (2 * kStages);
        double high = orbit.starts[e] + orbit.lengths[e] * (i + 1) / (2 * kStages) * (1 - 1e-12);
        if (!forces_.is_engaged(tooth, 0.5 * (low + high), orbit.depth)) continue;
        if ((inward(low) > 0) == (inward(high) > 0)) continue;
        for (int n = 0; n < kBisections; ++n) {
          const double middle = 0.5 * (low + high);
          ((inward(middle) > 0) == (inward(low) > 0) ? low : high) = middle;
        }
        // At its entry a tooth moves along the wall: that is no change.
        if (forces_.is_engaged(tooth, low - kEntry * period_, orbit.depth)) result.push_back(low);
      }
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::complex<double>> OrbitSolver::multipliers(const Orbit& orbit, double accuracy,
                                                           int wanted) const {
  PeriodicSystem system;
  system.modes = components_.modes;
  system.width = components_.width;
  system.period = period_;
  system.delays = {period_};
  system.fastest =
      std::max(fastest_, milling_system(forces_.milling(), forces_.speed(), orbit.depth).fastest);
  std::vector<double> instants = switches(orbit);
  for (const PeriodPiece& piece : pieces(orbit.depth, instants)) system.pieces.push_back(piece);
  system.coefficients = [&](double time, Coefficients& c) {
    const EdgeForce found = forces_.at(time, orbit.speed(time), orbit.depth, orbit.correction);
    c.stiffness = components_.basis.transpose() * found.stiffness * components_.basis;
    c.damping = components_.basis.transpose() * found.damping * components_.basis;
    c.delayed[0] = c.stiffness;
  };
  return evenload::multipliers(system, accuracy, wanted);
}

}  // namespace evenload
