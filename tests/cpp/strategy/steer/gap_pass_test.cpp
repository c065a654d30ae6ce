#include "strategy/steer/gap_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

constexpr double kTheta = 30 * kDegree;
constexpr double kLength = 4;  // mm of the gaps

struct Gap {
  std::string name;
  Region room;  // of the tool's centre: along the x axis, symmetrical to it
};

// `left` and `right` mm: half the gap's width at its ends, `length` mm apart. `bulge`: of both
// walls, into the gap.
Gap gap(const std::string& name, double left, double right, double bulge, double length = kLength) {
  return {
      name,
      make_region(Curve(
          {{{0, -left}, bulge}, {{length, -right}, 0}, {{length, right}, bulge}, {{0, left}, 0}},
          true))};
}

std::vector<Gap> gaps() {
  return {gap("narrowing", 0.2, 0.06, 0),       gap("widening", 0.06, 0.2, 0),
          gap("parallel", 0.1, 0.1, 0),         gap("throat", 0.25, 0.25, -0.04),
          gap("tapering", 0.42, 0.03, 0, 0.85), gap("opening", 0.03, 0.14, 0)};
}

class InAGap : public testing::TestWithParam<Gap> {
 protected:
  InAGap() : centres({GetParam().room}), ground({{-4, -4}, {8, 4}}, kRadius, nullptr) {}

  bool has_straight_walls() const {
    const std::vector<Segment> walls = GetParam().room.outer.segments();
    return std::none_of(walls.begin(), walls.end(), [](const Segment& s) { return s.is_arc(); });
  }

  // On the wall that leads along the x axis, with the gap to its left.
  Pose on_wall(double x) const {
    const BoundaryIndex::Hit hit = centres.nearest({x, -1});
    const Segment wall = centres.segment_at(hit);
    return {wall.point(hit.t), angle_of(wall.tangent(hit.t))};
  }

  // Clears all up to about where on_wall(x) is.
  void clear_up_to(double x) {
    for (double at = 0; at < x; at += 0.02) {
      const Vec2 low = on_wall(at).p;
      ground.add(Segment::arc({low.x, 0}, -low.y, -kPi / 2, kPi));
    }
  }

  double met_at(const Segment& move, double t) const {
    std::vector<AngularInterval> arcs;
    const double heading = angle_of(move.tangent(t));
    ground.uncovered(move.point(t), heading - kPi / 2, heading + kPi / 2, arcs, 1e-6, known);
    double met = 0;
    for (const AngularInterval& arc : arcs) met += arc.width();
    return met;
  }

  Area centres;
  ClearedGround ground;
  std::size_t known = 0;  // moves before the pass
};

TEST_P(InAGap, PassesTurnAboutByArcsThatPostsCanWriteAndGetOnAsFarAsTheEngagementAllows) {
  clear_up_to(1);
  double reached = 1;
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    known = ground.size();
    const Pass pass = gap_pass(centres, on_wall(0.9), ground, kTheta);
    ASSERT_FALSE(pass.empty());
    ASSERT_EQ(ground.size(), known + pass.moves.size());
    double most = 0, front = 0;
    for (const Segment& move : pass.moves) {
      EXPECT_FALSE(is_tight(move));
      EXPECT_TRUE(is_inside(move, centres, 1e-6));
      for (int k = 0; k <= 200; ++k) most = std::max(most, met_at(move, k / 200.0));
      for (int k = 0; k <= 200; ++k) front = std::max(front, move.point(k / 200.0).x);
    }
    if (has_straight_walls()) {
      const auto arcs = std::count_if(pass.moves.begin(), pass.moves.end(),
                                      [](const Segment& move) { return move.is_arc(); });
      EXPECT_EQ(arcs, GetParam().name == "opening" ? 2 : 1);
    }
    EXPECT_LT(centres.nearest(pass.moves.back().b).distance, 1e-3);
    EXPECT_GT(pass.moves.back().b.y, 0);  // on the other wall
    EXPECT_LT(most, kTheta + 0.9 * kDegree);
    EXPECT_GT(most, 0.8 * kTheta);
    for (std::size_t k = 1; k < pass.moves.size(); ++k)
      EXPECT_TRUE(is_tangent(pass.moves[k - 1], pass.moves[k], 1e-3));
    EXPECT_LT(met_at(pass.moves.back(), 1), 1.5 * kDegree);  // a film
    if (i > 0) {
      EXPECT_GT(front, reached);
    }
    reached = front;
    EXPECT_GT(pass.cut_area, 0);
    EXPECT_GT(pass.cut_length, 0);
    EXPECT_GE(pass.idle_before, 0);
    EXPECT_GE(pass.idle_after, 0);
    EXPECT_LE(pass.idle_before + pass.cut_length, length_of(pass.moves) + 1e-9);
  }
}

TEST_P(InAGap, ThereIsNoneWhereNothingOrEverythingIsCleared) {
  EXPECT_TRUE(gap_pass(centres, on_wall(0.9), ground, kTheta).empty());
  EXPECT_EQ(ground.size(), 0u);
  clear_up_to(kLength);
  const std::size_t all = ground.size();
  EXPECT_TRUE(gap_pass(centres, on_wall(0.9), ground, kTheta).empty());
  EXPECT_EQ(ground.size(), all);
}

INSTANTIATE_TEST_SUITE_P(Gaps, InAGap, testing::ValuesIn(gaps()),
                         [](const auto& given) { return given.param.name; });

TEST(GapPass, IsNoneInAWideRoomOrOffTheWall) {
  const Area centres({make_region(shapes::rectangle(0, 0, 20, 2))});
  ClearedGround ground({{-4, -4}, {24, 8}}, kRadius, nullptr);
  for (double at = -1; at < 1; at += 0.02) ground.add(Segment::arc({at, 0.1}, 0.1, -kPi / 2, kPi));
  EXPECT_TRUE(gap_pass(centres, {{0.98, 0}, 0}, ground, kTheta).empty());
  const Area narrow({make_region(shapes::rectangle(0, 0, 20, 0.2))});
  EXPECT_TRUE(gap_pass(narrow, {{0.98, 0.1}, 0}, ground, kTheta).empty());  // between the walls
  EXPECT_TRUE(gap_pass(narrow, {{0.98, 0}, 1}, ground, kTheta).empty());    // across them
  EXPECT_FALSE(gap_pass(narrow, {{0.98, 0}, 0}, ground, kTheta).empty());
}

}  // namespace
}  // namespace evenload
