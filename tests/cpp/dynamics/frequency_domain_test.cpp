// The zeroth order and the extended multi-frequency solution.
#include "dynamics/frequency_domain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/cases.h"
#include "dynamics/stability.h"

namespace evenload {
namespace {

using namespace dynamics_cases;

Receptance modal(const std::vector<Mode>& modes) {
  return [modes](double frequency) { return receptance(modes, frequency); };
}

FrequencyDomain domain(const Milling& m, int harmonics) { return {m, modal(m.modes), harmonics}; }

TEST(ZerothOrder, HasTheLimitsOfTheReference) {
  const auto slot_limits = zeroth_order(slot(), modal(slot().modes), hertz(930));
  ASSERT_EQ(slot_limits.size(), 1U);
  EXPECT_NEAR(slot_limits[0].depth, 0.3060867e-3, 1e-10);
  EXPECT_NEAR(slot_limits[0].phase, 4.951628, 1e-6);
  const Milling m = milling(isotropic(), 2, true, 1);
  EXPECT_NEAR(zeroth_order(m, modal(m.modes), hertz(930))[0].depth, 0.0635077e-3, 1e-10);
  const auto two = zeroth_order(unequal_helix(), modal(unequal()), hertz(1350));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_NEAR(two[0].depth / 0.6642542e-3, 1, 1e-6);
  EXPECT_NEAR(two[0].phase, 3.924869, 1e-6);
  EXPECT_NEAR(two[1].depth / 42.93512e-3, 1, 1e-6);
}

TEST(ZerothOrder, OfASlotHasItsLeastDepthWhereTheClosedFormSays) {
  const Mode mode = benchmark_mode();
  const double stiffness = mode.mass * mode.frequency * mode.frequency, zeta = mode.damping_ratio;
  const double frequency = mode.frequency * std::sqrt(1 + 2 * zeta);
  const auto least = zeroth_order(slot(), modal(slot().modes), frequency);
  EXPECT_NEAR(least[0].depth, 8 * stiffness * zeta * (1 + zeta) / (2 * 2e8), 1e-12);
  EXPECT_NEAR(least[0].depth, 0.2980538e-3, 1e-10);
  for (const double share : {0.999, 1.001})
    EXPECT_GT(zeroth_order(slot(), modal(slot().modes), share * frequency)[0].depth,
              least[0].depth);
}

TEST(FrequencyDomain, WithoutHarmonicsIsTheZerothOrder) {
  for (const Milling& m : {slot(), unequal_helix()}) {
    const double frequency = hertz(1350);
    for (const ZerothOrder& limit : zeroth_order(m, modal(m.modes), frequency))
      for (int lobe = 0; lobe < 3; ++lobe) {
        const double speed = frequency * m.period_angle() / (limit.phase + 2 * M_PI * lobe);
        EXPECT_LT(std::abs(domain(m, 0).determinant(speed, limit.depth, frequency)), 1e-9);
      }
  }
}

TEST(FrequencyDomain, HasTheLimitsOfTheReferenceForEachNumberOfHarmonics) {
  const struct {
    Milling m;
    double speed;
    int harmonics[4];
    double depth[4], frequency[4];
  } points[] = {
      {half(true),
       5000,
       {4, 10, 25, 60},
       {0.8478279, 0.8454869, 0.8471705, 0.8472013},
       {897.3927, 897.4053, 897.417, 897.4168}},
      {half(true),
       15000,
       {4, 10, 25, 60},
       {2.587295, 2.596081, 2.59623, 2.596238},
       {750.0955, 750.0003, 750.0, 750.0}},
      {half(false),
       12500,
       {4, 10, 25, 60},
       {1.541367, 1.545156, 1.545046, 1.545039},
       {1053.306, 1051.357, 1051.359, 1051.359}},
      {unequal_helix(),
       7000,
       {4, 10, 25, 60},
       {0.4805257, 0.4732875, 0.4732818, 0.4732818},
       {553.7271, 553.9036, 553.9038, 553.9038}},
  };
  for (const auto& point : points)
    for (int i = 0; i < 3; ++i) {
      double depth = 1e-3 * point.depth[i], frequency = hertz(point.frequency[i]);
      ASSERT_TRUE(
          domain(point.m, point.harmonics[i]).find_limit(rpm(point.speed), depth, frequency));
      EXPECT_NEAR(1e3 * depth / point.depth[i], 1, 1e-6) << point.speed << " " << i;
      EXPECT_NEAR(frequency / hertz(point.frequency[i]), 1, 1e-6);
    }
}

TEST(FrequencyDomain, AgreesWithTheMultipliersForUnevenPitch) {
  const Milling m = uneven();
  const double expected = critical_depth(m, rpm(5000), 5e-3);
  EXPECT_NEAR(1e3 * expected, 1.547226, 2e-5);
  const Vibration vibration = strongest_vibration(milling_system(m, rpm(5000), expected));
  double depth = expected, frequency = vibration.frequency;
  ASSERT_TRUE(domain(m, 40).find_limit(rpm(5000), depth, frequency));
  EXPECT_NEAR(depth / expected, 1, 1e-4);
}

TEST(FrequencyDomain, OfATrivialDepthIsTheSameForEachNumberOfHarmonics) {
  const Milling m = unequal_helix();
  const double depth = m.lead / m.teeth, frequency = hertz(810);
  const auto zeroth = domain(m, 0).determinant(rpm(7000), depth, frequency);
  for (int order = 1; order < 6; ++order)
    EXPECT_LT(force_harmonic(m, depth, order * m.teeth).norm(), 1e-9 * 6e8 * depth);
  // With more harmonics the determinant is the product of those of each frequency.
  auto product = zeroth;
  const double base = m.teeth * rpm(7000);
  for (int k = 1; k <= 3; ++k)
    for (const int sign : {-1, 1})
      product *= domain(m, 0).determinant(rpm(7000), depth, frequency + sign * k * base);
  EXPECT_LT(std::abs(domain(m, 3).determinant(rpm(7000), depth, frequency) / product - 1.0), 1e-9);
}

TEST(FrequencyDomain, CountsGrowingVibrations) {
  const double limit = 0.8472035e-3, highest = hertz(5000);
  const FrequencyDomain d = domain(half(true), 12);
  EXPECT_EQ(d.unstable_count(rpm(5000), 0.95 * limit, highest), 0);
  EXPECT_EQ(d.unstable_count(rpm(5000), 1.05 * limit, highest), 2);
  EXPECT_EQ(d.unstable_count(rpm(15000), 1e-3 * 2.5, highest), 0);
  EXPECT_EQ(d.unstable_count(rpm(15000), 1e-3 * 2.7, highest), 1);
  const FrequencyDomain zeroth = domain(slot(), 0);
  EXPECT_EQ(zeroth.unstable_count(rpm(7000), 0.29e-3, highest), 0);
}

TEST(Frf, SampledFromModesGivesTheLimitsOfTheModes) {
  std::vector<double> frequencies;
  Frf::Values xx, yy;
  for (double f = 20; f < 5000; f += 0.5) {
    frequencies.push_back(hertz(f));
    const Eigen::Matrix2cd value = receptance(unequal(), hertz(f));
    xx.push_back(value(0, 0));
    yy.push_back(value(1, 1));
  }
  const Frf frf(frequencies, xx, yy, {});
  double depth = 0.4732875e-3, frequency = hertz(553.9036);
  ASSERT_TRUE(FrequencyDomain(unequal_helix(), frf, 10).find_limit(rpm(7000), depth, frequency));
  EXPECT_NEAR(depth / 0.4732875e-3, 1, 1e-4);
  EXPECT_LT((frf(-hertz(700)) - frf(hertz(700)).conjugate()).norm(), 1e-20);
}

TEST(Frf, RefusesWhatIsNone) {
  EXPECT_THROW(Frf({1, 2, 3}, {1, 1, 1}, {}, {}), std::invalid_argument);
  EXPECT_THROW(Frf({1, 2, 2, 4}, {1, 1, 1, 1}, {}, {}), std::invalid_argument);
  EXPECT_THROW(Frf({1, 2, 3, 4}, {1, 1, NAN, 1}, {}, {}), std::invalid_argument);
  EXPECT_THROW(Frf({1, 2, 3, 4}, {1, 1, 1}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
