#include "strategy/moves/move_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/shapes.h"

namespace evenload {
namespace {

const Area& square() {
  static const Area area({make_region(shapes::rectangle(0, 0, 10, 10))});
  return area;
}

TEST(MoveChecks, MovesAreTangentWhereTheOneGoesOnAsTheOtherEnds) {
  const Segment line = Segment::line({0, 0}, {5, 0});
  const Segment arc = Segment::arc({5, 2}, 2, -kPi / 2, 1);
  EXPECT_TRUE(is_tangent(line, arc, 1e-6));
  EXPECT_FALSE(is_tangent(arc, line, 1e-6));
  const Segment bent = Segment::line({5, 0}, {10, 5e-5});  // by 1e-5
  EXPECT_TRUE(is_tangent(line, bent, 2e-5));
  EXPECT_FALSE(is_tangent(line, bent, 5e-6));
}

TEST(MoveChecks, AMoveFollowsTheBorderWhereAllOfItLiesThere) {
  EXPECT_TRUE(follows_border(Segment::line({1, 0}, {9, 0}), square()));
  EXPECT_FALSE(follows_border(Segment::line({1, 1e-5}, {9, 1e-5}), square()));
  EXPECT_FALSE(follows_border(Segment::line({0, 0}, {10, 10}), square()));  // its ends only
}

TEST(MoveChecks, AMoveIsInsideUpToTheTolerance) {
  EXPECT_TRUE(is_inside(Segment::line({0, 0}, {10, 10}), square(), 1e-6));
  const Segment beside = Segment::line({1, -1e-5}, {9, -1e-5});
  EXPECT_FALSE(is_inside(beside, square(), 1e-6));
  EXPECT_TRUE(is_inside(beside, square(), 2e-5));
  EXPECT_FALSE(is_inside(Segment::line({5, 5}, {10.1, 5}), square(), 1e-6));
}

TEST(MoveChecks, AMoveIsNotInsideWhereItBendsOutBetweenItsEnds) {
  // Beyond the border by 0.003 over 0.44 of its 9 mm.
  const double radius = 8.3, depth = 0.003;
  const Vec2 centre{5, radius - depth};
  for (double from = -2.9; from < -1.6; from += 0.01)
    EXPECT_FALSE(is_inside(Segment::arc(centre, radius, from, 1.08), square(), 1e-6)) << from;
  EXPECT_TRUE(is_inside(Segment::arc({5, radius}, radius, -2, 0.86), square(), 1e-6));
}

TEST(MoveChecks, AMoveIsInsideWhereALookEveryMicrometreSaysSo) {
  // Round an island, whose border bends towards the move, and past a corner that sticks in.
  const Region around =
      make_region(shapes::rectangle(0, 0, 20, 20), {shapes::circle({10, 10}, 4).reversed()});
  const Region ell =
      make_region(shapes::polygon({{0, 0}, {20, 0}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}));
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int inside = 0, barely = 0;
  for (const Area& area : {Area({around}), Area({ell})})
    for (int i = 0; i < 400; ++i) {
      const Segment move = Segment::from_bulge({between(3, 17), between(3, 17)},
                                               {between(3, 17), between(3, 17)}, between(-1, 1));
      const int looks = static_cast<int>(1000 * move.length());
      double least = 1;
      for (int k = 0; k <= looks; ++k)
        least = std::min(least, area.signed_distance(move.point(static_cast<double>(k) / looks)));
      if (std::abs(least) < 1e-4) {
        ++barely;
        continue;
      }
      EXPECT_EQ(is_inside(move, area, 1e-6), least > 0) << i << ": " << least;
      inside += least > 0;
    }
  EXPECT_GT(inside, 100);
  EXPECT_LT(barely, 5);
}

TEST(MoveChecks, WhatAPassComesBackToIsWhatItTurnsByNearlyACircleAfter) {
  const Segment line = Segment::line({-5, 0}, {0, 0});
  const Segment half = Segment::arc({0, 2}, 2, -kPi / 2, kPi);
  const Segment next = Segment::arc({0, 2}, 2, kPi / 2, 0.8 * kPi);
  EXPECT_EQ(first_left_behind({}), 0u);
  EXPECT_EQ(first_left_behind({line, half}), 0u);
  EXPECT_EQ(first_left_behind({line, half, next}), 2u);
}

TEST(MoveChecks, TheIdleEndBeginsWhereTheToolTouchesNothingAnyMore) {
  // Cleared from the right, but for cusps between the ends of the earlier passes: the tool's side
  // leaves them at x = 0.17.
  ClearedGround ground({{-20, -20}, {20, 20}}, 3, nullptr);
  for (double y = -12; y <= 12; y += 2) ground.add(Segment::line({3, y}, {18, y}));
  const std::size_t before = ground.size();
  const std::vector<Segment> moves{Segment::line({-5, 0}, {0, 0}), Segment::line({0, 0}, {8, 0})};
  EXPECT_NEAR(idle_end_of(moves, 100, ground), 8 - 0.17, 0.03);
  EXPECT_EQ(idle_end_of(moves, 2, ground), 2);
  EXPECT_EQ(ground.size(), before);
  const std::vector<Segment> into{Segment::line({8, 0}, {-2, 0})};
  EXPECT_EQ(idle_end_of(into, 100, ground), 0);
}

}  // namespace
}  // namespace evenload
