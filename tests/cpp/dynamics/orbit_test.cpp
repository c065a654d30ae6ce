// Periodic motions under velocity-dependent chips and a flank that lets go.
#include "dynamics/orbit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/cases.h"
#include "dynamics/exact_chip.h"
#include "dynamics/forced_motion.h"
#include "dynamics/orbit_branch.h"
#include "dynamics/stability.h"

namespace evenload {
namespace {

using namespace dynamics_cases;

Milling folding() {
  Milling m = milling({benchmark_mode()}, 3, false, 0.35);
  m.normal = 4e8;
  return m;
}

Orbit solved(const OrbitSolver& solver, double depth_mm) {
  Orbit orbit;
  orbit.start = Eigen::VectorXd::Zero(solver.states());
  for (int i = 1; i <= 10; ++i) {
    orbit.depth = 1e-4 * depth_mm * i;
    EXPECT_TRUE(solver.solve(orbit));
  }
  return orbit;
}

double radius(const OrbitSolver& solver, const Orbit& orbit) {
  return std::abs(solver.multipliers(orbit, 1e-7, 1).front());
}

TEST(Orbit, OfTheVelocityModelHasTheFoldsOfTheReference) {
  const EdgeForces forces(folding(), rpm(9266.1), 0.2e-3, ChipModel::kVelocity);
  Progress progress;
  const OrbitBranch branch = follow_branch(OrbitSolver(forces), {0.1e-3, 1e-3, 2.4e-3}, progress);
  std::vector<BranchPoint> folds;
  for (const BranchPoint& point : branch.points)
    if (point.is_fold) folds.push_back(point);
  ASSERT_EQ(folds.size(), 2U);
  const double depths[] = {2.295498, 1.54391}, amplitudes[] = {0.7887619, 0.6961828};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(1e3 * folds[i].depth / depths[i], 1, 5e-5);
    EXPECT_NEAR(1e3 * folds[i].amplitude / amplitudes[i], 1, 5e-5);
    double nearest = 1;
    for (const std::complex<double>& mu : folds[i].multipliers)
      nearest = std::min(nearest, std::abs(mu - 1.0));
    EXPECT_LT(nearest, 1e-4);
  }
  ASSERT_FALSE(branch.boundaries.empty());
  EXPECT_NEAR(1e3 * branch.boundaries[0].depth, 2.23009, 1e-4);
  EXPECT_EQ(kind_of(branch.boundaries[0].multipliers[0]), BoundaryKind::kFlip);
  std::vector<BranchPoint> wanted;
  for (const BranchPoint& point : branch.points)
    if (point.is_wanted) wanted.push_back(point);
  ASSERT_GE(wanted.size(), 2U);
  EXPECT_NEAR(1e3 * wanted[0].amplitude, 0.0549737, 1e-6);
  EXPECT_NEAR(wanted[0].radius(), 0.8876894, 1e-5);
  EXPECT_NEAR(1e3 * wanted[1].amplitude, 0.5219592, 1e-5);
  EXPECT_NEAR(wanted[1].radius(), 0.9390336, 1e-5);
}

TEST(Orbit, DeviatesFromTheExactPathAsTheReferenceSays) {
  const EdgeForces forces(folding(), rpm(9266.1), 0.2e-3, ChipModel::kVelocity);
  const OrbitSolver solver(forces);
  Orbit orbit = solved(solver, 1);
  EXPECT_NEAR(thickness_deviation(solver, orbit) / 0.09511465, 1, 0.02);
  const double plain = orbit.amplitude();
  EXPECT_TRUE(solve_exactly(solver, orbit));
  EXPECT_NEAR(orbit.amplitude() / plain, 1, 0.1);
  EXPECT_NE(orbit.amplitude(), plain);
}

TEST(Orbit, OfALargeToolIsTheClassicalForcedMotion) {
  Milling m = milling(unequal(), 3, false, 0.35, kLead);
  m.radius = 100;
  const EdgeForces forces(m, rpm(9000), 1e-6, ChipModel::kVelocity);
  const OrbitSolver solver(forces);
  const Orbit orbit = solved(solver, 0.3);
  const ForcedMotion motion = forced_motion(
      m, [&](double w) { return receptance(m.modes, w); }, rpm(9000), 0.3e-3, 1e-6);
  for (const double share : {0.1, 0.5, 0.8}) {
    const double time = share * solver.period();
    const Eigen::Vector2d expected = motion.at(rpm(9000) * time).value;
    EXPECT_LT((orbit.value(time) - expected).norm(), 2e-3 * expected.norm());
  }
  EXPECT_NEAR(radius(solver, orbit), spectral_radius(m, rpm(9000), 0.3e-3, 1e-6), 1e-4);
}

TEST(Orbit, WithAFlankThatLetsGoHasTheMultipliersOfTheReference) {
  Milling m = milling({benchmark_mode()}, 2, false, 0.25);
  m.process_damping = 4e5;
  m.flank_friction = 0.3;
  const struct {
    double speed, depth, amplitude, rho, linear;
  } rows[] = {{1500, 0.4, 6.4051, 0.2621599, 0.2258129},
              {3000, 0.8, 15.02038, 0.5713663, 0.3908452}};
  for (const auto& row : rows) {
    const EdgeForces forces(m, rpm(row.speed), 0.05e-3, ChipModel::kCircular);
    const OrbitSolver solver(forces);
    const Orbit orbit = solved(solver, row.depth);
    EXPECT_NEAR(1e6 * orbit.amplitude() / row.amplitude, 1, 1e-4);
    EXPECT_NEAR(radius(solver, orbit) / row.rho, 1, 2e-4);
    EXPECT_NEAR(spectral_radius(m, rpm(row.speed), 1e-3 * row.depth, 1e-6), row.linear, 1e-5);
  }
}

TEST(Orbit, WhoseFlankNeverLetsGoHasTheMultipliersOfTheLinearProcess) {
  Milling m = milling({benchmark_mode()}, 2, false, 0.25);
  m.process_damping = 1e3;
  m.flank_friction = 0.3;
  // So stiff that the vibration is slow against any feed.
  m.modes[0].mass = 400;
  const EdgeForces forces(m, rpm(3000), 0.5e-3, ChipModel::kCircular);
  const OrbitSolver solver(forces);
  const Orbit orbit = solved(solver, 0.5);
  EXPECT_TRUE(solver.switches(orbit).empty());
  EXPECT_NEAR(radius(solver, orbit), spectral_radius(m, rpm(3000), 0.5e-3, 1e-7), 1e-6);
}

TEST(Orbit, RefusesWhatItCannotFollow) {
  EXPECT_THROW(EdgeForces(uneven(), 100, 1e-4, ChipModel::kVelocity), std::invalid_argument);
  EXPECT_THROW(EdgeForces(folding(), 100, 0, ChipModel::kVelocity), std::invalid_argument);
  const EdgeForces forces(folding(), rpm(9000), 1e-4, ChipModel::kVelocity);
  Progress progress;
  EXPECT_THROW(follow_branch(OrbitSolver(forces), {0}, progress), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
