#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry_shapes.h"
#include "strategy/fewer_moves.h"
#include "strategy/links.h"
#include "strategy/move_checks.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr double kToolRadius = 3;
constexpr double kTheta = kPi / 3;
constexpr double kSideStep = 1.5;  // of a straight cut at kTheta

const Area& room() {
  static const Area all({make_region(rectangle(-60, -60, 60, 60))});
  return all;
}

ClearingParams params() {
  ClearingParams params;
  params.tool_diameter = 2 * kToolRadius;
  params.engagement_angle = kTheta;
  params.feed = 255;
  params.maximum_feed = 1000;
  return params;
}

// Cleared along the x axis; what lies to the right of it is material.
ClearedGround front() {
  ClearedGround ground({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  ground.add(Segment::line({-50, 0}, {50, 0}));
  return ground;
}

// Tangent arcs of 1 mm each along the front at the limit, `curvatures` 1/mm.
std::vector<Segment> arcs_along_the_front(const std::vector<double>& curvatures) {
  std::vector<Segment> moves;
  Vec2 at{0, -kSideStep};
  double heading = 0;
  for (const double curvature : curvatures) {
    const double radius = 1 / std::abs(curvature), side = curvature > 0 ? 1 : -1;
    const Vec2 centre = at + side * radius * left_normal(unit(heading));
    moves.push_back(Segment::arc(centre, radius, heading - side * kPi / 2, curvature));
    at = moves.back().b;
    heading += curvature;
  }
  return moves;
}

std::vector<Segment> gentle() {
  return arcs_along_the_front({0.004, -0.008, 0.008, -0.008, 0.004});
}

std::vector<Segment> fewer(const std::vector<Segment>& moves, ClearedGround&& ground,
                           const Area& centres = room()) {
  return with_fewer_moves(moves, {0, length_of(moves)}, centres, ground, params(), kSmoothOverload);
}

bool are_same(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Segment& s, const Segment& t) {
    return s.a == t.a && s.b == t.b && s.sweep == t.sweep;
  });
}

class RowsFound : public testing::TestWithParam<Rows> {};
INSTANTIATE_TEST_SUITE_P(FewerMoves, RowsFound, testing::Values(Rows::kFitted, Rows::kQuick),
                         [](const auto& test) {
                           return test.param == Rows::kFitted ? "Fitted" : "Quick";
                         });

TEST_P(RowsFound, LeadOnAsBeforeWithinTheLimit) {
  ClearedGround ground = front();
  const std::vector<Segment> moves = gentle();
  const std::vector<Segment> result = with_fewer_moves(moves, {0, length_of(moves)}, room(), ground,
                                                       params(), kSmoothOverload, GetParam());
  ASSERT_EQ(result.size(), 2u);
  EXPECT_LE(distance(result.front().a, moves.front().a), 1e-9);
  EXPECT_LE(distance(result.back().b, moves.back().b), 1e-9);
  EXPECT_LE(norm(result.front().tangent(0) - moves.front().tangent(0)), 1e-6);
  EXPECT_LE(norm(result.back().tangent(1) - moves.back().tangent(1)), 1e-6);
  EXPECT_TRUE(is_tangent(result[0], result[1], 1e-6));
  std::vector<AngularInterval> engaged;
  for (const Segment& move : result)
    for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double heading = angle_of(move.tangent(t));
      ground.uncovered(move.point(t), heading - kPi / 2, heading + kPi / 2, engaged);
      ASSERT_EQ(engaged.size(), 1u);
      EXPECT_LE(engaged.front().width(), kTheta + kSmoothOverload);
      EXPECT_GE(engaged.front().width(), kTheta - 0.05);
    }
}

TEST(FewerMoves, AreNotMadeWhereTheyWouldMeetMoreThanTheLimit) {
  // The same moves, but deeper: what is above the limit already is not made anew.
  ClearedGround ground({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  ground.add(Segment::line({-50, 0.1}, {50, 0.1}));
  EXPECT_TRUE(are_same(fewer(gentle(), std::move(ground)), gentle()));
}

TEST(FewerMoves, AreNotMadeOfArcsThatTurnToAndFro) {
  const std::vector<Segment> moves = arcs_along_the_front({0.6, -1.2, 1.2, -1.2, 0.6});
  EXPECT_TRUE(are_same(fewer(moves, front()), moves));
}

TEST(FewerMoves, AreMadeWithinTheStretchOnly) {
  const std::vector<Segment> moves = gentle();
  ClearedGround ground = front();
  const auto within = [&](Stretch stretch) {
    return with_fewer_moves(moves, stretch, room(), ground, params(), kSmoothOverload);
  };
  EXPECT_TRUE(are_same(within({2.5, 5}), moves));
  EXPECT_TRUE(are_same(within({0, 2.5}), moves));
  const std::vector<Segment> result = within({0.5, 4.5});
  ASSERT_EQ(result.size(), 4u);
  EXPECT_TRUE(are_same({result.front(), result.back()}, {moves.front(), moves.back()}));
}

TEST(FewerMoves, LeaveTheMovesAlongTheBorder) {
  const std::vector<Segment> moves = gentle();
  std::vector<Vertex> vertices;
  for (const Segment& move : moves) vertices.push_back({move.a, move.bulge(), false});
  vertices.push_back({moves.back().b, 0, false});
  vertices.push_back({{5, 20}, 0, false});
  vertices.push_back({{0, 20}, 0, false});
  const Area centres({make_region(Curve(vertices, true))});
  EXPECT_TRUE(are_same(fewer(moves, front(), centres), moves));
}

TEST(FewerMoves, LeaveOnlyLongMovesAlongTheBorder) {
  std::vector<Segment> moves = gentle();
  const Vec2 corner = moves.front().a - Vec2{0.1, 0};
  moves.insert(moves.begin(), Segment::line(corner, moves.front().a));
  const Area centres({make_region(rectangle(-60, corner.y, 60, 60))});
  const std::vector<Segment> without = fewer(moves, front(), centres);
  EXPECT_LE(without.size(), 3u);
  EXPECT_FALSE(are_same({without.front()}, {moves.front()}));
  moves.front() = Segment::line(corner - Vec2{1, 0}, moves[1].a);
  const std::vector<Segment> result = fewer(moves, front(), centres);
  ASSERT_LE(result.size(), 4u);
  EXPECT_TRUE(are_same({result.front()}, {moves.front()}));
}

TEST(FewerMoves, LeaveWhatAPassComesBackTo) {
  ClearedGround ground({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  ground.add_disc({0, 0}, 10);
  std::vector<Segment> moves;
  Vec2 at{7.6, 0};
  double heading = kPi / 2;
  for (int i = 0; i < 48; ++i) {
    const double radius = 7.6 + i / 48.0;
    const Vec2 centre = at + radius * left_normal(unit(heading));
    moves.push_back(Segment::arc(centre, radius, heading - kPi / 2, kPi / 12));
    at = moves.back().b;
    heading += kPi / 12;
  }
  const std::size_t before = ground.size();
  const std::vector<Segment> result =
      with_fewer_moves(moves, {0, length_of(moves)}, room(), ground, params(), kSmoothOverload);
  EXPECT_EQ(ground.size(), before);
  // The first turn is as it was; of the last the moves are fewer.
  ASSERT_GT(result.size(), 24u);
  EXPECT_LT(result.size(), 40u);
  EXPECT_TRUE(are_same({result.begin(), result.begin() + 24}, {moves.begin(), moves.begin() + 24}));
  std::vector<AngularInterval> engaged;
  for (const Segment& move : result) {
    for (const double t : {0.1, 0.5, 0.9}) {
      const double on = angle_of(move.tangent(t));
      ground.uncovered(move.point(t), on - kPi / 2, on + kPi / 2, engaged);
      ASSERT_EQ(engaged.size(), 1u);
      EXPECT_LE(engaged.front().width(), kTheta + kSmoothOverload);
      EXPECT_GE(engaged.front().width(), 0.6 * kTheta);
    }
    ground.add(move);
  }
}

}  // namespace
}  // namespace evenload
