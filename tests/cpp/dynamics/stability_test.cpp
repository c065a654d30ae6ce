// Multipliers and critical depths of milling: reference values, and laws on random processes.
#include "dynamics/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "dynamics/cases.h"

namespace evenload {
namespace {

using namespace dynamics_cases;

constexpr double kChart = 1e-2;  // the accuracy of a chart

double rho(const Milling& m, double speed, double depth_mm, double accuracy = kAccurate) {
  return spectral_radius(m, rpm(speed), 1e-3 * depth_mm, accuracy);
}

TEST(Stability, HasTheMultipliersOfTheReferencePoints) {
  Milling turned_feed = unequal_helix();
  turned_feed.feed_direction = degrees(45);
  const struct {
    const char* name;
    Milling m;
    double speed, depth, expected;
  } points[] = {
      {"slot", slot(), 5000, 0.2, 0.8197428},
      {"slot", slot(), 5000, 0.5, 1.073976},
      {"slot", slot(), 5000, 0.7, 1.221556},
      {"half, climb", half(true), 5000, 0.5, 0.8123829},
      {"half, conventional", half(false), 5000, 0.5, 1.305859},
      {"0.05 D", milling({benchmark_mode()}, 2, true, 0.05), 15000, 1, 0.8183843},
      {"0.1 D", milling({benchmark_mode()}, 2, false, 0.1), 10000, 1, 1.032283},
      {"mode along y", milling({benchmark_mode(90)}, 2, true, 0.5), 8000, 0.5, 1.080613},
      {"two modes, slot", milling(isotropic(), 2, true, 1), 8000, 0.2, 1.674984},
      {"helix", milling(isotropic(), 2, true, 0.1, kLead), 8000, 2, 1.143437},
      {"islands", islands(), 11800, 3.2, 1.018161},
      {"unequal modes", milling(unequal(), 2, false, 0.5), 6000, 1, 1.281642},
      {"feed at 45 degrees", turned_feed, 7000, 2, 1.132581},
      {"even", milling(unequal(), 4, true, 0.5, kLead), 5000, 1, 1.064076},
      {"uneven", uneven(), 5000, 1, 0.593513},
      {"no flank", milling(isotropic(), 4, true, 0.25), 1500, 0.2, 0.7994887},
  };
  for (const auto& point : points) {
    EXPECT_NEAR(rho(point.m, point.speed, point.depth), point.expected, 2e-6) << point.name;
    EXPECT_NEAR(rho(point.m, point.speed, point.depth, kChart), point.expected, 1e-3) << point.name;
  }
}

TEST(Stability, HasTheMultiplierOfTheDelayedMathieuEquation) {
  PeriodicSystem mathieu;
  mathieu.modes = {{1, std::sqrt(3), 0.05 / std::sqrt(3), {1, 0}}};
  mathieu.width = 1;
  mathieu.period = 2 * M_PI;
  mathieu.pieces = {{0, mathieu.period, true}};
  mathieu.delays = {mathieu.period};
  mathieu.fastest = std::sqrt(5);
  mathieu.coefficients = [](double time, Coefficients& c) {
    c.stiffness.setZero();
    c.damping.setZero();
    c.delayed[0].setZero();
    c.stiffness(0, 0) = 2 * std::cos(time);
    c.delayed[0](0, 0) = -0.15;
  };
  EXPECT_NEAR(std::abs(multipliers(mathieu, 1e-7).front()), 0.5120523, 1e-7);
}

TEST(Stability, ConvergesWithAHighOrder) {
  const PeriodicSystem system = milling_system(slot(), rpm(5000), 0.7e-3);
  const double exact = std::abs(multipliers(system, 1e-9, 1, 2).front());
  double errors[3];
  for (int i = 0; i < 3; ++i)
    errors[i] = std::abs(std::abs(multipliers(system, 0.5, 12, 1 << i).front()) - exact);
  const double order = std::log2(errors[0] / errors[1]);
  std::printf("observed order of convergence %.1f, error %.1e at the coarsest\n", order, errors[0]);
  EXPECT_GT(order, 6);
  EXPECT_LT(errors[0], 0.02);
}

TEST(Stability, IsAccurateWhereManyVibrationsGoToAPeriod) {
  for (const double speed : {100.0, 300.0, 1000.0}) {
    const double expected = rho(half(true), speed, 0.3, 1e-8);
    EXPECT_NEAR(rho(half(true), speed, 0.3, 1e-3), expected, 1e-3);
    // At 100 rev/min some hundred multipliers are of nearly one size.
    EXPECT_NEAR(rho(half(true), speed, 0.3, kAccurate), expected, speed < 200 ? 5e-4 : kAccurate);
  }
}

TEST(Stability, HasTheCriticalDepthsOfTheReference) {
  const struct {
    Milling m;
    double speed, expected;
  } points[] = {
      {half(true), 5000, 0.8472035},
      {half(true), 7500, 1.611976},
      {half(true), 15000, 2.596238},
      {half(true), 22500, 0.6181367},
      {half(false), 5000, 0.26028},
      {half(false), 25000, 3.93172},
      {unequal_helix(), 5000, 0.8718324},
      {unequal_helix(), 7000, 0.4732818},
      {with_flank(), 1500, 3.376268},
      {with_flank(), 2500, 1.867955},
      {islands(), 11800, 2.12899},
      {islands(), 20000, 2.195787},
      {milling({benchmark_mode()}, 2, true, 0.05), 15000, 8.212475},
      {milling(unequal(), 4, true, 0.5, kLead), 5000, 0.7007653},
  };
  for (const auto& point : points) {
    const double depth = 1e3 * critical_depth(point.m, rpm(point.speed), 10e-3);
    EXPECT_NEAR(depth / point.expected, 1, 2e-5) << point.speed;
    EXPECT_NEAR(rho(point.m, point.speed, depth), 1, 2e-5);
  }
  EXPECT_TRUE(std::isinf(critical_depth(half(true), rpm(15000), 2.5e-3)));
}

TEST(Stability, CutsIslandsOutOfTheStableGround) {
  for (const double crossing : {2.12899, 4.036653, 5.386927})
    EXPECT_NEAR(rho(islands(), 11800, crossing), 1, 1e-5);
  EXPECT_GT(rho(islands(), 11800, 3), 1);
  EXPECT_LT(rho(islands(), 11800, 5), 1);
}

TEST(Stability, TellsChatterFromPeriodDoubling) {
  const auto at = [](const Milling& m, double speed, double depth) {
    return strongest_vibration(milling_system(m, rpm(speed), 1e-3 * depth));
  };
  const Vibration hopf = at(half(true), 5000, 0.8472035);
  EXPECT_EQ(kind_of(hopf.multiplier), BoundaryKind::kHopf);
  EXPECT_NEAR(hopf.frequency / (2 * M_PI), 897.4168, 1e-2);
  const Vibration flip = at(half(true), 15000, 2.596238);
  EXPECT_EQ(kind_of(flip.multiplier), BoundaryKind::kFlip);
  EXPECT_NEAR(flip.frequency / (2 * M_PI), 750, 1e-2);
  EXPECT_NEAR(at(half(false), 12500, 1.545039).frequency / (2 * M_PI), 1051.359, 1e-2);
  EXPECT_NEAR(at(unequal_helix(), 7000, 0.4732818).frequency / (2 * M_PI), 1312.763, 1e-2);
}

// How much a free vibration grows in a period, by small steps of Heun's method in time.
double simulated_growth(const Milling& m, double speed, double depth, int periods, int steps) {
  const double h = m.period_angle() / speed / steps;
  const Mode mode = m.modes[0];
  double q = 1e-6, v = 0, first = 0;
  std::vector<double> before(static_cast<std::size_t>(steps) + 1, 0), now = before;
  const auto acceleration = [&](int step, double at, double velocity, double was) {
    double force = 0;
    for (const double position : m.positions())
      force += force_matrix(m.tangential, m.normal,
                            engaged_depth(m, speed * h * (step + 1e-9) + position, depth))(0, 0);
    return -force / mode.mass * (at - was) - 2 * mode.damping_ratio * mode.frequency * velocity -
           mode.frequency * mode.frequency * at;
  };
  for (int n = 0; n < periods; ++n) {
    now[0] = q;
    double size = 0;
    for (int i = 0; i < steps; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double a = acceleration(i, q, v, before[k]);
      const double b = acceleration(i + 1, q + h * v, v + h * a, before[k + 1]);
      q += h * v + 0.5 * h * h * a;
      v += 0.5 * h * (a + b);
      now[k + 1] = q;
      size += q * q;
    }
    std::swap(before, now);
    if (n == periods / 2) first = size;
    if (n + 1 == periods) return std::pow(size / first, 0.5 / (periods - 1 - periods / 2));
  }
  return 0;
}

TEST(Stability, IsTheGrowthOfASimulationInTime) {
  for (const double depth : {0.2, 0.7}) {
    const double growth = simulated_growth(slot(), rpm(5000), 1e-3 * depth, 120, 4000);
    EXPECT_NEAR(growth, rho(slot(), 5000, depth), 4e-3);
  }
}

// ---- laws ----

class RandomMilling {
 public:
  explicit RandomMilling(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Milling milling(bool helical) {
    Milling m =
        dynamics_cases::milling({}, 1 + static_cast<int>(between(1, 4)), between(0, 1) < 0.5,
                                between(0.05, 1), helical ? between(0.01, 0.1) : 0);
    for (int i = 0; i < 3; ++i)
      m.modes.push_back(
          {between(0.03, 0.3), between(2000, 9000), between(0.01, 0.05), between(0, M_PI)});
    return m;
  }

 private:
  std::mt19937 random_;
};

TEST(Stability, OfEqualModesKnowsNeitherClimbNorTheFeedsDirection) {
  Milling m = milling(isotropic(), 2, true, 0.1, kLead);
  const double expected = rho(m, 8000, 2);
  m.feed_direction = 0.7;
  EXPECT_NEAR(rho(m, 8000, 2), expected, 1e-6);
  m.climb = false;
  EXPECT_NEAR(rho(m, 8000, 2), expected, 1e-6);
}

TEST(Stability, IsTheSameForTheOppositeFeed) {
  RandomMilling random(1);
  for (int i = 0; i < 5; ++i) {
    Milling m = random.milling(true);
    const double expected = rho(m, 7000, 1);
    m.feed_direction = M_PI;
    EXPECT_NEAR(rho(m, 7000, 1), expected, 1e-6 * expected);
  }
}

TEST(Stability, OfOneModeAlongTheFeedMirroredAndTurnedBackIsTheSame) {
  // Half a turn of the tool exchanges entry and exit with those of the other half of a slot.
  Milling m = milling({benchmark_mode(40)}, 2, true, 1.0);
  const double expected = rho(m, 9000, 0.3);
  m.climb = false;
  EXPECT_NEAR(rho(m, 9000, 0.3), expected, 1e-7);
}

TEST(Stability, WithoutDepthIsTheDecayOfTheLeastDampedMode) {
  RandomMilling random(3);
  for (int i = 0; i < 5; ++i) {
    const Milling m = random.milling(true);
    double least = 1e9;
    for (const Mode& mode : m.modes) least = std::min(least, mode.damping_ratio * mode.frequency);
    const double expected = std::exp(-least * m.period_angle() / rpm(6000));
    EXPECT_NEAR(rho(m, 6000, 0), expected, 1e-9);
    EXPECT_NEAR(rho(m, 6000, 1e-7), expected, 1e-5);
  }
}

TEST(Stability, OfStraightTeethDependsOnCoefficientTimesDepthOverMass) {
  RandomMilling random(4);
  for (int i = 0; i < 5; ++i) {
    const Milling m = random.milling(false);
    Milling harder = m, heavier = m;
    harder.tangential *= 3;
    harder.normal *= 3;
    for (Mode& mode : heavier.modes) mode.mass *= 2;
    const double expected = rho(m, 8000, 0.9);
    EXPECT_NEAR(rho(harder, 8000, 0.3), expected, 1e-7 * expected);
    EXPECT_NEAR(rho(heavier, 8000, 1.8), expected, 1e-7 * expected);
  }
}

TEST(Stability, OfUnevenTeethWithEqualAnglesIsAPowerOfTheEvenOnes) {
  for (Milling m : {milling(unequal(), 4, true, 0.5, kLead), milling(unequal(), 3, false, 0.25)}) {
    const double even = rho(m, 5000, 0.8);
    m.tooth_angles.assign(static_cast<std::size_t>(m.teeth), 2 * M_PI / m.teeth);
    EXPECT_NEAR(rho(m, 5000, 0.8) / std::pow(even, m.teeth), 1, 2e-5);
  }
}

TEST(Stability, OfALongLeadTendsToStraightTeeth) {
  Milling m = milling(unequal(), 4, true, 0.25, 1e3);
  const double expected = rho(milling(unequal(), 4, true, 0.25), 7000, 1);
  EXPECT_NEAR(rho(m, 7000, 1), expected, 1e-5);
  m.lead = 1e6;
  EXPECT_NEAR(rho(m, 7000, 1), expected, 1e-7);
}

TEST(Stability, OfATrivialDepthIsThatOfAConstantForce) {
  const Milling m = unequal_helix();
  const double depth = m.lead / m.teeth;
  const PeriodicSystem system = milling_system(m, rpm(7000), depth);
  Coefficients c;
  c.delayed.resize(1);
  system.coefficients(0, c);
  const Eigen::Matrix2d first = c.stiffness;
  for (int i = 1; i < 20; ++i) {
    system.coefficients(system.period * i / 20, c);
    EXPECT_NEAR((c.stiffness - first).norm(), 0, 1e-8 * first.norm());
  }
}

}  // namespace
}  // namespace evenload
