// Heights over the plane from triangles, against bodies known in closed form.
#include "simulate/height_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "simulate/dexel_stock.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

// A slope over [0, 20] x [0, 10] that rises from 0 to 10 along x, and a lid over a part of it.
HeightMap slope(bool with_lid = false) {
  std::vector<Point3> points{{0, 0, 0}, {20, 0, 10}, {20, 10, 10}, {0, 10, 0}};
  std::vector<HeightMap::Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  if (with_lid) {
    points.insert(points.end(), {{2, 2, 12}, {6, 2, 12}, {6, 6, 12}, {2, 6, 12}});
    triangles.insert(triangles.end(), {{4, 6, 5}, {4, 6, 7}});  // whichever way round
  }
  return {points, triangles};
}

TEST(HeightMap, IsAsHighAsTheHighestTriangle) {
  const HeightMap map = slope(true);
  EXPECT_NEAR(map.top_at({10, 5}), 5, 1e-12);
  EXPECT_NEAR(map.top_at({10, 10}), 5, 1e-12);
  EXPECT_NEAR(map.top_at({3, 4}), 12, 1e-12);
  EXPECT_EQ(map.top_at({-0.1, 5}), kNoMaterial);
  EXPECT_EQ(map.lowest(), 0);
  EXPECT_EQ(map.highest(), 12);
}

TEST(HeightMap, TellsWhichTriangleIsHighestAndHowItLies) {
  const HeightMap map = slope(true);
  EXPECT_EQ(map.triangle_count(), 4u);
  const Top lid = *map.highest_at({3, 4});
  EXPECT_EQ(lid.triangle, 3u);
  EXPECT_NEAR(lid.normal.z, 1, 1e-12);
  const Top below = *map.highest_at({10, 1});
  EXPECT_EQ(below.triangle, 0u);
  EXPECT_NEAR(below.z, 5, 1e-12);
  EXPECT_NEAR(below.normal.x, -std::sqrt(0.2), 1e-12);
  EXPECT_NEAR(below.normal.z, std::sqrt(0.8), 1e-12);
  EXPECT_FALSE(map.highest_at({-1, 5}));
  // Where two are as high the first one counts.
  EXPECT_EQ(map.highest_at({10, 5})->triangle, 0u);
}

TEST(HeightMap, DropsUprightTrianglesAndRefusesWhatIsNoBody) {
  EXPECT_TRUE(HeightMap({{0, 0, 0}, {1, 0, 0}, {1, 0, 5}}, {{0, 1, 2}}).empty());
  EXPECT_THROW(HeightMap({{0, 0, 0}}, {{0, 0, 1}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(HeightMap({{0, 0, nan}}, {}), std::invalid_argument);
}

TEST(HeightMap, FillsDexelsToNoLessThanTheSlope) {
  const DexelStock stock(slope(), 0, 0.1);
  EXPECT_NEAR(stock.volume(), 20 * 10 * 5, 20 * 10 * 0.05 + 1);
  for (double x = 0.05; x < 20; x += 0.37) {
    const double height = stock.height_at({x, 5.03});
    EXPECT_GE(height, 0.5 * x - 1e-9);
    EXPECT_LE(height, 0.5 * x + 0.1);
  }
}

TEST(HeightMap, FillsUnderWhatHangsOver) {
  const DexelStock stock(slope(true), 0, 0.1);
  EXPECT_NEAR(stock.height_at({4, 4}), 12, 1e-12);
  EXPECT_NEAR(stock.volume() - DexelStock(slope(), 0, 0.1).volume(), 16 * (12 - 2), 2);
}

TEST(HeightMap, FindsWhatStandsOverARegionAndNotWhatStandsBeside) {
  const HeightMap map = slope(true);
  const auto found = map.highest_within(rectangle(1, 1, 8, 8), 11, 0.02, 0.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->z, 12, 1e-6);
  EXPECT_TRUE(found->x > 1.9 && found->x < 6.1 && found->y > 1.9 && found->y < 6.1);
  EXPECT_FALSE(map.highest_within(rectangle(1, 1, 8, 8), 12.5, 0.02, 0.5));
  EXPECT_FALSE(map.highest_within(rectangle(6.5, 1, 9, 9), 11, 0.02, 0.5));
  // A lip that reaches in by less than a raster: seen along the border.
  EXPECT_TRUE(map.highest_within(rectangle(5.9, 0, 12, 8), 11, 0.02, 3));
  // What only reaches into the inset is the region's own wall.
  EXPECT_FALSE(map.highest_within(rectangle(5.99, 0, 12, 8), 11, 0.02, 3));
}

TEST(HeightMap, HasARasterInTheMiddleOfItsCorners) {
  const std::vector<Point3> places = slope().raster({{-5, 0}, {20, 10}}, 2.5);
  for (const Point3& p : places) EXPECT_NEAR(p.z, 0.5 * p.x, 1e-9);
  EXPECT_EQ(places.size(), 9u * 5u);
  EXPECT_THROW(slope().raster({{0, 0}, {1, 1}}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
