// Ways of lines and helices: their lengths, places and directions.
#include "surface/waypoint.h"

#include <gtest/gtest.h>

namespace evenload {
namespace {

// A quarter of a circle of 10 mm about the origin that rises by 3 mm, and a line on from it.
const std::vector<Waypoint> kWay{{{10, 0, 0}, 0}, {{0, 10, 3}, kPi / 2}, {{-5, 10, 3}, 0}};

void expect_near(SpacePoint a, SpacePoint b) { EXPECT_NEAR(distance(a, b), 0, 1e-12); }

TEST(Waypoint, AHelixHasItsLengthItsCentreAndItsPlaces) {
  EXPECT_NEAR(plan_length(kWay[0], kWay[1]), 5 * kPi, 1e-12);
  EXPECT_NEAR(way_length(kWay[0], kWay[1]), std::hypot(5 * kPi, 3), 1e-12);
  EXPECT_NEAR(norm(centre_of(kWay[0], kWay[1])), 0, 1e-12);
  const double half = std::sqrt(50);
  expect_near(place_on(kWay[0], kWay[1], 0.5), {half, half, 1.5});
  expect_near(place_on(kWay[1], kWay[2], 0.5), {-2.5, 10, 3});
  expect_near(5 * kPi * beginning_of(kWay[0], {{0, 10, 0}, kPi / 2}), {0, 5 * kPi, 0});
}

TEST(Waypoint, BackwardsItIsTheSameWay) {
  const std::vector<Waypoint> back = turned_round(kWay);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[0].sweep, 0);
  EXPECT_EQ(back[1].sweep, 0);
  EXPECT_EQ(back[2].sweep, -kPi / 2);
  expect_near(place_on(back[1], back[2], 0.25), place_on(kWay[0], kWay[1], 0.75));
}

TEST(Waypoint, NearestOnAHelixIsWhereItPassesAndOnALineAnEnd) {
  EXPECT_NEAR(nearest_share(kWay[0], kWay[1], {20, 20}), 0.5, 1e-12);
  EXPECT_EQ(nearest_share(kWay[0], kWay[1], {10, -1}), 0);
  EXPECT_EQ(nearest_share(kWay[0], kWay[1], {-1, 10}), 1);
  EXPECT_EQ(nearest_share(kWay[1], kWay[2], {-2.4, 12}), 0);
}

}  // namespace
}  // namespace evenload
