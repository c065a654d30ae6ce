// Forced vibration, and the wall that it leaves.
#include "dynamics/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/cases.h"
#include "dynamics/stability.h"

namespace evenload {
namespace {

using namespace dynamics_cases;

constexpr double kMicrometre = 1e-6;
constexpr double kFeed = 0.1e-3;

Milling helical(bool climb) {
  Milling m = milling(isotropic(), 2, climb, 0.1, 2 * M_PI * 4e-3);
  m.radius = 4e-3;
  return m;
}

Receptance modal(const Milling& m) {
  return [modes = m.modes](double frequency) { return receptance(modes, frequency); };
}

Surface surface(const Milling& m, double speed, double depth_mm, double feed = kFeed) {
  return {m, modal(m), rpm(speed), 1e-3 * depth_mm, feed};
}

TEST(Surface, HasTheFiguresOfTheReference) {
  const struct {
    bool climb;
    double speed, depth, location, least, most, roughness, waviness;
  } rows[] = {
      {false, 9000, 1.0, -13.38444, -13.38444, -2.597601, 0.3242457, 10.78684},
      {false, 9220, 1.5, 42.0466, -26.74543, 42.0466, 0.2800437, 68.79203},
      {true, 9000, 1.0, 50.4793, 5.128634, 50.4793, 0.4418585, 45.35067},
      {true, 9220, 1.5, 139.9765, -122.666, 139.9765, 0.5831378, 262.6425},
  };
  for (const auto& row : rows) {
    const SurfaceFigures found = surface(helical(row.climb), row.speed, row.depth).figures();
    EXPECT_NEAR(found.location_error / kMicrometre, row.location, 1e-4 * std::abs(row.location));
    EXPECT_NEAR(found.least / kMicrometre, row.least, 1e-3);
    EXPECT_NEAR(found.most / kMicrometre, row.most, 1e-3);
    EXPECT_NEAR(found.roughness / kMicrometre, row.roughness, 1e-4) << row.speed;
    EXPECT_NEAR(found.waviness / kMicrometre, row.waviness, 1e-3);
  }
}

TEST(Surface, IsLeastWavyAtTheOptimalDepths) {
  const struct {
    double speed, depth, waviness[3];
  } rows[] = {{13830, 6.283185, {448.8426, 39.05629, 441.63}},
              {9220, 4.18879, {268.3633, 42.80051, 219.0433}},
              {6915, 3.141593, {161.8699, 36.29844, 147.7946}}};
  for (const auto& row : rows)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(
          surface(helical(true), row.speed, row.depth * (0.75 + 0.25 * i)).location().waviness /
              kMicrometre,
          row.waviness[i], 1e-3 * row.waviness[i]);
}

TEST(Surface, HasNoWavesAtTheTrivialDepth) {
  const Milling m = helical(true);
  for (const double speed : {5000.0, 9220.0, 13000.0})
    EXPECT_LT(surface(m, speed, 1e3 * m.lead / m.teeth).location().waviness / kMicrometre, 1e-6);
}

TEST(Surface, OfARigidToolIsTheTrochoids) {
  for (const bool climb : {false, true}) {
    Milling m = helical(climb);
    for (Mode& mode : m.modes) mode.mass = 1e9;
    const SurfaceFigures found = surface(m, 9000, 1).figures();
    EXPECT_NEAR(found.location_error, 0, 1e-12);
    EXPECT_NEAR(found.waviness, 0, 1e-12);
    const double plain = kFeed * kFeed / (8 * m.radius);
    const double trochoid = (climb ? -1 : 1) * m.teeth * kFeed / (2 * M_PI * m.radius);
    EXPECT_NEAR(found.roughness / plain, std::pow(1 + trochoid, -2), 1e-4);
  }
}

TEST(Surface, OfAStraightToolHasNoWaviness) {
  Milling m = helical(false);
  m.lead = 0;
  const SurfaceFigures found = surface(m, 9000, 1).figures();
  EXPECT_EQ(found.waviness, 0);
  EXPECT_GT(std::abs(found.location_error), 1e-6);
}

TEST(Surface, ProfileHasItsCrestsAndCuspsWhereTheFiguresSay) {
  const Surface s = surface(helical(false), 9000, 1);
  for (const double z : {0.0, 0.4e-3, 1e-3}) {
    double least = 1, most = -1;
    for (int i = 0; i <= 2000; ++i) {
      const double n = s.offset(z, kFeed * i / 2000);
      least = std::min(least, n);
      most = std::max(most, n);
    }
    EXPECT_NEAR(most, s.location_error(z), 1e-10);
    EXPECT_LE(most - least, s.figures().roughness + 1e-10);
    EXPECT_GT(most - least, 0.5 * s.figures().roughness);
    EXPECT_NEAR(s.offset(z, 0.3 * kFeed), s.offset(z, 1.3 * kFeed), 1e-12);
  }
}

TEST(Surface, OfUnevenTeethWithEqualAnglesIsThatOfEvenOnes) {
  Milling m = helical(false);
  const SurfaceFigures even = surface(m, 9000, 1).figures();
  m.tooth_angles = {M_PI, M_PI};
  const SurfaceFigures uneven = surface(m, 9000, 1).figures();
  EXPECT_NEAR(uneven.location_error, even.location_error, 2e-9);
  EXPECT_NEAR(uneven.roughness, even.roughness, 1e-9);
}

// q'' = (F - H (q - q_before) - fz H e_x)/m - ..., by small steps of Heun's method.
Eigen::Vector2d simulated_end(const Milling& m, double speed, double depth, int periods,
                              int steps) {
  const double period = m.period_angle() / speed, h = period / steps;
  const Mode mode = m.modes[0];  // both are alike
  Eigen::Vector2d q = Eigen::Vector2d::Zero(), v = q;
  std::vector<Eigen::Vector2d> before(static_cast<std::size_t>(steps) + 1, q), now = before;
  const auto acceleration = [&](double time, const Eigen::Vector2d& at,
                                const Eigen::Vector2d& speed_at,
                                const Eigen::Vector2d& was) -> Eigen::Vector2d {
    Eigen::Matrix2d force = Eigen::Matrix2d::Zero();
    for (const double position : m.positions())
      force +=
          force_matrix(m.tangential, m.normal, engaged_depth(m, speed * time + position, depth));
    const Eigen::Vector2d cut = -force * (at - was + kFeed * Eigen::Vector2d::UnitX());
    return cut / mode.mass - 2 * mode.damping_ratio * mode.frequency * speed_at -
           mode.frequency * mode.frequency * at;
  };
  for (int n = 0; n < periods; ++n) {
    now[0] = q;
    for (int i = 0; i < steps; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Eigen::Vector2d a = acceleration(i * h, q, v, before[k]);
      const Eigen::Vector2d b = acceleration((i + 1) * h, q + h * v, v + h * a, before[k + 1]);
      q += h * v + 0.5 * h * h * a;
      v += 0.5 * h * (a + b);
      now[k + 1] = q;
    }
    std::swap(before, now);
  }
  return q;
}

TEST(ForcedMotion, IsTheSteadyStateOfASimulation) {
  const Milling m = helical(false);
  const double speed = rpm(9000), depth = 1e-3;
  ASSERT_LT(spectral_radius(m, speed, depth, 1e-3), 0.8);
  const Eigen::Vector2d end = simulated_end(m, speed, depth, 100, 4000);
  const ForcedMotion motion = forced_motion(m, modal(m), speed, depth, kFeed);
  EXPECT_LT((motion.at(0).value - end).norm(), 2e-3 * end.norm());
}

TEST(ForcedMotion, OfATrivialDepthIsTheStaticDeflectionAlone) {
  const Milling m = helical(true);
  const ForcedMotion motion = forced_motion(m, modal(m), rpm(9220), m.lead / m.teeth, kFeed);
  for (std::size_t k = 1; k < motion.harmonics.size(); ++k)
    EXPECT_LT(motion.harmonics[k].norm(), 1e-12 * motion.harmonics[0].norm());
}

TEST(ForcedMotion, IsSampledAsItIsSummed) {
  const Milling m = helical(true);
  const ForcedMotion motion = forced_motion(m, modal(m), rpm(9000), 1e-3, kFeed);
  const std::vector<double> samples = motion.samples(1, 256);
  for (std::size_t i = 0; i < 256; i += 17)
    EXPECT_NEAR(samples[i], motion.at(M_PI * static_cast<double>(i) / 256).value[1], 1e-12);
}

}  // namespace
}  // namespace evenload
