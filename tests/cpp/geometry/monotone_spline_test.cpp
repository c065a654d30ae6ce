#include "geometry/monotone_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace evenload {
namespace {

TEST(MonotoneSpline, OfTwoKnotsIsALine) {
  const MonotoneSpline line({1, 5}, {2, 10});
  for (double x = 1; x <= 5; x += 0.25) {
    EXPECT_NEAR(line.value(x), 2 * x, 1e-12);
    EXPECT_NEAR(line.slope(x), 2, 1e-12);
  }
}

TEST(MonotoneSpline, PassesItsValuesAndStaysBetweenThem) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<double> knots{0}, values{0};
    for (int i = 0; i < 12; ++i) {
      knots.push_back(knots.back() + 0.1 + static_cast<double>(random() % 100) / 50);
      values.push_back(values.back() + static_cast<double>(random() % 4) - 1);
    }
    const MonotoneSpline spline(knots, values);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      EXPECT_NEAR(spline.value(knots[i]), values[i], 1e-12);
      const double rise = values[i + 1] - values[i];
      double before = values[i];
      for (int k = 1; k <= 20; ++k) {
        const double x = knots[i] + k * (knots[i + 1] - knots[i]) / 20;
        const double here = spline.value(x);
        EXPECT_GE((here - before) * (rise < 0 ? -1 : 1), -1e-12);
        EXPECT_LE(std::abs(here - values[i]), std::abs(rise) + 1e-12);
        before = here;
      }
    }
  }
}

TEST(MonotoneSpline, HasTheSlopeOfItsValuesAndNoJumps) {
  const MonotoneSpline spline({0, 1, 2.5, 3, 6}, {0, 0, 2, 5, 5.5});
  for (double x = 0.01; x < 6; x += 0.013)
    EXPECT_NEAR(spline.slope(x), (spline.value(x + 1e-6) - spline.value(x - 1e-6)) / 2e-6, 1e-3);
  for (const double knot : {1.0, 2.5, 3.0})
    EXPECT_NEAR(spline.slope(knot - 1e-9), spline.slope(knot + 1e-9), 1e-6);
  EXPECT_NEAR(spline.slope(1), 0, 1e-12);
}

TEST(MonotoneSpline, KeepsTheEndsValuesOutside) {
  const MonotoneSpline spline({0, 1}, {3, 4});
  EXPECT_EQ(spline.value(-2), 3);
  EXPECT_EQ(spline.value(7), 4);
  EXPECT_EQ(spline.slope(7), 0);
  EXPECT_EQ(MonotoneSpline(5).value(1), 5);
}

TEST(MonotoneSpline, RefusesKnotsThatDoNotRise) {
  EXPECT_THROW(MonotoneSpline({0, 0}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(MonotoneSpline({0, 1}, {1}), std::invalid_argument);
  EXPECT_THROW(MonotoneSpline({0, 1}, {1, NAN}), std::invalid_argument);
  EXPECT_THROW(MonotoneSpline({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
