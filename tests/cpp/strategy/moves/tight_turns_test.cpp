#include "strategy/moves/tight_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/turn_demands.h"
#include "strategy/moves/wider_bi_arc.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr double kToolRadius = 3;
constexpr double kTheta = kPi / 3;

const Region& room() {
  static const Region all = make_region(rectangle(-50, -50, 50, 50));
  return all;
}

ClearedGround cleared_ground() {
  ClearedGround ground({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  ground.add_disc({0, 0}, 60);
  return ground;
}

// A line, a turn of `radius` by `sweep`, a line.
std::vector<Segment> turn(double heading, double radius, double sweep) {
  const Vec2 start = -2.0 * unit(heading);
  const Segment first = Segment::line(start, {0, 0});
  const double side = sweep > 0 ? 1 : -1;
  const Segment arc = Segment::arc(side * radius * left_normal(unit(heading)), radius,
                                   heading - side * kPi / 2, sweep);
  return {first, arc, Segment::line(arc.b, arc.b + 2.0 * arc.tangent(1))};
}

std::vector<Segment> widened(const std::vector<Segment>& moves, ClearedGround& ground,
                             double widening = 0.004) {
  const Area area({room()});
  return without_tight_turns(moves, {area, area}, ground, kTheta, widening);
}

bool has_corners(const std::vector<Segment>& moves) {
  return std::any_of(moves.begin(), moves.end(), [](const Segment& move) {
    return move.is_arc() && becomes_corners(move.radius, move.sweep);
  });
}

TEST(TightTurns, BecomeTangentArcsThatStayArcs) {
  std::mt19937 random(11);
  ClearedGround ground = cleared_ground();
  for (int round = 0; round < 300; ++round) {
    const double sweep = uniform(random, 0.05, 0.7) * (round % 2 ? 1 : -1);
    const std::vector<Segment> moves =
        turn(uniform(random, -kPi, kPi), uniform(random, 0.06, 0.07), sweep);
    ASSERT_TRUE(has_corners(moves));
    const std::vector<Segment> wide = widened(moves, ground);
    ASSERT_EQ(wide.size(), 3u);
    EXPECT_FALSE(has_corners(wide)) << wide[1].radius << ", " << wide[1].sweep;
    EXPECT_LE(distance(wide.front().a, moves.front().a), 1e-12);
    EXPECT_LE(distance(wide.back().b, moves.back().b), 1e-12);
    for (std::size_t i = 1; i < wide.size(); ++i) {
      EXPECT_LE(distance(wide[i - 1].b, wide[i].a), 1e-9);
      EXPECT_LE(norm(wide[i - 1].tangent(1) - wide[i].tangent(0)), 1e-5);
    }
    // The tightest that will do: a little less would become corners.
    EXPECT_LE(wide[1].radius * wide[1].radius * std::sin(std::abs(sweep)), 2 * kLeastSpan);
  }
}

// From the tighter arc to the line no one arc leads: that arc gives way, too.
TEST(TightTurns, GiveWayTogetherWithATighterArcBesideThem) {
  ClearedGround ground = cleared_ground();
  for (const bool reversed : {false, true}) {
    const Segment before = Segment::arc({0, 0}, 0.4685, 0, 0.3),
                  middle = Segment::arc(before.b - 0.1094 * unit(0.3), 0.1094, 0.3, 1.06),
                  tight = Segment::arc(middle.b - 0.1368 * unit(1.36), 0.1368, 1.36, 0.08);
    std::vector<Segment> moves{before, middle, tight,
                               Segment::line(tight.b, tight.b + tight.tangent(1))};
    if (reversed) {
      std::reverse(moves.begin(), moves.end());
      for (Segment& move : moves) move = move.reversed();
    }
    ASSERT_TRUE(has_corners(moves));
    const std::vector<Segment> wide = widened(moves, ground, 0.0028);
    EXPECT_EQ(wide.size(), 3u);
    EXPECT_FALSE(has_corners(wide));
    for (std::size_t i = 1; i < wide.size(); ++i)
      EXPECT_TRUE(is_tangent(wide[i - 1], wide[i], 1e-5)) << i;
  }
}

// What posts do not show as a corner is none here. Nothing may turn to the right first, so that the
// second arc must begin beyond the joint.
TEST(TightTurns, GiveWayToBiArcsPastAJointThatIsAlmostSmooth) {
  ClearedGround ground = cleared_ground();
  const Area above({make_region(rectangle(-50, 0, 50, 50))});
  const TurnDemands demands{above, above, 0.0005, 0.004, ground, kTheta};
  for (const double joint : {0.003, 0.02}) {
    const Segment before = Segment::line({-0.3, 0}, {0, 0}),
                  tight = Segment::arc({0, 0.194}, 0.194, -kPi / 2, 0.052);
    const double heading = 0.052 + joint;
    const Segment after =
        Segment::arc(tight.b + 0.211 * left_normal(unit(heading)), 0.211, heading - kPi / 2, 0.7);
    const std::vector<Segment> wide = with_wider_bi_arc({before, tight, after}, 1, 2, demands);
    if (joint > 0.01) {
      EXPECT_TRUE(wide.empty());
      continue;
    }
    ASSERT_FALSE(wide.empty());
    EXPECT_FALSE(has_corners(wide));
    for (std::size_t i = 1; i < wide.size(); ++i)
      EXPECT_TRUE(is_tangent(wide[i - 1], wide[i], 1e-5)) << i;
  }
}

TEST(TightTurns, StayWhereAWiderArcWouldLeaveThemTooFar) {
  ClearedGround ground = cleared_ground();
  const std::vector<Segment> moves = turn(0.3, 0.02, 1.4);
  const std::vector<Segment> same = widened(moves, ground);
  ASSERT_EQ(same.size(), moves.size());
  EXPECT_EQ(same[1].radius, moves[1].radius);
  EXPECT_FALSE(has_corners(widened(moves, ground, 0.05)));
}

TEST(TightTurns, StayWhereAWiderArcWouldMeetMoreThanTheLimit) {
  ClearedGround untouched({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  const std::vector<Segment> moves = turn(0, 0.065, 0.5);
  EXPECT_EQ(widened(moves, untouched)[1].radius, moves[1].radius);
  EXPECT_EQ(untouched.size(), 0u);
  ClearedGround cleared = cleared_ground();
  EXPECT_GT(widened(moves, cleared)[1].radius, moves[1].radius);
}

TEST(TightTurns, LeaveLessWhereTheEngagementIsSmall) {
  EXPECT_EQ(most_widening(2 * kTheta, kToolRadius, 0.005), 0.004);
  EXPECT_EQ(most_widening(2 * kTheta, kToolRadius, 0.001), 0.001);
  for (const double theta : {0.1, 0.2, 0.4}) {
    // The tool meets what is left, of this thickness at the most, on an arc this long.
    const double met = std::acos(1 - most_widening(theta, kToolRadius, 0.005) / kToolRadius);
    // Links may meet a degree, whatever the angle.
    EXPECT_NEAR(met, std::max(0.04 * theta, 0.9 * kPi / 180), 1e-3 * theta);
  }
}

// A row of left turns, each tangent to the one before: radius in mm, sweep in rad.
std::vector<Segment> row_of(const std::vector<std::pair<double, double>>& turns) {
  std::vector<Segment> row{Segment::line({-2, 0}, {0, 0})};
  for (const auto& [radius, sweep] : turns) {
    const Vec2 along = row.back().tangent(1);
    row.push_back(Segment::arc(row.back().b + radius * left_normal(along), radius,
                               angle_of(along) - kPi / 2, sweep));
  }
  return row;
}

TEST(TightTurns, BetweenArcsNearlyAsTightBecomeBiArcs) {
  // The curvature only rises: no one arc is tangent to the first and the last.
  for (const double turned : {0.03, 0.06, 0.09})
    for (const double theta : {15 * kPi / 180, kPi / 3}) {
      const std::vector<Segment> moves = row_of({{0.27, 0.5}, {0.24, turned}, {0.2, 0.6}});
      ASSERT_TRUE(has_corners(moves));
      ClearedGround ground = cleared_ground();
      const double film = most_widening(theta, kToolRadius, 0.005);
      const Area area({room()});
      const std::vector<Segment> wide =
          without_tight_turns(moves, {area, area}, ground, theta, film);
      EXPECT_FALSE(has_corners(wide)) << turned;
      EXPECT_EQ(wide.front().a, moves.front().a);
      EXPECT_LE(distance(wide.back().b, moves.back().b), 1e-9);
      EXPECT_LE(norm(wide.back().tangent(1) - moves.back().tangent(1)), 1e-5);
      for (std::size_t i = 1; i < wide.size(); ++i) {
        EXPECT_LE(distance(wide[i - 1].b, wide[i].a), 1e-9);
        EXPECT_LE(norm(wide[i - 1].tangent(1) - wide[i].tangent(0)), 1e-5);
      }
      for (const Segment& move : moves)
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
          double least = 1;
          for (const Segment& other : wide)
            least = std::min(least, other.distance_to(move.point(t)));
          EXPECT_LE(least, 0.004);
        }
    }
}

TEST(TightTurns, ThatLeadIntoTheMaterialStayWhereABiArcWouldMeetTooMuch) {
  const std::vector<Segment> moves = row_of({{0.27, 0.5}, {0.24, 0.06}, {0.2, 0.6}});
  ClearedGround untouched({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  const Area area({room()});
  const std::vector<Segment> same =
      without_tight_turns(moves, {area, area}, untouched, kTheta, 0.004);
  EXPECT_EQ(same.size(), moves.size());
  EXPECT_TRUE(has_corners(same));
}

TEST(TightTurns, OfTheBorderItselfStay) {
  // Its corner is an arc of 0.065 mm.
  const Curve corner({{{-10, -10}, 0},
                      {{10, -10}, 0},
                      {{10, 9.935}, std::tan(kPi / 8)},
                      {{9.935, 10}, 0},
                      {{-10, 10}, 0}},
                     true);
  const Area place({make_region(corner)});
  ClearedGround ground = cleared_ground();
  const std::vector<Segment> moves{corner.segment(1), corner.segment(2), corner.segment(3)};
  ASSERT_TRUE(has_corners(moves));
  EXPECT_TRUE(has_corners(without_tight_turns(moves, {place, place}, ground, kTheta, 0.05)));
}

TEST(TightTurns, OfABorderThatIsNoWallAreWidened) {
  const std::vector<Segment> moves = turn(0, 0.2227, 0.0724);
  const Vec2 up{0, 20};
  const Area place({make_region(Curve({{moves[0].a, 0},
                                       {moves[1].a, moves[1].bulge()},
                                       {moves[2].a, 0},
                                       {moves[2].b, 0},
                                       {moves[2].b + up, 0},
                                       {moves[0].a + up, 0}},
                                      true))});
  ClearedGround ground = cleared_ground();
  ASSERT_TRUE(has_corners(moves));
  const auto posted = [&](const Area& walls) {
    return without_tight_turns(moves, {place, walls}, ground, kTheta, 0.004);
  };
  EXPECT_TRUE(has_corners(posted(place)));
  const std::vector<Segment> wide = posted(Area({room()}));
  EXPECT_FALSE(has_corners(wide));
  for (const Segment& move : wide)
    for (int i = 0; i <= 20; ++i) EXPECT_GE(place.signed_distance(move.point(i / 20.0)), -2e-6);
}

}  // namespace
}  // namespace evenload
