#include "strategy/steer/steering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "judge/path_check.h"
#include "strategy/steer/stage.h"

namespace evenload {
namespace {

using shapes::rectangle;

// mm: meeting a wall within the tolerance of offsets, far below what the output can tell.
constexpr double kGap = 2e-6;
constexpr int kRandomFronts = 500;

void expect_tangent(const std::vector<Segment>& moves) {
  for (std::size_t i = 1; i < moves.size(); ++i) {
    EXPECT_LE(distance(moves[i - 1].b, moves[i].a), kGap) << "gap before move " << i;
    const Vec2 before = moves[i - 1].tangent(1), after = moves[i].tangent(0);
    EXPECT_LE(std::abs(std::atan2(cross(before, after), dot(before, after))), 0.01 * kDegree)
        << "kink before move " << i << " of " << moves.size();
  }
}

// Clears `x0` to `x1`, `y0` to `y1`.
void clear_rectangle(ClearedGround& ground, double x0, double y0, double x1, double y1,
                     std::vector<Segment>* lines = nullptr) {
  for (double y = y0 + kRadius;; y += kRadius) {
    y = std::min(y, y1 - kRadius);
    const Segment line = Segment::line({x0 + kRadius, y}, {x1 - kRadius, y});
    ground.add(line);
    if (lines) lines->push_back(line);
    if (y >= y1 - kRadius) break;
  }
}

TEST(Steering, HoldsTheEngagementAlongAStraightFront) {
  const Region centres = make_region(rectangle(-60, -40, 60, 40));
  const std::vector<Stage> stages = make_stages(centres, {});
  for (const double theta : {20.0, 40.0, 60.0, 90.0, 120.0}) {
    SCOPED_TRACE(theta);
    ClearedGround ground({{-70, -50}, {70, 50}}, kRadius, nullptr);
    // Material below y = 0, to the right of a tool that goes to the right.
    clear_rectangle(ground, -70, 0, 70, 50);
    Steering steering(ground, stages.front(), theta * kDegree);
    const Pass pass = steering.from_pose({{-30, kRadius}, 0});
    ASSERT_FALSE(pass.empty());
    expect_tangent(pass.moves);
    double looked_at = 0;
    for (const Segment& move : pass.moves)
      for (const double t : {0.0, 0.5, 1.0}) {
        const Vec2 p = move.point(t);
        // Away from both ends; afterwards the pass may have turned back.
        if (p.x > 15) {
          EXPECT_GT(looked_at, 10);
          return;
        }
        if (p.x < -15) continue;
        looked_at += move.length() / 3;
        EXPECT_NEAR(std::acos(1 - (kRadius - p.y) / kRadius), theta * kDegree, 0.5 * kDegree)
            << "at " << p.x;
      }
  }
}

TEST(Steering, CutsFromWallToWall) {
  const Region centres = make_region(rectangle(0, 0, 40, 30));
  const std::vector<Stage> stages = make_stages(centres, {});
  for (const double theta : {30.0, 60.0, 90.0}) {
    SCOPED_TRACE(theta);
    ClearedGround ground({{-3, -3}, {43, 33}}, kRadius, nullptr);
    std::vector<Segment> lines;
    clear_rectangle(ground, -3, -3, 13, 33, &lines);
    for (const double y :
         {0.0, 30.0}) {  // square off the front's ends, which the walls leave round
      lines.push_back(Segment::line({0, y}, {10, y}));
      ground.add(lines.back());
    }
    const Stage& stage = stages.front();
    // The bottom wall, before the front, with room to roll in.
    const BoundaryIndex::Hit hit = stage.centres.nearest({6, 0});
    Steering steering(ground, stage, theta * kDegree);
    const std::size_t before = ground.size();
    const Pass pass = steering.from_wall({hit.curve, hit.segment, hit.t});
    ASSERT_FALSE(pass.empty());
    expect_tangent(pass.moves);
    EXPECT_EQ(ground.size(), before + pass.moves.size());
    EXPECT_GT(pass.cut_length, 25);
    // A strip of nearly the straight wall's side step.
    EXPECT_GT(pass.cut_area, 0.7 * 30 * kRadius * (1 - std::cos(theta * kDegree)));

    std::vector<Move> moves;
    const auto go = [&](MoveKind kind, const Segment& s) {
      Move move;
      move.kind = kind;
      move.x = s.b.x;
      move.y = s.b.y;
      move.z = -1;
      move.feed = 100;
      move.sweep = s.sweep;
      move.cx = s.centre.x;
      move.cy = s.centre.y;
      moves.push_back(move);
    };
    for (const Segment& line : lines) {
      go(MoveKind::kEntry, Segment::line(line.a, line.a));
      go(MoveKind::kEntry, line);
    }
    go(MoveKind::kEntry, Segment::line(pass.moves.front().a, pass.moves.front().a));
    for (const Segment& move : pass.moves) go(MoveKind::kCut, move);
    path_check::Stock stock;
    stock.regions = {make_region(rectangle(-3, -3, 43, 33))};
    const path_check::Findings found = path_check::check_path(stock, kRadius, moves);
    EXPECT_LE(found.cut_engagement, (theta + 2) * kDegree);
    EXPECT_LE(found.gouge, 1e-5);
    EXPECT_NEAR(found.removed_area, pass.cut_area, 0.05 * found.removed_area);
    EXPECT_GE(found.climb_length, 0.99 * (found.climb_length + found.conventional_length));
  }
}

// rad engaged in the leading half circle at the share `t` of the move numbered `index`, as the
// ground was before it.
double engagement_of(const ClearedGround& ground, const Segment& move, double t,
                     std::size_t index) {
  const double right = angle_of(move.tangent(t)) - kPi / 2;
  std::vector<AngularInterval> arcs;
  ground.uncovered(move.point(t), right, right + kPi, arcs, 1e-6, index);
  double sum = 0;
  for (const AngularInterval& arc : arcs) sum += arc.width();
  return sum;
}

TEST(Steering, HoldsTheEngagementPastCuspsOfTheFront) {
  const Region centres = make_region(rectangle(-60, -40, 60, 40));
  const std::vector<Stage> stages = make_stages(centres, {});
  const double theta = 60 * kDegree;
  for (const double bend : {15.0, 45.0, 90.0})
    for (double from = -16; from < -14; from += 0.1) {
      ClearedGround ground({{-70, -50}, {70, 50}}, kRadius, nullptr);
      // The front falls away by `bend` degrees at x = 0.
      ground.add(Segment::line({-40, kRadius}, {0, kRadius}));
      ground.add(Segment::line({0, kRadius}, Vec2{0, kRadius} + 40.0 * unit(-bend * kDegree)));
      const std::size_t before = ground.size();
      Steering steering(ground, stages.front(), theta);
      const Pass pass = steering.from_pose({{from, kRadius}, 0});
      ASSERT_FALSE(pass.empty());
      double worst = 0;
      for (std::size_t i = 0; i < pass.moves.size(); ++i) {
        const Segment& move = pass.moves[i];
        if (std::abs(move.a.x) > 8) continue;
        const int looks = static_cast<int>(std::ceil(move.length() / 0.02));
        for (int k = 0; k <= looks; ++k)
          worst = std::max(worst,
                           engagement_of(ground, move, static_cast<double>(k) / looks, before + i));
      }
      EXPECT_GE(worst, theta - 1 * kDegree) << bend << " degrees, from " << from;
      EXPECT_LE(worst, theta + 1.5 * kDegree) << bend << " degrees, from " << from;
    }
}

TEST(Steering, TakesARunUpAlongTheExactBorderWhereTheLastPassEndedInAFront) {
  const Region centres = make_region(rectangle(0, 0, 40, 30));
  const std::vector<Stage> stages = make_stages(centres, {});
  const double theta = 60 * kDegree, window = 0.1;
  ClearedGround ground({{-5, -5}, {45, 35}}, kRadius, nullptr);
  clear_rectangle(ground, -3, -3, 15, 33);
  Vec2 at{12, 0};
  for (int i = 0; i < 4; ++i) {
    const std::size_t before = ground.size();
    Steering steering(ground, stages.back(), theta);
    // From the front, or from a little before it.
    const double from = i % 2 ? at.x - 0.03 : at.x;
    const BoundaryIndex::Hit hit = stages.back().centres.nearest({from, at.y});
    const Pass pass = steering.bit_by_bit({hit.curve, hit.segment, hit.t});
    ASSERT_FALSE(pass.empty()) << i;
    EXPECT_LE(pass.start().p.x, at.x - window + 1e-3) << i;
    EXPECT_GE(pass.start().p.x, at.x - window - 0.03) << i;
    EXPECT_GT(pass.end().p.x, at.x) << i;
    double sum = 0;
    for (std::size_t k = 0; k < pass.moves.size(); ++k) {
      constexpr int kLooks = 100;
      for (int n = 0; n < kLooks; ++n)
        sum += engagement_of(ground, pass.moves[k], (n + 0.5) / kLooks, before + k) / kLooks *
               pass.moves[k].length();
    }
    EXPECT_LE(sum, theta * window) << i;
    EXPECT_GT(engagement_of(ground, pass.moves.back(), 1, before + pass.moves.size() - 1), theta);
    at = pass.end().p;
  }
}

// What a pass meets.
struct Look {
  double at = 0;   // mm from the start
  double met = 0;  // rad
};

std::vector<Look> looks_along(const ClearedGround& ground, const Pass& pass, std::size_t before,
                              double step = 0.02) {
  std::vector<Look> looks;
  double done = 0;
  for (std::size_t i = 0; i < pass.moves.size(); ++i) {
    const double length = pass.moves[i].length();
    const int n = std::max(2, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k < n; ++k) {
      const double t = (k + 0.5) / n;
      looks.push_back({done + t * length, engagement_of(ground, pass.moves[i], t, before + i)});
    }
    done += length;
  }
  return looks;
}

double worst_mean(const std::vector<Look>& looks, double window) {
  double worst = 0, sum = 0;
  std::size_t first = 0;
  for (std::size_t k = 1; k < looks.size(); ++k) {
    sum += looks[k].met * (looks[k].at - looks[k - 1].at);
    while (first < k && looks[k].at - looks[first].at > window) {
      ++first;
      sum -= looks[first].met * (looks[first].at - looks[first - 1].at);
    }
    worst = std::max(worst, sum / window);
  }
  return worst;
}

// Three channels across each other, with a pass along the first: fronts rise, end, and are touched
// from two sides.
TEST(Steering, KeepsTheLimitAndKnowsItsContactAmongRandomFronts) {
  const Region centres = make_region(rectangle(-20, -16, 20, 10));
  std::mt19937 random(3);
  int passes = 0;
  for (int i = 0; i < kRandomFronts; ++i) {
    ClearedGround ground({{-50, -50}, {50, 50}}, kRadius, nullptr);
    ground.add(Segment::line({-20, 0}, {20, 0}));
    for (int k = 0; k < 3; ++k) {
      const Vec2 middle{uniform(random, -6, 12), uniform(random, -9, -4)};
      const double reach = uniform(random, 1, 9);
      const Vec2 along = reach * unit(uniform(random, 0, kPi));
      ground.add(Segment::line(middle - along, middle + along));
    }
    const double theta = uniform(random, 15, 90) * kDegree, turn = uniform(random, 0.1, 1.5);
    SCOPED_TRACE(testing::Message() << i << ": " << theta / kDegree << ", turn " << turn);
    Stage stage;
    stage.turn_radius = turn;
    stage.centres = Area({centres});
    stage.turns = Area(offset({centres}, -turn));
    const std::size_t before = ground.size();
    Steering steering(ground, stage, theta);
    const Pass pass = steering.from_pose({{-12, 0}, 0});
    if (pass.empty()) continue;
    ++passes;
    const std::vector<Look> looks = looks_along(ground, pass, before);
    EXPECT_LE(worst_mean(looks, 0.1), theta + 2 * kDegree);
    double last = 0, length = 0;
    for (const Segment& move : pass.moves) length += move.length();
    for (const Look& look : looks)
      if (look.met > 0.5 * kDegree) last = look.at;
    EXPECT_LE(last, length - pass.idle_after + 0.08);
  }
  EXPECT_GT(passes, kRandomFronts / 2);
}

// What a few lines beside a wall, y = 0, have left there between x = 12 and 19.
void leave_fronts_beside_wall(ClearedGround& ground, std::mt19937& random) {
  clear_rectangle(ground, -3, -3, 15, 33);
  clear_rectangle(ground, 14, -3, 43, 33);
  for (int k = 0; k < 6; ++k) {
    const Vec2 a{uniform(random, 12, 17), uniform(random, 0, 0.5)};
    ground.add(Segment::line(a, a + Vec2{uniform(random, 0, 2), uniform(random, 0, 0.3)}));
  }
}

TEST(Steering, KeepsTheMeanAlongTheExactBorderWhereFrontsAreMetHeadOn) {
  const Region centres = make_region(rectangle(0, 0, 40, 30));
  Stage exact;
  exact.centres = Area({centres});
  std::mt19937 random(11);
  int passes = 0;
  for (int i = 0; i < 2 * kRandomFronts; ++i) {
    ClearedGround ground({{-5, -5}, {45, 35}}, kRadius, nullptr);
    leave_fronts_beside_wall(ground, random);
    const double theta = uniform(random, 15, 60) * kDegree, from = 12 - uniform(random, 0, 0.4);
    SCOPED_TRACE(testing::Message() << i << ": " << theta / kDegree << " degrees, from " << from);
    const std::size_t before = ground.size();
    Steering steering(ground, exact, theta);
    const BoundaryIndex::Hit hit = exact.centres.nearest({from, 0});
    const Pass pass = steering.from_wall({hit.curve, hit.segment, hit.t});
    if (pass.empty()) continue;
    ++passes;
    EXPECT_LE(worst_mean(looks_along(ground, pass, before, 0.005), 0.1), theta + 1 * kDegree);
  }
  EXPECT_GT(passes, kRandomFronts / 2);
}

TEST(Steering, KeepsTheLimitAlongAWallWhereFrontsAreMetHeadOn) {
  const Region centres = make_region(rectangle(0, 0, 40, 30));
  std::mt19937 random(12);
  int passes = 0;
  for (int i = 0; i < 4 * kRandomFronts; ++i) {
    ClearedGround ground({{-5, -5}, {45, 35}}, kRadius, nullptr);
    leave_fronts_beside_wall(ground, random);
    const double theta = uniform(random, 15, 60) * kDegree, turn = uniform(random, 0.2, 1.5);
    const double from = 12 - uniform(random, 0, 0.4);
    SCOPED_TRACE(testing::Message() << i << ": " << theta / kDegree << ", turn " << turn);
    Stage stage;
    stage.turn_radius = turn;
    stage.centres = Area({centres});
    stage.turns = Area(offset({centres}, -turn));
    const std::size_t before = ground.size();
    Steering steering(ground, stage, theta);
    const BoundaryIndex::Hit hit = stage.centres.nearest({from, 0});
    const Pass pass = steering.from_wall({hit.curve, hit.segment, hit.t});
    if (pass.empty()) continue;
    ++passes;
    EXPECT_LE(worst_mean(looks_along(ground, pass, before, 0.01), 0.1), theta + 1.2 * kDegree);
  }
  EXPECT_GT(passes, kRandomFronts);
}

TEST(Steering, MakesNoPassWhereThereIsNoMaterial) {
  const Region centres = make_region(rectangle(0, 0, 20, 20));
  const std::vector<Stage> stages = make_stages(centres, {});
  ClearedGround ground({{-3, -3}, {23, 23}}, kRadius, nullptr);
  ground.add_disc({10, 10}, 40);
  Steering steering(ground, stages.front(), kPi / 3);
  EXPECT_TRUE(steering.from_pose({{10, 10}, 0}).empty());
  const BoundaryIndex::Hit hit = stages.front().centres.nearest({10, 0});
  EXPECT_TRUE(steering.from_wall({hit.curve, hit.segment, hit.t}).empty());
  EXPECT_EQ(ground.size(), 1u);
}

TEST(Stages, TurnMoreAndMoreTightlyUpToTheExactBorder) {
  for (const shapes::Named& pocket : shapes::pockets()) {
    SCOPED_TRACE(pocket.name);
    for (const Region& centres : offset({pocket.region}, -3)) {
      const Area exact({centres});
      const std::vector<Stage> stages = make_stages(centres, {});
      ASSERT_FALSE(stages.empty());
      EXPECT_LE(stages.front().turn_radius, 0.9);
      for (std::size_t k = 0; k < stages.size(); ++k) {
        if (k) {
          EXPECT_LT(stages[k].turn_radius, stages[k - 1].turn_radius);
        }
        for (const Curve& curve : stages[k].centres.curves())
          for (const Segment& s : curve.segments())
            for (const double t : {0.0, 0.37, 0.81}) {
              EXPECT_GE(exact.signed_distance(s.point(t)), -1e-5);
              // Where the tool may be, a full left turn touches no wall.
              if (stages[k].turn_radius > 0) {
                EXPECT_LE(stages[k].turns.signed_distance(s.point(t)), 1e-5);
              }
            }
      }
    }
  }
}

}  // namespace
}  // namespace evenload
