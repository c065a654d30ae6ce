#include "cutting/engagement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "geometry/vec2.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

TEST(Engagement, HasItsClosedFormsAtKnownAngles) {
  EXPECT_NEAR(side_step(kPi / 3, 3), 1.5, 1e-12);
  EXPECT_NEAR(side_step(kPi / 2, 3), 3, 1e-12);
  EXPECT_NEAR(side_step(kPi, 3), 6, 1e-12);
  EXPECT_EQ(side_step(0, 3), 0);
  EXPECT_NEAR(engagement_angle(1.5, 3), kPi / 3, 1e-12);
  EXPECT_EQ(engagement_angle(0, 3), 0);
  EXPECT_NEAR(engagement_angle(6, 3), kPi, 1e-12);
}

TEST(Engagement, IsTheInverseOfTheSideStep) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double angle = uniform(random, 0.01, kPi - 0.01), radius = uniform(random, 0.1, 20);
    EXPECT_NEAR(engagement_angle(side_step(angle, radius), radius), angle, 1e-9);
  }
}

TEST(Engagement, GrowsWithTheSideStep) {
  double last = -1;
  for (int i = 0; i <= 100; ++i) {
    const double angle = engagement_angle(6 * i / 100.0, 3);
    EXPECT_GT(angle, last);
    last = angle;
  }
}

// The tool's centre goes along a circle of radius rho +- r -+ s about the contour's centre; its
// engagement is the angle from the contact on the contour's far side to where the tool's circle
// crosses the contour.
double engagement_on_contour(double step, double r, double rho, Contour contour) {
  // Concave: the material's edge is a circle of radius rho with the material outside it; the tool
  // reaches a circle `step` farther out. Convex: material inside, reached `step` farther in.
  const double centre = contour == Contour::kConcave ? rho + step - r : rho - step + r;
  const double cosine = (centre * centre + r * r - rho * rho) / (2 * centre * r);
  const double inwards = std::acos(cosine);  // from the direction to the contour's centre
  return contour == Contour::kConcave ? kPi - inwards : inwards;
}

TEST(Engagement, IsWhatThesisOnePromisesOnBothContours) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const double r = uniform(random, 0.5, 10), angle = uniform(random, 0.1, 1.5);
    const double rho = r * std::sin(angle) + uniform(random, 1.2 * r, 20 * r);
    for (const Contour contour : {Contour::kConcave, Contour::kConvex}) {
      const double step = side_step_on_contour(angle, r, rho, contour);
      EXPECT_NEAR(engagement_on_contour(step, r, rho, contour), angle, 1e-6)
          << "r " << r << " rho " << rho << (contour == Contour::kConcave ? " concave" : " convex");
    }
  }
}

TEST(Engagement, TendsToTheStraightWallForLargeRadiiOfCurvature) {
  for (const double angle : {0.2, 1.0, 1.5, 2.5})
    for (const Contour contour : {Contour::kConcave, Contour::kConvex}) {
      const double straight = side_step(angle, 3);
      double last = 1e9;
      for (const double rho : {1e1, 1e2, 1e3, 1e4}) {
        const double off = std::abs(side_step_on_contour(angle, 3, rho, contour) - straight);
        EXPECT_LT(off, last);
        EXPECT_LE(off, std::pow(3 * std::sin(angle), 2) / rho);
        last = off;
      }
    }
}

TEST(Engagement, NeedsLessStepInAConcaveContourThanOnAConvexOne) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const double angle = uniform(random, 0.1, 3), rho = uniform(random, 3.01, 50);
    EXPECT_LT(side_step_on_contour(angle, 3, rho, Contour::kConcave), side_step(angle, 3));
    EXPECT_GT(side_step_on_contour(angle, 3, rho, Contour::kConvex), side_step(angle, 3));
  }
}

TEST(Engagement, DoesNotExistOnContoursTighterThanTheChord) {
  for (const Contour contour : {Contour::kConcave, Contour::kConvex}) {
    EXPECT_THROW(side_step_on_contour(kPi / 2, 3, 2.99, contour), std::invalid_argument);
    EXPECT_NO_THROW(side_step_on_contour(kPi / 2, 3, 3.01, contour));
  }
}

TEST(Engagement, GivesTheChipItsLargestAndMeanThickness) {
  EXPECT_NEAR(largest_chip_thickness(kPi / 6, 0.1), 0.05, 1e-12);
  EXPECT_NEAR(largest_chip_thickness(kPi / 2, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(largest_chip_thickness(2.5, 0.1), 0.1, 1e-12);
  EXPECT_EQ(mean_chip_thickness(0, 0.1), 0);
  for (const double angle : {0.3, 1.0, 2.0, 3.0}) {
    double sum = 0;
    for (int i = 0; i < 10000; ++i) sum += 0.1 * std::sin(angle * (i + 0.5) / 10000) / 10000;
    EXPECT_NEAR(mean_chip_thickness(angle, 0.1), sum, 1e-8);
    EXPECT_LE(mean_chip_thickness(angle, 0.1), largest_chip_thickness(angle, 0.1));
  }
}

}  // namespace
}  // namespace evenload
