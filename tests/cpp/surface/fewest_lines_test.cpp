// Lines along a curve: within their bounds, and hardly more than there must be.
#include "surface/fewest_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "geometry/vec2.h"

namespace evenload {
namespace {

std::vector<Vec2> curve_of(const std::function<double(double)>& z, double end, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) points.push_back({end * i / count, z(end * i / count)});
  return points;
}

double height_on(const std::vector<Vec2>& lines, double s) {
  std::size_t i = 1;
  while (i + 1 < lines.size() && lines[i].x < s) ++i;
  const Vec2 a = lines[i - 1], b = lines[i];
  return a.y + (s - a.x) / (b.x - a.x) * (b.y - a.y);
}

TEST(FewestLines, PassEveryPointWithinTheBounds) {
  const auto z = [](double s) { return std::sin(s) + 0.2 * std::abs(s - 3); };
  const std::vector<Vec2> curve = curve_of(z, 10, 2000);
  const std::vector<Vec2> lines = fewest_lines(curve, 0.002, 0.01);
  ASSERT_EQ(lines.front().x, 0);
  ASSERT_EQ(lines.back().x, 10);
  for (const Vec2 p : curve) {
    // Across a curve as steep as 1.2 the bounds are 1.6 times as high.
    EXPECT_GT(height_on(lines, p.x) - p.y, -0.002 * 1.6);
    EXPECT_LT(height_on(lines, p.x) - p.y, 0.01 * 1.6);
  }
}

TEST(FewestLines, AreHardlyMoreThanThereMustBeOnAnArc) {
  constexpr double kDome = 50, kDown = 0.0005, kUp = 0.0095;
  const auto dome = [](double s) { return std::sqrt(kDome * kDome - (s - 25) * (s - 25)); };
  const double angle = 2 * std::asin(0.5);
  const double chord = 2 * std::acos((kDome - kDown) / (kDome + kUp));  // of one line
  const double least = angle / chord;
  for (const double sign : {1.0, -1.0}) {
    const auto z = [&](double s) { return sign * dome(s); };
    const auto lines = fewest_lines(curve_of(z, 50, 800), kDown, kUp);
    EXPECT_LE(static_cast<double>(lines.size()) - 1, 1.2 * std::ceil(least));
  }
}

TEST(FewestLines, AStraightCurveStaysAsItIs) {
  const auto z = [](double s) { return 3 - 0.4 * s; };
  const std::vector<Vec2> lines = fewest_lines(curve_of(z, 20, 300), 0.001, 0.01);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].y, z(0));
  EXPECT_NEAR(lines[1].y, z(20), 1e-12);
}

TEST(FewestLines, FixedEndsLieOnTheCurve) {
  const auto z = [](double s) { return 0.02 * s * s; };
  const std::vector<Vec2> curve = curve_of(z, 20, 300);
  const std::vector<Vec2> lines = fewest_lines(curve, 0.001, 0.01, LineEnds::kFixed);
  EXPECT_EQ(lines.front(), curve.front());
  EXPECT_EQ(lines.back(), curve.back());
}

TEST(FewestLines, PointsOnLinesAreLeftOutAndNoOthers) {
  std::vector<Vec2> curve = curve_of([](double s) { return std::abs(s - 5); }, 10, 200);
  EXPECT_EQ(without_straight_ones(curve, 1e-9).size(), 3U);
  curve[30].y += 0.01;
  EXPECT_EQ(without_straight_ones(curve, 1e-3).size(), 6U);
}

}  // namespace
}  // namespace evenload
