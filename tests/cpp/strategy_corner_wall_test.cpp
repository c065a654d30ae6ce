#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "geometry_shapes.h"
#include "strategy/corner_wall.h"

namespace evenload {
namespace {

constexpr double kDegree = kPi / 180, kRadius = 3, kTheta = 30 * kDegree;

// The places of the tool's centre: a wedge with its tip at the origin, which opens to the right.
Region wedge(double angle) {
  return make_region(shapes::polygon({{0, 0}, {10, 0}, 10 * unit(angle)}));
}

// The same between two arcs that bend away from each other.
Region horn() {
  const double half = std::asin(0.125), bulge = -std::tan(0.5 * half);
  return make_region(Curve({{{0, 0}, bulge}, {{5, 0}, 0}, {5 * unit(40 * kDegree), bulge}}, true));
}

Stage stage_of(const Region& centres, double turn) {
  Stage stage;
  stage.turn_radius = turn;
  stage.rooms = offset(offset({centres}, -kOpeningRatio * turn), kOpeningRatio * turn);
  stage.centres = Area(stage.rooms);
  stage.turns = Area(offset(stage.rooms, -turn));
  return stage;
}

// Cleared along both walls, and round the corner by an arc of `radius`.
ClearedGround ground_up_to(double radius, const Region& centres) {
  ClearedGround ground({{-4, -4}, {14, 14}}, kRadius, nullptr);
  const Stage cleared = stage_of(centres, radius / kOpeningRatio);
  for (const Segment& piece : cleared.centres.curves().front().segments()) ground.add(piece);
  return ground;
}

ClearedGround ground_up_to(double radius, double angle) {
  return ground_up_to(radius, wedge(angle));
}

// On the wall that leads to the corner, `before` mm from it.
WallPlace on_wall(const Stage& stage, double before, double angle) {
  const BoundaryIndex::Hit hit = stage.centres.nearest(before * unit(angle));
  return {hit.curve, hit.segment, hit.t};
}

double arc_of(const CornerWall& wall) { return kOpeningRatio * wall.stage.turn_radius; }

TEST(CornerWall, IsAsMuchTighterThanWhatIsClearedAsKeepsToTheEngagement) {
  for (const double degrees : {6.0, 10.0, 20.0, 40.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * kDegree, cleared = 0.1;
    const Stage stage = stage_of(wedge(angle), 0.93 * cleared / kOpeningRatio);
    ClearedGround ground = ground_up_to(cleared, angle);
    const double before = 1.02 * cleared / std::tan(0.5 * angle);
    const auto wall = corner_wall(stage, on_wall(stage, before, angle), ground, kTheta);
    if (degrees > 45) {  // the stage's own wall will do
      EXPECT_FALSE(wall);
      continue;
    }
    ASSERT_TRUE(wall);
    EXPECT_NEAR(arc_of(*wall), held_ratio(0.5 * angle, kTheta) * cleared, 1e-4 * cleared);
    const std::size_t known = ground.size();
    Steering steering(ground, wall->stage, kTheta);
    const Pass pass = steering.along_wall(wall->start);
    ASSERT_FALSE(pass.empty());
    EXPECT_GT(ground.size(), known);
    EXPECT_GT(pass.cut_area, 0);
    // One arc all round the corner.
    int arcs = 0;
    for (const Segment& move : pass.moves) arcs += move.is_arc();
    EXPECT_EQ(arcs, 1);
  }
}

TEST(CornerWall, LeadsToTheTipInPassesThatAllKeepToTheEngagement) {
  const double angle = 8 * kDegree;
  const Stage stage = stage_of(wedge(angle), 0.04);
  ClearedGround ground = ground_up_to(0.1, angle);
  double before = 0.1, radius = 0.1;
  int passes = 0;
  while (const auto wall = corner_wall(
             stage, on_wall(stage, 1.02 * radius / std::tan(0.5 * angle), angle), ground, kTheta)) {
    radius = arc_of(*wall);
    EXPECT_LT(radius, before);
    before = radius;
    Steering steering(ground, wall->stage, kTheta);
    ASSERT_FALSE(steering.along_wall(wall->start).empty());
    ++passes;
  }
  EXPECT_LT(held_ratio(0.5 * angle, kTheta) * radius, kOpeningRatio * stage.turn_radius);
  EXPECT_GT(passes, 20);
}

TEST(CornerWall, LiesBetweenWallsThatBend) {
  const double cleared = 0.1, angle = 40 * kDegree;
  const double tip = angle - 2 * std::asin(0.125);  // rad, between the arcs' tangents
  const Stage stage = stage_of(horn(), 0.04);
  ClearedGround ground = ground_up_to(cleared, horn());
  const double before = 1.2 * cleared / std::tan(0.5 * tip);
  const auto wall = corner_wall(stage, on_wall(stage, before, angle), ground, kTheta);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(arc_of(*wall), held_ratio(0.5 * tip, kTheta) * cleared, 0.005 * cleared);
  Steering steering(ground, wall->stage, kTheta);
  const Pass pass = steering.along_wall(wall->start);
  ASSERT_FALSE(pass.empty());
  EXPECT_GT(pass.cut_area, 0);
  const Area place({horn()});
  int tight = 0;
  for (const Segment& move : pass.moves) {
    tight += move.is_arc() && move.radius < 1;
    for (const double t : {0.0, 0.5, 1.0}) EXPECT_GT(place.signed_distance(move.point(t)), -1e-6);
  }
  EXPECT_EQ(tight, 1);
}

TEST(CornerWall, IsAPlainRegionBetweenWallsOfAnyBendAndLength) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int walls = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double angle = between(20, 110) * kDegree;
    const Vec2 a{between(0.3, 4), 0}, b = between(0.6, 1.6) * a.x * unit(angle);
    const double most = 0.1 * std::min(1.0, angle);  // of bulges: the walls do not cross
    const Region place = make_region(
        Curve({{{0, 0}, between(-most, most)}, {a, 0}, {b, between(-most, most)}}, true));
    const Stage stage = stage_of(place, between(0.005, 0.03));
    if (stage.rooms.empty()) continue;
    const double cleared = between(0.02, 0.12);
    if (offset({place}, -1.05 * cleared).empty()) continue;
    const ClearedGround ground = ground_up_to(cleared, place);
    const double before = between(1, 4) * cleared / std::tan(0.5 * angle);
    const double theta = between(15, 60) * kDegree;
    const BoundaryIndex::Hit hit = stage.centres.nearest(before * normalized(b));
    std::optional<CornerWall> wall;
    ASSERT_NO_THROW(wall = corner_wall(stage, {hit.curve, hit.segment, hit.t}, ground, theta));
    if (!wall) continue;
    ++walls;
    EXPECT_EQ(wall->stage.rooms.size(), 1u);
    EXPECT_GT(wall->stage.rooms.front().outer.signed_area(), 0);
    for (const Vec2 p : wall->stage.rooms.front().outer.flattened(1e-3))
      EXPECT_GT(Area({place}).signed_distance(p), -1e-3);
  }
  EXPECT_GT(walls, 20);
}

TEST(CornerWall, IsNoneWhereNothingOrTooLittleOrFarMoreIsCleared) {
  const double angle = 10 * kDegree;
  const Stage stage = stage_of(wedge(angle), 0.02);
  const WallPlace place = on_wall(stage, 2, angle);
  const ClearedGround untouched({{-4, -4}, {14, 14}}, kRadius, nullptr);
  EXPECT_FALSE(corner_wall(stage, place, untouched, kTheta));
  EXPECT_FALSE(corner_wall(stage, place, ground_up_to(0.02, angle), kTheta));
  EXPECT_TRUE(corner_wall(stage, place, ground_up_to(0.1, angle), kTheta));
  EXPECT_FALSE(corner_wall(stage, place, ground_up_to(0.15, angle), kTheta));
}

}  // namespace
}  // namespace evenload
