// Outlines of many polygons, against areas known in closed form.
#include "geometry/united.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace evenload {
namespace {

using Polygon = std::vector<Vec2>;

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * std::abs(twice);
}

Polygon square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(United, IsOneOutlineOfWhatOverlaps) {
  const auto outlines = united({square(0, 0, 2), square(1, 1, 2)}, 0);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].size(), 8u);
  EXPECT_NEAR(area_of(outlines[0]), 7, 1e-4);
}

TEST(United, JoinsNeighboursAndDropsTheirCommonEdge) {
  const auto outlines = united({square(0, 0, 2), square(2, 0, 2)}, 1e-4);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].size(), 4u);
  EXPECT_NEAR(area_of(outlines[0]), 8, 1e-4);
}

TEST(United, HasAHoleAsAnOutlineOfItsOwn) {
  std::vector<Polygon> ring;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != 1 || j != 1) ring.push_back(square(i, j, 1));
  const auto outlines = united(ring, 0);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_NEAR(std::abs(area_of(outlines[0]) - area_of(outlines[1])), 8, 1e-4);
}

TEST(United, OfAFanOfTrianglesIsTheDiscWithinTheTolerance) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1e3, 1e3);
  for (int n = 0; n < 20; ++n) {
    const Vec2 centre{shift(random), shift(random)};
    std::vector<Polygon> fan;
    for (int k = 0; k < 400; ++k)
      fan.push_back({centre, centre + 5 * unit(2 * kPi * k / 400),
                     centre + 5 * unit(2 * kPi * (k + 1) / 400)});
    const auto outlines = united(fan, 0.005);
    ASSERT_EQ(outlines.size(), 1u);
    EXPECT_LT(outlines[0].size(), 200u);
    for (const Vec2 p : outlines[0]) EXPECT_NEAR(distance(p, centre), 5, 1e-4);
    EXPECT_NEAR(area_of(outlines[0]), 25 * kPi, 2 * kPi * 5 * 0.006);
  }
}

TEST(United, RefusesWhatIsFartherAwayThanItsRaster) {
  EXPECT_THROW(united({square(3e4, 0, 1)}, 0), std::invalid_argument);
  EXPECT_TRUE(united({}, 0).empty());
}

// The signed area of an outline, counter-clockwise positive.
double turned_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

TEST(CutFrom, LeavesPatchesWithHolesWhoseGroundIsOnTheLeft) {
  const std::vector<Patch> left =
      cut_from({{square(0, 0, 4), {}}, {square(10, 0, 4), {}}}, {{square(1, 1, 2), {}}}, 0);
  ASSERT_EQ(left.size(), 2u);
  double all = 0;
  std::size_t holes = 0;
  for (const Patch& patch : left) {
    EXPECT_GT(turned_area(patch.outline), 0);
    all += turned_area(patch.outline);
    for (const Polygon& hole : patch.holes) {
      EXPECT_LT(turned_area(hole), 0);
      all += turned_area(hole);
      ++holes;
    }
  }
  EXPECT_EQ(holes, 1u);
  EXPECT_NEAR(all, 28, 1e-4);
}

TEST(CutFrom, TakesPatchesInPartsAndKeepsWhatLiesInTheirHoles) {
  const Patch frame{square(0, 0, 6), {square(1, 1, 4)}};
  const std::vector<Patch> left = cut_from({{square(0, 0, 6), {}}}, {frame}, 0);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_NEAR(turned_area(left[0].outline), 16, 1e-4);
  EXPECT_TRUE(cut_from({frame}, {{square(-1, -1, 8), {}}}, 0).empty());
}

}  // namespace
}  // namespace evenload
