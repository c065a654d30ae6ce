// The path, its ground and the place of the tool, in step.
#include "strategy/plan/plan.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "geometry/shapes.h"

namespace evenload {
namespace {

constexpr double kRadius = 3;

RegionTask square() {
  RegionTask task;
  task.material = {make_region(shapes::rectangle(0, 0, 60, 40))};
  task.centres = make_region(shapes::rectangle(kRadius, kRadius, 60 - kRadius, 40 - kRadius));
  return task;
}

std::vector<Segment> line(Vec2 from, Vec2 to) { return {Segment::line(from, to)}; }

class PlanTest : public testing::Test {
 protected:
  PlanTest() : plan(task, params, progress) {}

  // Down by a helix about (20, 20), and a cut from there.
  void begin() {
    plan.come_down({DescentKind::kHelix, {22, 20}, {20, 20}, 2, {}, false});
    plan.add(MoveKind::kCut, line({22, 20}, {40, 20}));
    plan.count_pass();
  }

  RegionTask task = square();
  ClearingParams params;
  Progress progress;
  Plan plan;
};

TEST_F(PlanTest, KnowsNothingButThePreDrilledHole) {
  EXPECT_TRUE(plan.is_empty());
  EXPECT_FALSE(plan.ground().is_clear({30, 20}));
  EXPECT_FALSE(plan.link_to({{30, 20}, 0}, Area({task.centres}), 1));
  task.hole = Vec2{30, 20};
  params.hole_diameter = 2 * kRadius + 1;
  const Plan drilled(task, params, progress);
  EXPECT_TRUE(drilled.is_empty());
  EXPECT_TRUE(drilled.ground().is_clear({30, 20}));
}

TEST_F(PlanTest, StandsWhereItsMovesEndAndHasClearedWhatTheyCut) {
  begin();
  EXPECT_EQ(plan.here().p, (Vec2{40, 20}));
  EXPECT_NEAR(plan.here().heading, 0, 1e-12);
  EXPECT_FALSE(plan.may_turn());
  EXPECT_TRUE(plan.runs().front().new_region);
  EXPECT_TRUE(plan.ground().is_clear({20, 20}));  // by the helix
  EXPECT_TRUE(plan.ground().is_clear({40, 20}));
  EXPECT_FALSE(plan.ground().is_clear({40, 21}));
  plan.plunge({{20, 20}, 1}, true);
  EXPECT_TRUE(plan.may_turn());
  EXPECT_EQ(plan.here().heading, 1);
  EXPECT_FALSE(plan.runs().back().new_region);
}

TEST_F(PlanTest, LinksOverClearGroundAloneAndClearsNothingByThem) {
  plan.come_down({DescentKind::kHelix, {32, 20}, {20, 20}, 12, {}, false});
  plan.add(MoveKind::kCut, line({32, 20}, {33, 20}));
  const std::size_t moves = plan.ground().size();
  EXPECT_FALSE(plan.link_to({{50, 20}, 0}, Area({task.centres}), 1));
  EXPECT_EQ(plan.runs().front().moves.size(), 1u);
  EXPECT_TRUE(plan.link_to({{20, 20}, kPi}, Area({task.centres}), 1));
  EXPECT_EQ(plan.made().links, 1);
  EXPECT_EQ(plan.ground().size(), moves);
  EXPECT_NEAR(distance(plan.here().p, {20, 20}), 0, 1e-9);
  for (const PlanarMove& move : plan.runs().front().moves)
    if (move.kind == MoveKind::kLink) {
      EXPECT_TRUE(plan.ground().is_clear(move.segment.point(0.5)));
    }
  // It stands there.
  EXPECT_TRUE(plan.link_to(plan.here(), Area({task.centres}), 1));
  EXPECT_EQ(plan.made().links, 1);
}

TEST_F(PlanTest, GoesBackToAMark) {
  begin();
  plan.tell({FindingCode::kHelixForRamp});
  const Plan::Mark mark = plan.mark();
  plan.add(MoveKind::kCut, line({40, 20}, {40, 30}));
  plan.plunge({{20, 20}, 0}, true);
  plan.add(MoveKind::kCut, line({20, 20}, {20, 30}));
  plan.count_pass();
  const RegionResult later = since(mark, plan.made());
  ASSERT_EQ(later.runs.size(), 2u);
  ASSERT_EQ(later.runs.front().moves.size(), 1u);
  EXPECT_EQ(later.runs.front().moves.front().segment.b, (Vec2{40, 30}));
  EXPECT_EQ(later.passes, 1);
  EXPECT_TRUE(later.findings.empty());

  plan.roll_back(mark);
  EXPECT_EQ(plan.runs().size(), 1u);
  EXPECT_EQ(plan.runs().front().moves.size(), 1u);
  EXPECT_EQ(plan.here().p, (Vec2{40, 20}));
  EXPECT_EQ(plan.made().passes, 1);
  EXPECT_FALSE(plan.ground().is_clear({40, 30}));
  EXPECT_FALSE(plan.ground().is_clear({20, 30}));

  // What is since a mark goes on from it as before.
  plan.go_on_by(later);
  EXPECT_EQ(plan.runs().size(), 2u);
  EXPECT_EQ(plan.made().passes, 2);
  EXPECT_EQ(plan.made().findings.size(), 1u);
  EXPECT_EQ(plan.here().p, (Vec2{20, 30}));
  EXPECT_TRUE(plan.ground().is_clear({40, 30}));
}

TEST_F(PlanTest, TakesWhatOthersMade) {
  begin();
  Plan grown = plan;
  grown.add(MoveKind::kCut, line({40, 20}, {40, 30}));
  grown.plunge({{20, 20}, 0}, true);
  grown.add(MoveKind::kCut, line({20, 20}, {20, 30}));
  grown.tell({FindingCode::kHelixForRamp});
  const std::size_t moves = grown.ground().size();
  EXPECT_FALSE(plan.ground().is_clear({40, 30}));  // a copy

  Plan elsewhere(task, params, progress);
  elsewhere.know(grown.runs());
  EXPECT_TRUE(elsewhere.is_empty());
  EXPECT_TRUE(elsewhere.ground().is_clear({40, 30}));
  EXPECT_EQ(elsewhere.ground().size(), moves);

  Plan room(task, params, progress);
  room.append(grown.made());
  room.append(grown.made());
  EXPECT_EQ(room.runs().size(), 4u);
  EXPECT_TRUE(room.runs().front().new_region);
  EXPECT_FALSE(room.runs()[2].new_region);
  EXPECT_EQ(room.made().findings.size(), 2u);

  plan.adopt(grown.take());
  EXPECT_EQ(plan.ground().size(), moves);  // nothing twice
  EXPECT_EQ(plan.here().p, (Vec2{20, 30}));
  EXPECT_EQ(plan.made().findings.size(), 1u);
}

// Path, ground and place are in step, wherever the job is cancelled.
TEST_F(PlanTest, IsSoundWhereItIsCancelled) {
  Progress impatient([](double) { return false; });
  Plan cancelled(task, params, impatient);
  cancelled.plunge({{5, 5}, 0}, false);
  std::vector<Segment> moves;
  for (int i = 0; i < 1000; ++i)
    moves.push_back(Segment::line({5 + 0.02 * i, 5}, {5.02 + 0.02 * i, 5}));
  EXPECT_THROW(cancelled.add(MoveKind::kCut, moves), Cancelled);
  const std::vector<PlanarMove>& made = cancelled.runs().back().moves;
  ASSERT_LT(made.size(), moves.size());
  EXPECT_EQ(made.size(), cancelled.ground().size());
  EXPECT_EQ(cancelled.here().p, made.empty() ? (Vec2{5, 5}) : made.back().segment.b);
}

TEST_F(PlanTest, KeepsWhatOthersMadeWhereItIsCancelled) {
  RegionResult room;
  room.runs.push_back({{DescentKind::kPlunge, {5, 5}, {}, 0, {}, false}, {}, true});
  for (int i = 0; i < 1000; ++i)
    room.runs.back().moves.push_back(
        {MoveKind::kCut, Segment::line({5 + 0.02 * i, 5}, {5.02 + 0.02 * i, 5}), 0});
  room.passes = 3;
  Progress impatient([](double) { return false; });
  Plan appended(task, params, impatient), adopted(task, params, impatient);
  EXPECT_THROW(appended.append(room), Cancelled);
  EXPECT_THROW(adopted.adopt(room), Cancelled);
  for (const Plan* each : {&appended, &adopted}) {
    EXPECT_EQ(each->runs().back().moves.size(), 1000u);
    EXPECT_EQ(each->made().passes, 3);
    EXPECT_NEAR(distance(each->here().p, {25, 5}), 0, 1e-9);
  }
}

TEST_F(PlanTest, CountsLinksThatFollowEachOtherOnce) {
  begin();
  plan.add(MoveKind::kLink, line({40, 20}, {30, 20}));
  plan.add(MoveKind::kLink, line({30, 20}, {25, 20}));
  plan.add(MoveKind::kCut, line({25, 20}, {25, 30}));
  plan.add(MoveKind::kLink, line({25, 30}, {25, 25}));
  EXPECT_EQ(plan.made().links, 2);
}

TEST_F(PlanTest, CountsARegionsTightTurnsOnce) {
  begin();
  plan.note_turn(0.4, {1, 2});
  plan.note_turn(0.2, {3, 4});
  EXPECT_EQ(plan.made().tight_turns.rooms, 1);
  EXPECT_EQ(plan.made().tight_turns.radius, 0.2);
  EXPECT_EQ(plan.made().tight_turns.at, (Vec2{3, 4}));
}

}  // namespace
}  // namespace evenload
