// What counts as rest where prisms of the part touch, stand on each other or leave narrow ground.
#include "simulate/rest.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

TEST(RestOfPart, IsNothingInCornersThatTheToolCannotReach) {
  // A notch 4 mm wide: nothing of it is reached by a tool of 6 mm, all but corners by one of 2 mm.
  const Region notched = make_region(Curve(
      {{{0, 0}}, {{30, 0}}, {{30, 20}}, {{17, 20}}, {{17, 8}}, {{13, 8}}, {{13, 20}}, {{0, 20}}},
      true));
  const DexelStock stock({{rectangle(0, 0, 30, 20), 0}}, -3, 0.05);
  const Rest large = find_rest(stock, {{notched, 0}}, 3);
  EXPECT_LT(large.area, 4.0);  // the tool dips into the notch's mouth
  EXPECT_NEAR(large.area + large.unreachable_area, 48, 0.6);
  const Rest small = find_rest(stock, {{notched, 0}}, 1);
  const double corners = 2 * (1 - kPi / 4);
  EXPECT_NEAR(small.unreachable_area, corners, 0.5);
  EXPECT_NEAR(small.area, 48 - corners, 0.6);
}

TEST(RestOfPart, TreatsTouchingPrismsOfOneHeightAsOne) {
  const DexelStock stock({{rectangle(0, 0, 40, 20), 0}}, -3, 0.05);
  const Rest apart =
      find_rest(stock, {{rectangle(0, 0, 10, 20), 0}, {rectangle(10, 0, 20, 20), 0}}, 3);
  const Rest joined = find_rest(stock, {{rectangle(0, 0, 20, 20), 0}}, 3);
  EXPECT_NEAR(apart.area, 400, 0.5);
  EXPECT_NEAR(apart.area, joined.area, 0.01);
  EXPECT_NEAR(apart.unreachable_area, 0, 0.3);
}

TEST(RestOfPart, SeesStepsThatStandOnEachOther) {
  // A step at -1 beside a wall at 0, whose sections share a wall; the stock is a full block.
  const DexelStock stock({{rectangle(0, 0, 40, 20), 0}}, -3, 0.05);
  const Rest rest =
      find_rest(stock, {{rectangle(0, 0, 20, 20), -1}, {rectangle(0, 0, 10, 20), 0}}, 2);
  ASSERT_EQ(rest.patches.size(), 1u);
  EXPECT_NEAR(rest.area, 600, 0.5);
  EXPECT_NEAR(rest.depth, 3, 1e-9);
  EXPECT_NEAR(rest.unreachable_area, 0, 0.5);
}

TEST(RestOfPart, IsAllOfTheStockWithoutAPart) {
  const DexelStock stock({{rectangle(0, 0, 40, 20), 0}}, -3, 0.05);
  const Rest rest = find_rest(stock, {}, 3);
  EXPECT_NEAR(rest.area, 800, 1.1);
  EXPECT_NEAR(rest.depth, 3, 1e-9);
}

TEST(RestOfPart, TellsPatchesApartLargestFirst) {
  const DexelStock stock(
      {{rectangle(0, 0, 2, 2), 0}, {rectangle(5, 0, 9, 4), -1}, {rectangle(20, 0, 21, 1), 0}}, -3,
      0.05);
  const Rest rest = find_rest(stock, {}, 3);
  ASSERT_EQ(rest.patches.size(), 3u);
  EXPECT_NEAR(rest.patches[0].area, 16, 0.2);
  EXPECT_NEAR(rest.patches[0].at.x, 7, 0.01);
  EXPECT_NEAR(rest.patches[0].depth, 2, 1e-9);
  EXPECT_NEAR(rest.patches[1].area, 4, 0.1);
  EXPECT_NEAR(rest.patches[2].area, 1, 0.06);
  double outlined = 0;
  for (const std::vector<Vec2>& outline : rest.outlines) {
    std::vector<Vertex> vertices;
    for (const Vec2 p : outline) vertices.push_back({p});
    outlined += Curve(vertices, true).signed_area();
  }
  EXPECT_NEAR(outlined, rest.area, 1e-6);
}

}  // namespace
}  // namespace evenload
