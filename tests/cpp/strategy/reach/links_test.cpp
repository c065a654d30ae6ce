#include "strategy/reach/links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "strategy/moves/move_ends.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr double kTurn = 0.9;

GroundBefore now(const ClearedGround& ground) { return {ground, ground.size()}; }

TEST(Links, LeadFromPoseToPoseTangentToBoth) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add_disc({20, 20}, 60);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const auto pose = [&]() {
      return Pose{{uniform(random, 2, 38), uniform(random, 2, 38)}, uniform(random, -kPi, kPi)};
    };
    const Pose from = pose(), to = pose();
    const std::vector<Segment> link = shortest_link(now(ground), centres, from, to, kTurn, 1e3);
    ASSERT_FALSE(link.empty());
    EXPECT_LE(distance(link.front().a, from.p), 1e-9);
    EXPECT_LE(distance(link.back().b, to.p), 1e-7);
    const auto angle_between = [](Vec2 a, Vec2 b) {
      return std::abs(std::atan2(cross(a, b), dot(a, b)));
    };
    EXPECT_LE(angle_between(link.front().tangent(0), unit(from.heading)), 1e-5);
    EXPECT_LE(angle_between(link.back().tangent(1), unit(to.heading)), 1e-5);
    for (std::size_t k = 1; k < link.size(); ++k) {
      EXPECT_LE(distance(link[k - 1].b, link[k].a), 1e-7);
      EXPECT_LE(angle_between(link[k - 1].tangent(1), link[k].tangent(0)), 1e-5);
    }
    for (const Segment& move : link)
      if (move.is_arc()) {
        EXPECT_GE(move.radius, 0.5 * kTurn - 1e-9);
      }
    EXPECT_GE(length_of(link), distance(from.p, to.p) - 1e-9);
    EXPECT_LE(length_of(link), distance(from.p, to.p) + 4 * kPi * kTurn + 1e-9);
    EXPECT_TRUE(is_free(now(ground), centres, link, 0.05));
    EXPECT_TRUE(
        shortest_link(now(ground), centres, from, to, kTurn, 0.9 * distance(from.p, to.p)).empty());
  }
}

TEST(Links, WithTightTurnsSeeAWallThatTheyPassForAMoment) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add_disc({20, 20}, 60);
  for (const double turn_radius : {0.05, 0.1, 0.2})
    for (const double start : {-0.3, -0.7, -1.1}) {
      // Round the lowest point, which lies beyond the wall by a hundredth of the radius.
      const auto turn = [&](double beyond) {
        return std::vector<Segment>{
            Segment::arc({20, turn_radius - beyond}, turn_radius, -kPi / 2 + start, 1.4)};
      };
      EXPECT_FALSE(is_free(now(ground), centres, turn(0.01 * turn_radius), 0));
      EXPECT_TRUE(is_free(now(ground), centres, turn(-1e-9), 0));
    }
}

// A micrometre is three degrees of engagement, both sides of the place that is touched.
TEST(Links, SeeMaterialThatAnArcTouchesForAMoment) {
  const Area centres({make_region(rectangle(-20, -20, 20, 20))});
  ClearedGround ground({{-23, -23}, {23, 23}}, kRadius, nullptr);
  for (const double y : {0.0, 2.0, 4.0, 6.0, 8.0, 10.0})
    ground.add(Segment::line({-20, y}, {20, y}));
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    const double radius = uniform(random, 0.2, 4), depth = uniform(random, 3.5e-4, 3e-3);
    const double before = uniform(random, 0.5, 1.5), after = uniform(random, 0.5, 1.5);
    const auto turn = [&](double deep) {
      return std::vector<Segment>{
          Segment::arc({0, radius - deep}, radius, -kPi / 2 - before, before + after)};
    };
    const double length = length_of(turn(0));
    for (const double ends : {0.05, length})
      EXPECT_FALSE(is_free(now(ground), centres, turn(depth), ends)) << radius << " " << ends;
    EXPECT_TRUE(is_free(now(ground), centres, turn(0), length));
    EXPECT_TRUE(is_free(now(ground), centres, turn(-1.1e-3), 0.05));
  }
}

TEST(Links, KeepOutOfMaterialAndWalls) {
  const Area centres({make_region(rectangle(0, 0, 40, 40), {rectangle(15, 5, 25, 35)})});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  for (const double x : {0.0, 3.0, 6.0, 9.0}) ground.add(Segment::line({x, 0}, {x, 40}));
  for (const double x : {31.0, 34.0, 37.0, 40.0}) ground.add(Segment::line({x, 0}, {x, 40}));
  // Material lies in the way, then the island alone, then nothing below it.
  const Pose left{{5, 20}, 0}, right{{35, 20}, 0};
  EXPECT_TRUE(shortest_link(now(ground), centres, left, right, kTurn, 1e3).empty());
  EXPECT_FALSE(is_free(now(ground), centres, {Segment::line(left.p, right.p)}, 0.05));
  EXPECT_FALSE(is_free(now(ground), centres, {Segment::line({5, 2}, {35, 2})}, 0.05));
  ground.add_disc({20, 20}, 60);
  EXPECT_TRUE(shortest_link(now(ground), centres, left, right, kTurn, 1e3).empty());
  EXPECT_FALSE(is_free(now(ground), centres, {Segment::line(left.p, right.p)}, 0.05));
  EXPECT_TRUE(is_free(now(ground), centres, {Segment::line({5, 2}, {35, 2})}, 0.05));
  EXPECT_FALSE(is_free(now(ground), centres, {Segment::line({5, 2}, {5, -1})}, 0.05));
}

TEST(Links, GoOnlyWhereTheGroundWasClearedBefore) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add_disc({5, 20}, 8);
  ground.add_disc({35, 20}, 8);
  const Pose left{{5, 20}, 0}, right{{35, 20}, 0};
  const GroundBefore before = now(ground);
  ground.add_disc({20, 20}, 60);
  EXPECT_TRUE(shortest_link(before, centres, left, right, kTurn, 1e3).empty());
  EXPECT_FALSE(shortest_link(now(ground), centres, left, right, kTurn, 1e3).empty());
}

TEST(Links, KeepClearOfTheWallAlongWhichTheyWouldOnlyGraze) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add(Segment::line({0, 0}, {40, 0}));  // and nothing beside
  const Pose from{{5, 0}, 0}, to{{35, 0}, 0};
  EXPECT_TRUE(shortest_link(now(ground), centres, from, to, kTurn, 1e3).empty());
  EXPECT_NEAR(
      length_of(shortest_link(now(ground), centres, from, to, kTurn, 1e3, LinkSpace::kGrazing)), 30,
      1e-9);
}

TEST(Links, TakeTwoArcsWhereThreePiecesAreHardlyShorter) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add_disc({20, 20}, 60);
  const Pose from{{20, 20}, 0}, back{{20, 21.9}, kPi};
  const std::vector<Segment> turn = shortest_link(now(ground), centres, from, back, kTurn, 1e3);
  EXPECT_LE(turn.size(), 2u);
  for (const Segment& move : turn) EXPECT_GE(move.radius, 0.5 * kTurn - 1e-9);
}

TEST(Links, TurnAboutInGapsOfHundredthsOfAMillimetre) {
  for (const double radius : {0.5, 3.0, 6.0})
    for (const double width : {0.5, 0.1, 0.05, 0.03}) {
      const double turn = 0.3 * radius;
      const Area centres({make_region(rectangle(0, 0, 40, width))});
      ClearedGround ground({{-radius, -radius}, {40 + radius, width + radius}}, radius, nullptr);
      ground.add(Segment::line({0, 0}, {40, 0}));
      ground.add(Segment::line({0, width}, {40, width}));
      const Pose from{{20, width}, kPi}, to{{20, 0}, 0};
      const std::vector<Segment> link =
          shortest_link(now(ground), centres, from, to, turn, 10, LinkSpace::kGrazing);
      ASSERT_FALSE(link.empty()) << radius << " " << width;
      EXPECT_LE(length_of(link), 4 * width);
      for (const Segment& move : link) {
        if (move.is_arc()) {
          EXPECT_GE(move.radius, std::min(0.008, 0.05 * turn) - 1e-9);
        }
        for (int i = 0; i <= 50; ++i)
          EXPECT_GE(centres.signed_distance(move.point(i / 50.0)), -1e-6);
      }
    }
}

TEST(Links, GoRoundAnIslandThatIsInTheirWay) {
  const Area centres({make_region(rectangle(-20, -20, 20, 20), {shapes::circle({0, -1}, 4)})});
  ClearedGround ground({{-23, -23}, {23, 23}}, kRadius, nullptr);
  ground.add_disc({0, 0}, 60);
  const Pose from{{-10, 0}, 0}, to{{10, 0}, 0};
  const std::vector<Segment> link = shortest_link(now(ground), centres, from, to, kTurn, 25);
  ASSERT_EQ(link.size(), 3u);
  EXPECT_LE(distance(link.front().a, from.p), 1e-9);
  EXPECT_LE(distance(link.back().b, to.p), 1e-9);
  for (std::size_t k = 1; k < link.size(); ++k)
    EXPECT_LE(norm(link[k - 1].tangent(1) - link[k].tangent(0)), 1e-6);
  for (const Segment& move : link) {
    EXPECT_GE(1 / std::max(1e-9, std::abs(move.curvature())), 0.5 * kTurn - 1e-9);
    for (int i = 0; i <= 50; ++i) EXPECT_GE(centres.signed_distance(move.point(i / 50.0)), 0);
  }
  EXPECT_TRUE(shortest_link(now(ground), centres, from, to, kTurn, 20.5).empty());
}

TEST(Links, AreOneArcWhereOneLeadsThere) {
  const Area centres({make_region(rectangle(0, 0, 40, 40))});
  ClearedGround ground({{-3, -3}, {43, 43}}, kRadius, nullptr);
  ground.add_disc({20, 20}, 60);
  const Segment arc = Segment::arc({20, 20}, 6, 0, 1.2);
  const Pose from{arc.a, kPi / 2}, to{arc.b, kPi / 2 + 1.2};
  const std::vector<Segment> link = shortest_link(now(ground), centres, from, to, kTurn, 1e3);
  ASSERT_EQ(link.size(), 1u);
  EXPECT_NEAR(link.front().radius, 6, 1e-6);
}

}  // namespace
}  // namespace evenload
