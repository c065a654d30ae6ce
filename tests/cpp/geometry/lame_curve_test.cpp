#include "geometry/lame_curve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include "judge/numbers.h"

namespace evenload {
namespace {

constexpr std::array<double, 6> kExponents = {0.05, 0.3, 0.7, 1, 1.7, 3};

LameCurve curve_of(double a, double b, double exponent, int segments = 4, double rotation = 0) {
  return {{0, 0}, a, b, exponent, segments, rotation};
}

double radius(const LameCurve& curve, double angle) { return lame_radius(curve, angle).r; }

TEST(LameCurve, OfExponentOneIsTheEllipse) {
  const LameCurve curve = curve_of(7, 3, 1);
  for (double angle = -4; angle < 4; angle += 0.01) {
    const Vec2 p = lame_point(curve, angle);
    EXPECT_NEAR(p.x * p.x / 49 + p.y * p.y / 9, 1, 1e-12);
    // Of an ellipse: a b / (b^2 cos^2 t + a^2 sin^2 t)^(3/2) with p = (a cos t, b sin t).
    const double along = std::pow(9 * p.x * p.x / 49 + 49 * p.y * p.y / 9, 1.5);
    EXPECT_NEAR(lame_curvature(curve, angle), 21 / along, 1e-9);
  }
}

TEST(LameCurve, OfASmallExponentIsNearlyTheRectangle) {
  const LameCurve curve = curve_of(7, 3, kLeastExponent);
  for (double angle = 0; angle < 6.3; angle += 0.01) {
    const double rectangle = std::min(7 / std::abs(std::cos(angle)), 3 / std::abs(std::sin(angle)));
    EXPECT_LE(radius(curve, angle), rectangle + 1e-12);
    EXPECT_GE(radius(curve, angle), rectangle * std::pow(2, -0.5 * kLeastExponent) - 1e-12);
  }
}

TEST(LameCurve, OfASmallExponentIsTheSecantOfItsSegments) {
  for (const int segments : {3, 5, 6, 8}) {
    const LameCurve curve = curve_of(5, 5, kLeastExponent, segments);
    for (double angle = 0; angle < kPi / segments; angle += 0.003) {
      const double secant = 5 / std::cos(segments * angle / 4);
      EXPECT_LE(radius(curve, angle), secant + 1e-12);
      EXPECT_GE(radius(curve, angle), secant * std::pow(2, -0.5 * kLeastExponent) - 1e-12);
    }
  }
}

TEST(LameCurve, IsExactOnItsAxesAndDiagonals) {
  for (const double n : kExponents) {
    const LameCurve curve = curve_of(7, 3, n);
    EXPECT_DOUBLE_EQ(radius(curve, 0), 7);
    EXPECT_DOUBLE_EQ(radius(curve, kPi), 7);
    EXPECT_DOUBLE_EQ(radius(curve, kPi / 2), 3);
    EXPECT_DOUBLE_EQ(radius(curve, -kPi / 2), 3);
    // (1/2)^(1/n) from each axis: r = a 2^((1 - n) / 2).
    EXPECT_NEAR(radius(curve_of(5, 5, n), kPi / 4), 5 * std::pow(2, (1 - n) / 2), 1e-12);
    EXPECT_NEAR(radius(curve_of(5, 5, n, 6), kPi / 6), 5 * std::pow(2, (1 - n) / 2), 1e-12);
  }
}

TEST(LameCurve, HasAsManyEqualSegmentsAsItSays) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const int segments = 2 + static_cast<int>(random() % 9);
    const LameCurve curve = curve_of(5, 5, uniform(random, 0.05, 3), segments, 0.4);
    const double angle = uniform(random, -7, 7);
    EXPECT_NEAR(radius(curve, angle), radius(curve, angle + 2 * kPi / segments), 1e-9);
    EXPECT_NEAR(radius(curve, 0.4 + angle), radius(curve, 0.4 - angle), 1e-9);
  }
}

TEST(LameCurve, IsFiniteAndContinuousAtEveryAngle) {
  constexpr double kStep = 1e-4;  // rad
  for (const double n : kExponents)
    for (const int segments : {4, 6}) {
      const LameCurve curve = curve_of(40, 11, n, segments, 0.3);
      // From an axis on, r falls as the power 2 / n of the angle; elsewhere it is no steeper than
      // the corners of the smallest exponent.
      const double most =
          60 * n * std::pow(40.0 / 11 * segments / 4 * kStep, std::min(1.0, 2 / n)) + 0.02;
      double before = radius(curve, -kStep);
      for (int i = 0; i <= 64000; ++i) {
        const LameRadius at = lame_radius(curve, i * kStep);
        ASSERT_GE(at.r, 11 * std::pow(2, -1.5));  // as for n = 3 between its axes
        ASSERT_LE(at.r, 40 * std::sqrt(2));
        ASSERT_NEAR(at.r, before, most);
        for (const double each : {at.by_angle, at.by_a, at.by_b, at.by_exponent})
          ASSERT_TRUE(std::isfinite(each)) << n << " at " << i * kStep;
        ASSERT_FALSE(std::isnan(at.by_angle_twice));
        before = at.r;
      }
      for (const double axis : {0.3, 0.3 + 2 * kPi / segments})  // where tangents have poles
        for (const double by : {-1e-9, -1e-16, 0.0, 1e-16, 1e-9}) {
          const LameRadius at = lame_radius(curve, axis + by);
          ASSERT_NEAR(at.r, axis == 0.3 ? 40 : 11, 0.1);
          for (const double each : {at.by_angle, at.by_a, at.by_b, at.by_exponent})
            ASSERT_TRUE(std::isfinite(each)) << n << " beside " << axis;
          ASSERT_FALSE(std::isnan(at.by_angle_twice));
        }
    }
}

// rad of psi to the nearest axis.
double from_axis(const LameCurve& curve, double angle) {
  return std::abs(std::remainder(0.25 * curve.segments * (angle - curve.rotation), kPi / 2));
}

TEST(LameCurve, HasTheDerivativesOfItsRadius) {
  std::mt19937 random(3);
  constexpr double kStep = 1e-6;
  int above_one = 0;
  for (int i = 0; i < 6000; ++i) {
    const double n = i % 3 == 0 ? uniform(random, 1, 3) : uniform(random, 0.05, 1);
    const double a = uniform(random, 1, 9);
    const int segments = 3 + static_cast<int>(random() % 6);
    const LameCurve curve =
        curve_of(a, segments == 4 ? uniform(random, 1, 9) : a, n, segments, uniform(random, -3, 3));
    const double angle = uniform(random, -7, 7), apart = from_axis(curve, angle);
    // At an axis a derivative of higher order may be none, on which differences depend.
    if (apart < 0.01) continue;
    above_one += n > 1;
    const LameRadius at = lame_radius(curve, angle);
    const auto slope = [&](double LameCurve::*what) {
      LameCurve low = curve, high = curve;
      low.*what -= kStep;
      high.*what += kStep;
      return (radius(high, angle) - radius(low, angle)) / (2 * kStep);
    };
    // Derivatives grow by 1 / n at corners and by 1 / apart at axes, order by order.
    const double steep = 1 / n + 1 / apart;
    const double first = 1e-8 * at.r + 1e-12 * at.r * std::pow(steep, 3);
    const double second = 1e-8 * at.r * steep + 1e-11 * at.r * std::pow(steep, 4);
    EXPECT_NEAR(at.by_angle,
                (radius(curve, angle + kStep) - radius(curve, angle - kStep)) / (2 * kStep), first);
    EXPECT_NEAR(
        at.by_angle_twice,
        (lame_radius(curve, angle + kStep).by_angle - lame_radius(curve, angle - kStep).by_angle) /
            (2 * kStep),
        second);
    EXPECT_NEAR(at.by_a, slope(&LameCurve::a), first);
    EXPECT_NEAR(at.by_b, slope(&LameCurve::b), first);
    EXPECT_NEAR(at.by_exponent, slope(&LameCurve::exponent), first);
    EXPECT_NEAR(at.log_by_a + at.log_by_b, 1, 1e-12);
    EXPECT_LE(at.by_exponent, 0);
  }
  EXPECT_GT(above_one, 1500);
}

TEST(LameCurve, OfExponentOneOrLessHasItsDerivativesOnTheAxesToo) {
  constexpr double kStep = 1e-4;
  for (const double n : {0.05, 0.3, 0.7, 0.9, 1.0})
    for (const int segments : {4, 6}) {
      const LameCurve curve = curve_of(7, 3, n, segments, 0.3);
      for (int k = 0; k < segments; ++k) {
        const double axis = 0.3 + 2 * kPi * k / segments, turn = 0.25 * segments;
        const LameRadius at = lame_radius(curve, axis);
        EXPECT_NEAR(at.by_angle, 0, 1e-12);
        EXPECT_EQ(at.by_exponent, 0);
        // Below 1 that of the secant, to which differences come by the power 2 / n - 2 of the step.
        if (n < 1) {
          EXPECT_NEAR(at.by_angle_twice, at.r * turn * turn, 1e-9);
        }
        const double bend = (radius(curve, axis + kStep) - 2 * at.r + radius(curve, axis - kStep)) /
                            (kStep * kStep);
        const double slow = n < 1 ? 200 * std::pow(kStep, 2 / n - 2) : 0;
        EXPECT_NEAR(at.by_angle_twice, bend, 1e-4 + slow) << n;
      }
    }
}

// By the power 2 / n - 1 of the angle from an axis the slope of r falls there or grows.
TEST(LameCurve, FromExponentTwoOnHasNoTangentOnItsAxes) {
  for (const double n : {1.2, 1.7, 2.0, 2.5, 3.0}) {
    const LameCurve curve = curve_of(7, 3, n);
    for (const double axis : {0.0, kPi / 2}) {
      const double near = lame_radius(curve, axis + 1e-6).by_angle,
                   nearer = lame_radius(curve, axis + 1e-7).by_angle;
      EXPECT_LT(near, 0);
      EXPECT_NEAR(lame_radius(curve, axis - 1e-6).by_angle / near, -1, 1e-3);
      EXPECT_NEAR(nearer / near, std::pow(0.1, 2 / n - 1), 1e-2) << n;
      EXPECT_EQ(lame_radius(curve, axis + 1e-12).by_angle < -1, n >= 2) << n;
    }
  }
}

TEST(LameCurve, OfMoreThanExponentOneHasNoCurvatureOnItsAxes) {
  EXPECT_TRUE(std::isinf(lame_curvature(curve_of(5, 5, 1.5), 0)));
  EXPECT_DOUBLE_EQ(lame_radius(curve_of(5, 5, 1.5), 0).by_angle, 0);
  for (const double n : {1.5, 2.0, 3.0})
    EXPECT_FALSE(std::isnan(lame_curvature(curve_of(5, 5, n), 0)));
}

TEST(LameCurve, ItsTightestPlaceIsNotMissed) {
  for (const double n : {0.05, 0.1, 0.4, 0.8, 1.0})
    for (const int segments : {3, 4, 8}) {
      const LameCurve curve = curve_of(6, segments == 4 ? 2.5 : 6, n, segments, 1);
      double most = 0;
      for (int i = 0; i < 100000; ++i)
        most = std::max(most, lame_curvature(curve, 2 * kPi * i / 100000));
      EXPECT_LE(least_curvature_radius(curve), 1 / most + 1e-6);
      EXPECT_GE(least_curvature_radius(curve), 0.999 / most);
    }
}

TEST(LameCurve, MeasuresItsAreaAndLength) {
  EXPECT_NEAR(lame_area(curve_of(7, 3, 1)), kPi * 21, 1e-3);
  EXPECT_NEAR(lame_length(curve_of(5, 5, 1)), 10 * kPi, 1e-6);
  EXPECT_NEAR(lame_area(curve_of(5, 4, 2)), 40, 4e-3);  // a rhombus
  // 4 a b Gamma(1 + n/2)^2 / Gamma(1 + n)
  const double g = std::tgamma(1.2);
  EXPECT_NEAR(lame_area(curve_of(5, 4, 0.4)), 80 * g * g / std::tgamma(1.4), 8e-3);
}

TEST(LameCurve, MovedOutOrInIsOneOfARadiusMoreOrLess) {
  EXPECT_NEAR(grown_lame_area(curve_of(5, 5, 1), 2), 49 * kPi, 1e-3);
  EXPECT_NEAR(grown_lame_area(curve_of(5, 5, 1), -2), 9 * kPi, 1e-3);
  EXPECT_NEAR(least_lame_radius(curve_of(7, 3, 1)), 3, 1e-12);
  EXPECT_NEAR(largest_lame_radius(curve_of(7, 3, 1)), 7, 1e-12);
  EXPECT_NEAR(largest_lame_radius(curve_of(5, 5, 0.2, 6)), 5 * std::pow(2, 0.4), 1e-9);
}

TEST(LameCurve, RefusesWhatIsNone) {
  EXPECT_THROW(check_lame_curve(curve_of(0, 1, 1)), std::invalid_argument);
  EXPECT_THROW(check_lame_curve(curve_of(1, NAN, 1)), std::invalid_argument);
  EXPECT_THROW(check_lame_curve(curve_of(1, 1, 0.04)), std::invalid_argument);
  EXPECT_THROW(check_lame_curve(curve_of(1, 1, 3.1)), std::invalid_argument);
  EXPECT_THROW(check_lame_curve(curve_of(1, 1, 1, 1)), std::invalid_argument);
  EXPECT_THROW(check_lame_curve(curve_of(2, 1, 1, 5)), std::invalid_argument);
  EXPECT_NO_THROW(check_lame_curve(curve_of(2, 1, 1, 6)));
}

}  // namespace
}  // namespace evenload
