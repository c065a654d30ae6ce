#include "dynamics/exact_chip.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

constexpr int kNewton = 20;
constexpr double kPeriodConverged = 1e-13;  // of the period
constexpr int kRounds = 40;
constexpr double kSettled = 1e-9;    // relative, of the motion
constexpr int kLooksAPeriod = 2000;  // at a period

}  // namespace

double exact_less_velocity(const OrbitSolver& solver, const Orbit& orbit, int tooth, double time) {
  const EdgeForces& forces = solver.forces();
  const Milling& m = forces.milling();
  const double period = solver.period(), speed = forces.speed();
  const double angle = speed * time + m.positions()[static_cast<std::size_t>(tooth)];
  const EdgeForces::Chip chip = forces.chip(tooth, time, orbit.speed(time));
  const auto wrapped = [&](double t) { return t - period * std::floor(t / period); };
  // Its own clock: `shift` later than a period before, when it stood at the same angle.
  const auto distance = [&](double shift) -> Eigen::Vector2d {
    const double own = angle + speed * shift;
    Eigen::Vector2d result = m.radius * Eigen::Vector2d(std::sin(angle) - std::sin(own),
                                                        std::cos(angle) - std::cos(own));
    result[0] += forces.feed_speed() * (period - shift);
    return result + orbit.value(time) - orbit.value(wrapped(time + shift));
  };
  double shift = 0;
  for (int i = 0; i < kNewton; ++i) {
    const double own = angle + speed * shift;
    Eigen::Vector2d way = m.radius * speed * Eigen::Vector2d(std::cos(own), -std::sin(own)) +
                          orbit.speed(wrapped(time + shift));
    way[0] += forces.feed_speed();
    const double step = chip.along.dot(distance(shift)) / chip.along.dot(way);
    shift += step;
    if (std::abs(step) < kPeriodConverged * period) break;
  }
  return chip.across.dot(distance(shift)) - chip.thickness;
}

double thickness_deviation(const OrbitSolver& solver, const Orbit& orbit) {
  double largest = 0;
  for (int i = 0; i < kLooksAPeriod; ++i) {
    const double time = solver.period() * (i + 0.5) / kLooksAPeriod;
    for (int tooth = 0; tooth < solver.forces().milling().teeth; ++tooth)
      if (solver.forces().is_engaged(tooth, time, orbit.depth))
        largest = std::max(largest, std::abs(exact_less_velocity(solver, orbit, tooth, time)));
  }
  return largest / solver.forces().feed();
}

bool solve_exactly(const OrbitSolver& solver, Orbit& orbit) {
  for (int round = 0; round < kRounds; ++round) {
    const Orbit before = orbit;
    orbit.correction = [&solver, before](int tooth, double time) {
      return exact_less_velocity(solver, before, tooth, time);
    };
    if (!solver.solve(orbit)) return false;
    if ((orbit.start - before.start).norm() < kSettled * orbit.start.norm()) return true;
  }
  return false;
}

}  // namespace evenload
