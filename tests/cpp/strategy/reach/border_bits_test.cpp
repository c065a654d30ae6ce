#include "strategy/reach/border_bits.h"

#include <gtest/gtest.h>

#include <vector>

#include "toolpath/machinable.h"

namespace evenload {
namespace {

PlanarMove cut(Vec2 a, Vec2 b) { return {MoveKind::kCut, Segment::line(a, b), 0}; }

// A link, then a cut of two moves along the x axis.
std::vector<PlanarMove> moves() {
  return {{MoveKind::kLink, Segment::line({-1, 1}, {0, 0}), 0},
          cut({0, 0}, {0.09, 0}),
          cut({0.09, 0}, {0.1, 0})};
}

TEST(WayBack, LiesOnTheCutsAsOneMoveWhereTheyAreOne) {
  const WayBack back = way_back(moves(), {{0.02, 0}, 0}, 1);
  ASSERT_TRUE(back.found);
  ASSERT_EQ(back.moves.size(), 1u);
  EXPECT_NEAR(distance(back.moves[0].a, {0.1, 0}), 0, 1e-12);
  EXPECT_NEAR(distance(back.moves[0].b, {0.02, 0}), 0, 1e-12);
}

TEST(WayBack, IsNoneWhereTheToolStandsThere) {
  const WayBack back = way_back(moves(), {{0.1, 0}, 0}, 1);
  EXPECT_TRUE(back.found);
  EXPECT_TRUE(back.moves.empty());
}

TEST(WayBack, IsNotFoundBesideTheCutsInAnotherDirectionTooFarOffOrBeforeALink) {
  EXPECT_FALSE(way_back(moves(), {{0.02, 0.001}, 0}, 1).found);
  EXPECT_FALSE(way_back(moves(), {{0.02, 0}, 0.01}, 1).found);
  EXPECT_FALSE(way_back(moves(), {{0.02, 0}, 0}, 0.07).found);
  EXPECT_FALSE(way_back(moves(), {{-0.5, 0.5}, -kPi / 4}, 1).found);
  EXPECT_FALSE(way_back({}, {{0, 0}, 0}, 1).found);
}

const auto kAnyWay = [](const std::vector<Segment>&) { return true; };

TEST(BesideCuts, TurnsOffTheCutToItsLeftByAnArcThatPostsCanWriteOrByTwoLines) {
  for (const double length : {0.03, 0.09, 0.5})
    for (const bool arcs : {true, false}) {
      SCOPED_TRACE(length);
      const Segment back = Segment::line({length, 0}, {0, 0});  // the cut leads along the x axis
      const std::vector<Segment> way = beside_cuts({back}, arcs, kAnyWay);
      EXPECT_EQ(way.size(), arcs ? 1u : 2u);
      EXPECT_NEAR(distance(way.front().a, back.a), 0, 1e-12);
      EXPECT_NEAR(distance(way.back().b, back.b), 0, 1e-12);
      EXPECT_GE(wrap_signed(kPi - angle_of(way.front().tangent(0))), kLeastAside - 1e-9);
      EXPECT_GE(wrap_signed(angle_of(way.back().tangent(1)) - kPi), kLeastAside - 1e-9);
      EXPECT_GT(way.front().point(arcs ? 0.5 : 1).y, 0);
      EXPECT_EQ(way.front().is_arc(), arcs);
      EXPECT_FALSE(is_tight(way.front()));
    }
}

TEST(BesideCuts, StaysWhereNothingBesideIsFreeAndWhereItIsAnArc) {
  const Segment line = Segment::line({0.09, 0}, {0, 0}), arc = Segment::arc({0, 1}, 1, 0, 0.5);
  EXPECT_EQ(beside_cuts({line}, true, [](const std::vector<Segment>&) { return false; }),
            std::vector<Segment>{line});
  EXPECT_EQ(beside_cuts({arc}, true, kAnyWay), std::vector<Segment>{arc});
  // The less it turns the less room it takes.
  const auto narrow = [](const std::vector<Segment>& way) {
    return way.front().point(0.5).y < 1e-3;
  };
  const std::vector<Segment> way = beside_cuts({line}, true, narrow);
  ASSERT_EQ(way.size(), 1u);
  EXPECT_NEAR(way.front().sweep, 2 * kLeastAside, 1e-9);
}

// 0.09 mm to a front that the tool meets with `width` mm, 0.01 mm into it.
std::size_t moves_of_bit(double width, FeedControl control, double run_up = 0.09) {
  ClearingParams params;
  params.tool_diameter = 6;
  params.engagement_angle = kPi / 3;
  params.feed = 255;
  params.maximum_feed = 1000;
  params.feed_control = control;
  Pass pass;
  pass.cut_area = width * 0.01;
  std::vector<Segment> way{Segment::line({0, 0}, {run_up + 0.01, 0})};
  divide_run_up(way, run_up, pass, params);
  if (way.size() == 2) {
    EXPECT_NEAR(way[0].length(), run_up, 1e-12);
    EXPECT_EQ(way[0].b, way[1].a);
    EXPECT_NEAR(way[1].length(), 0.01, 1e-12);
  }
  return way.size();
}

TEST(DivideRunUp, MakesTwoMovesWhereThatSavesMoreThanAMoveIsWorth) {
  // 60 * 0.09 / 64 s at 4 times the side step of 1.5 mm, and 60 * 0.09 / 1000 at most.
  EXPECT_EQ(moves_of_bit(6, FeedControl::kConstantRemovalRate), 2u);
  EXPECT_EQ(moves_of_bit(6, FeedControl::kConstantForce), 2u);
  EXPECT_EQ(moves_of_bit(1, FeedControl::kConstantRemovalRate), 1u);
  EXPECT_EQ(moves_of_bit(6, FeedControl::kConstantFeed), 1u);
  EXPECT_EQ(moves_of_bit(6, FeedControl::kConstantRemovalRate, 0.005), 1u);  // too short to write
}

}  // namespace
}  // namespace evenload
