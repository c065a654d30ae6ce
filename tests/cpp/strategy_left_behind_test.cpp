// Slivers that widened turns leave.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "strategy/left_behind.h"

namespace evenload {
namespace {

constexpr double kRadius = 3;
constexpr double kTurn = 0.5;  // rad

// Along a line, round a turn to the left of `radius` at (0, 0), and along another.
std::vector<Segment> way_round_corner(double radius) {
  const double tangent = radius * std::tan(kTurn / 2);
  const Vec2 in{1, 0}, out = unit(kTurn);
  const Segment turn = Segment::arc({-tangent, radius}, radius, -kPi / 2, kTurn);
  return {Segment::line(-2.0 * in, turn.a), turn, Segment::line(turn.b, 2.0 * out)};
}

class LeftBehindTest : public testing::Test {
 protected:
  void cut(double planned, double posted) {
    const std::vector<Segment> plan = way_round_corner(planned), post = way_round_corner(posted);
    left.expect(plan, post, ground);
    for (const Segment& move : plan) ground.add(move);
    left.cut(post);
  }

  // Arrives at the second wall, `beyond` mm past the corner.
  bool is_met_by_link(double beyond) const {
    const Vec2 along = unit(kTurn), end = beyond * along;
    const Vec2 centre = end + 0.5 * left_normal(along);
    return left.is_met_along({Segment::arc(centre, 0.5, kTurn - kPi, kPi / 2)});
  }

  ClearedGround ground{{{-20, -20}, {20, 20}}, kRadius, nullptr};
  LeftBehind left{kRadius};
};

TEST_F(LeftBehindTest, IsMetByLinksThatEndInTheCornerAndByNoOthers) {
  EXPECT_FALSE(is_met_by_link(0.01));
  cut(0.001, 0.1);
  EXPECT_TRUE(is_met_by_link(0.001));
  EXPECT_TRUE(is_met_by_link(0.01));
  EXPECT_FALSE(is_met_by_link(0.5));
  EXPECT_FALSE(left.is_met_along({Segment::line({-2, 0.5}, {2, 0.5})}));
}

TEST_F(LeftBehindTest, IsNothingWhereTurnsArePostedAsPlanned) {
  cut(0.2, 0.2);
  EXPECT_FALSE(is_met_by_link(0.01));
}

TEST_F(LeftBehindTest, IsWhatLinesThatStandForATightArcDoNotReach) {
  cut(0.1, 0.1);
  EXPECT_TRUE(is_met_by_link(0.01));
  EXPECT_FALSE(is_met_by_link(0.5));
  cut(0.1, 0.1);  // along the same lines
  EXPECT_TRUE(is_met_by_link(0.01));
}

TEST_F(LeftBehindTest, IsNothingWhereTheGroundWasClear) {
  ground.add_disc({0, 0}, 10);
  cut(0.001, 0.1);
  EXPECT_FALSE(is_met_by_link(0.01));
}

TEST_F(LeftBehindTest, StaysUntilAPassIsPostedThroughItNotUntilOneIsPlannedSo) {
  cut(0.001, 0.1);
  cut(0.001, 0.2);
  EXPECT_TRUE(is_met_by_link(0.01));
  cut(0.001, 0.001);
  EXPECT_FALSE(is_met_by_link(0.01));
}

}  // namespace
}  // namespace evenload
