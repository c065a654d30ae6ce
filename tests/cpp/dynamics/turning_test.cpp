// Turning: speeds for interrupted cuts, and process damping.
#include "dynamics/turning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace evenload {
namespace {

TEST(InterruptedTurning, HasTheSpeedsOfTheReference) {
  const struct {
    double damping, exit, enter, speed;
  } rows[] = {{0, 0, 0, 6.0},
              {0.03, 0, 0, 5.997299},
              {0.03, 0.5, 0.8, 7.332235},
              {0.05, 1.5, 0.3, 7.47135},
              {0.01, 0, 1, 6.863042}};
  for (const auto& row : rows)
    EXPECT_NEAR(
        interrupted_turning_speeds(5e-3, 2 * M_PI * 1200, row.damping, row.enter, row.exit, 1)[0] /
            row.speed,
        1, 1e-6);
  const auto plain = interrupted_turning_speeds(5e-3, 2 * M_PI * 1200, 0, 0, 0, 3);
  EXPECT_NEAR(plain[1], 3, 1e-12);
  EXPECT_NEAR(plain[2], 2, 1e-12);
  EXPECT_THROW(interrupted_turning_speeds(0, 1, 0, 0, 0, 1), std::invalid_argument);
}

// The free vibration that is left after re-entry, over the static deflection: the oscillator
// x'' + 2 xi x' + x = force, in units of 1/wn, by Runge and Kutta.
double residual(double xi, double exit, double enter, double gap) {
  double x = 1, v = 0;
  const double start = -20 * exit - 1e-9, end = gap + 30 * enter + 10;
  const auto force = [&](double t) {
    if (t < 0) return exit > 0 ? 1 - std::exp(t / exit) : 1.0;
    if (t < gap) return 0.0;
    return enter > 0 ? 1 - std::exp(-(t - gap) / enter) : 1.0;
  };
  const int steps = 200000;
  const double h = (end - start) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = start + i * h;
    const auto a = [&](double time, double at, double speed) {
      return force(time) - 2 * xi * speed - at;
    };
    const double k1 = a(t, x, v), v2 = v + 0.5 * h * k1, x2 = x + 0.5 * h * v;
    const double k2 = a(t + 0.5 * h, x2, v2), v3 = v + 0.5 * h * k2, x3 = x + 0.5 * h * v2;
    const double k3 = a(t + 0.5 * h, x3, v3), v4 = v + h * k3, x4 = x + h * v3;
    const double k4 = a(t + h, x4, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double damped = std::sqrt(1 - xi * xi);
  return std::hypot(x - 1, (v + xi * (x - 1)) / damped) * std::exp(xi * (end - gap));
}

TEST(InterruptedTurning, LeavesAlmostNoVibrationAtItsSpeed) {
  const double xi = 0.03, exit = 0.5, enter = 0.8;
  const double wn = 2 * M_PI * 1200;
  const double best = interrupted_turning_speeds(5e-3, wn, xi, enter, exit, 1)[0];
  const auto left = [&](double speed) { return residual(xi, exit, enter, 5e-3 * wn / speed); };
  EXPECT_NEAR(left(best), 0.035, 0.01);
  EXPECT_GT(left(6.0), 0.5);
  for (const double share : {0.995, 1.005}) EXPECT_GT(left(share * best), left(best) - 0.01);
}

TurningCut cut() {
  const double frequency = 2 * M_PI * 200;
  return {{0.5, frequency, 0.03, 0}, 1e9, 1.5e13, 0.05e-3, 0.05};
}

TEST(ProcessDamping, OfTurningHasTheLimitsOfTheReference) {
  const struct {
    double speed;
    double width[4], frequency[4];
  } rows[] = {
      {60, {48.81226, 58.11371, 58.23747, 58.06844}, {205.7588, 206.7605, 206.7642, 206.7637}},
      {200, {48.79774, 51.31823, 51.32711, 51.32366}, {205.854, 205.8771, 205.8782, 205.8781}},
      {1000, {58.72039, 59.09818, 59.09686, 59.09684}, {211.0348, 211.0559, 211.056, 211.056}}};
  const FlankOrder orders[] = {FlankOrder::kNone, FlankOrder::kFirst, FlankOrder::kSecond,
                               FlankOrder::kExact};
  for (const auto& row : rows)
    for (int i = 0; i < 4; ++i) {
      const TurningLimit found = turning_limit(cut(), row.speed * M_PI / 30, orders[i]);
      EXPECT_NEAR(1e6 * found.width / row.width[i], 1, 1e-5) << row.speed << " " << i;
      EXPECT_NEAR(found.frequency / (2 * M_PI) / row.frequency[i], 1, 1e-5);
    }
}

TEST(ProcessDamping, HasOrdersWhoseErrorsHalveAndQuarterWithTwiceTheSpeed) {
  const auto error = [](double speed, FlankOrder order) {
    const double w = 2 * M_PI * 205;
    const std::complex<double> exact = flank_area(cut(), speed, w, FlankOrder::kExact);
    return std::abs(flank_area(cut(), speed, w, order) / exact - 1.0);
  };
  EXPECT_NEAR(error(100, FlankOrder::kFirst) / error(200, FlankOrder::kFirst), 2, 0.01);
  EXPECT_NEAR(error(100, FlankOrder::kSecond) / error(200, FlankOrder::kSecond), 4, 0.05);
}

}  // namespace
}  // namespace evenload
