// What every strategy shares: the way from regions to a toolpath, and openings that it goes on
// from.
#include "strategy/pocket/pocket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/shapes.h"
#include "judge/corpus.h"
#include "judge/judged.h"
#include "strategy/choose/region_clearing.h"
#include "strategy/pocket/constant_engagement.h"
#include "support/errors.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

using shapes::rectangle;

RegionTask square_task(const ClearingParams& params) {
  RegionTask task;
  task.material = {make_region(rectangle(0, 0, 30, 24))};
  task.centres = offset(task.material, -(0.5 * params.tool_diameter + kWallGap)).front();
  return task;
}

// Walls that meet at a degree, 5.8 mm apart where they end: as far as the tool keeps from them it
// would stay 0.1 mm from where it touches both.
TEST(PocketTest, IsClearedToTheTipBetweenWallsThatAreNearlyParallel) {
  const Region room = make_region(shapes::polygon(
      {{0, 0}, {16, 0}, {16, 9}, {11.1, 9}, {10.9, 20.46}, {5.1, 20.46}, {4.9, 9}, {0, 9}}));
  ClearingParams params;
  const double tip = bounds_of(offset({room}, -0.5 * params.tool_diameter)).high.y;
  Progress progress;
  const Toolpath path = clear_pocket({room}, params, progress);
  double reached = 0;
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kCut) reached = std::max(reached, move.y);
  EXPECT_NEAR(reached, tip, 0.01);
  EXPECT_LT(reached, tip);
}

// Where the tool first comes down.
Vec2 first_place(const Toolpath& path) {
  for (const Move& move : path.moves)
    if (move.z < 0) return {move.x, move.y};
  return {};
}

// The tool comes in over the open side that is wished, near the place that is wished, in either cut
// mode, through pockets and slots alike; over a wall it never comes.
TEST(PocketTest, IsEnteredOverTheOpenSideThatIsWished) {
  struct Side {
    double width, height;
    Vec2 wish, from;
    double within;  // mm, of the place from which it comes
  };
  const auto open_above_and_below = [](double width, double height) {
    std::vector<Vertex> corners = rectangle(0, 0, width, height).vertices();
    corners[0].open = corners[2].open = true;
    return make_region(Curve(corners, true));
  };
  for (const Side& c : {Side{60, 40, {30, -2}, {30, -3}, 3}, Side{60, 40, {22, 45}, {22, 43}, 3},
                        Side{60, 40, {1, 39}, {3, 43}, 3}, Side{60, 40, {70, -1}, {57, -3}, 3},
                        Side{8, 60, {4, 0}, {4, -3}, 4}, Side{8, 60, {0, 70}, {4, 63}, 4}})
    for (const CutMode mode : {CutMode::kClimb, CutMode::kConventional}) {
      SCOPED_TRACE(testing::Message() << c.width << " wide, wish " << c.wish.x << ", " << c.wish.y);
      ClearingParams params;
      params.cut_mode = mode;
      params.open_side = c.wish;
      Progress progress;
      const Region pocket = open_above_and_below(c.width, c.height);
      const Toolpath path = clear_pocket({pocket}, params, progress);
      EXPECT_LT(distance(first_place(path), c.from), c.within)
          << first_place(path).x << ", " << first_place(path).y;
      EXPECT_NEAR(path.report.uncut_area, 0, 1e-3);
      EXPECT_LT(path.report.max_engagement, params.engagement_angle + 2 * kPi / 180);
      params.open_side.reset();
      Progress again;
      const Toolpath usual = clear_pocket({pocket}, params, again);
      EXPECT_LT(path.report.cutting_time, 1.1 * usual.report.cutting_time);
    }
}

// The ground of a hole that was drilled before is clear, wherever the tool comes in.
TEST(PocketTest, IsClearedOverAnOpenSideThoughThereIsAHole) {
  std::vector<Vertex> corners = rectangle(0, 0, 60, 40).vertices();
  corners[0].open = true;
  const Region pocket = make_region(Curve(corners, true));
  for (const Vec2 hole : {Vec2{30, 20}, Vec2{30, 5}, Vec2{54, 34}}) {
    SCOPED_TRACE(testing::Message() << hole.x << ", " << hole.y);
    ClearingParams params;
    params.entry_point = hole;
    params.hole_diameter = params.tool_diameter + 2;
    Progress progress;
    const Toolpath path = clear_pocket({pocket}, params, progress);
    EXPECT_EQ(path.report.termination, Termination::kComplete);
    EXPECT_NEAR(path.report.uncut_area, 0, 1e-3);
    EXPECT_LT(path.report.max_engagement, params.engagement_angle + 2 * kPi / 180);
    const Vec2 first = first_place(path);
    EXPECT_TRUE(first.y < 0 || distance(first, hole) <= 0.5 * params.hole_diameter)
        << first.x << ", " << first.y;
  }
}

TEST(PocketTest, ARegionIsGoneOnWithFromWhereItsOpeningEnds) {
  const ClearingParams params;
  RegionTask task = square_task(params);
  Progress progress;
  const RegionResult whole = clear_region(task, params, progress);
  ASSERT_FALSE(whole.runs.empty());
  const std::vector<PlanarMove>& moves = whole.runs.front().moves;
  const std::size_t taken = moves.size() / 3;

  RegionResult opening;
  opening.runs = {whole.runs.front()};
  opening.runs.front().moves.resize(taken);
  opening.passes = 7;
  opening.findings = {{FindingCode::kCirclesForPattern}};
  Plan plan(task, params, progress);
  plan.append(std::move(opening));
  clear_region(plan, task, params, progress);
  const RegionResult rest = plan.take();

  ASSERT_GE(rest.runs.front().moves.size(), taken);
  for (std::size_t i = 0; i < taken; ++i) {
    EXPECT_EQ(rest.runs.front().moves[i].segment.a, moves[i].segment.a);
    EXPECT_EQ(rest.runs.front().moves[i].segment.b, moves[i].segment.b);
  }
  for (const PlanarRun& run : rest.runs)
    for (std::size_t i = 1; i < run.moves.size(); ++i)
      EXPECT_LT(distance(run.moves[i - 1].segment.b, run.moves[i].segment.a), 1e-6);
  EXPECT_GT(rest.passes, 7);
  EXPECT_EQ(rest.findings.front().code, FindingCode::kCirclesForPattern);
  EXPECT_EQ(rest.uncut_area, 0);
}

TEST(PocketTest, WhatIsToldOfAfterEveryPassIsHowTheResultBegins) {
  const ClearingParams params;
  RegionTask task = square_task(params);
  std::vector<std::vector<PlanarRun>> told;
  task.follow = [&](const std::vector<PlanarRun>& runs) { told.push_back(runs); };
  Progress progress;
  const RegionResult whole = clear_region(task, params, progress);
  ASSERT_EQ(told.size(), static_cast<std::size_t>(whole.passes));
  for (const std::vector<PlanarRun>& runs : told) {
    ASSERT_LE(runs.size(), whole.runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      EXPECT_EQ(runs[i].descent, whole.runs[i].descent);
      ASSERT_LE(runs[i].moves.size(), whole.runs[i].moves.size());
      EXPECT_TRUE(
          std::equal(runs[i].moves.begin(), runs[i].moves.end(), whole.runs[i].moves.begin()));
    }
  }
  ASSERT_EQ(told.back().size(), whole.runs.size());
  EXPECT_EQ(told.back().back().moves.size(), whole.runs.back().moves.size());
}

TEST(PocketTest, CanBeCancelledOrFailWhileItsLoadIsLookedAt) {
  const ClearingParams params;
  const std::vector<Region> regions = {make_region(rectangle(10, 0, 40, 24))};
  const auto cleared = [&](bool fails) {
    int looks = 0;
    Progress progress([&](double share) { return share == 0 || ++looks < 5; });
    const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& given,
                                      Progress& watch) {
      RegionResult result = clear_region(task, given, watch);
      if (fails) throw std::runtime_error("no way on");
      return result;
    };
    return clear_by(clearer, regions, params, progress);
  };
  const Toolpath path = cleared(false);
  EXPECT_EQ(path.report.termination, Termination::kCancelled);
  EXPECT_GT(path.report.cut_length, 0);
  EXPECT_THROW(cleared(true), std::runtime_error);
}

// How often the work asked whether to go on, by the passes that were made then.
TEST(PocketTest, AsksWhetherToGoOnAllAlongASpiralAndWhileFeedsAreSought) {
  ClearingParams params;
  params.engagement_angle = kPi / 6;
  params.feed_control = FeedControl::kConstantRemovalRate;
  params.maximum_feed = 1000;
  const std::vector<Region> regions = {make_region(shapes::circle({0, 0}, 40))};
  std::vector<double> shares;
  Progress counting([&](double share) {
    shares.push_back(share);
    return true;
  });
  const Toolpath whole = clear_pocket(regions, params, counting);
  // Steering asks the ground at least twice for a move, whatever the machine.
  const auto in_spiral = std::count(shares.begin(), shares.end(), 0.0);
  EXPECT_GT(static_cast<double>(in_spiral) * kLooksOfStep, 2.0 * whole.moves.size());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  const auto at_the_end = std::count(shares.begin(), shares.end(), shares.back());
  EXPECT_GT(at_the_end, 10);

  const auto cancelled_at = [&](std::size_t call) {
    std::size_t calls = 0;
    Progress cancelling([&](double) { return ++calls < call; });
    const Toolpath path = clear_pocket(regions, params, cancelling);
    EXPECT_EQ(calls, call) << "nobody is asked again";
    EXPECT_EQ(path.report.termination, Termination::kCancelled);
    return path.report;
  };
  for (const double part : {0.05, 0.5, 0.9}) {
    const Report report =
        cancelled_at(1 + static_cast<std::size_t>(part * static_cast<double>(in_spiral)));
    EXPECT_EQ(report.passes, 0) << part;
    EXPECT_EQ(report.cut_length, 0) << part;
  }
  // All is cut, only the feeds are not found.
  EXPECT_NEAR(cancelled_at(static_cast<std::size_t>(shares.size() - at_the_end) + 5).cut_length,
              whole.report.cut_length, 1e-6);
}

TEST(PocketTest, AsksWhetherToGoOnWhileItSeeksAPattern) {
  ClearingParams params;
  params.engagement_angle = kPi / 9;
  const std::vector<Region> slot = {make_region(rectangle(0, 0, 60, 7))};
  std::size_t before = 0, calls = 0;
  Progress counting([&](double share) {
    before += share == 0;
    return true;
  });
  clear_pocket(slot, params, counting);
  EXPECT_GT(before, 100u);
  Progress cancelling([&](double) { return ++calls < before / 2; });
  const Toolpath path = clear_pocket(slot, params, cancelling);
  EXPECT_EQ(path.report.termination, Termination::kCancelled);
  EXPECT_EQ(calls, before / 2);
}

TEST(PocketTest, AClearerSeesClimbMillingAndItsPathIsMirroredBackForConventional) {
  ClearingParams params;
  const std::vector<Region> regions = {make_region(rectangle(10, 0, 40, 24))};
  Progress progress;
  std::vector<Bounds> seen;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& given,
                                    Progress& watch) {
    seen.push_back(bounds_of({task.centres}));
    return clear_region(task, given, watch);
  };
  for (const CutMode mode : {CutMode::kClimb, CutMode::kConventional}) {
    params.cut_mode = mode;
    const Toolpath path = clear_by(clearer, regions, params, progress);
    for (const Move& move : path.moves) EXPECT_GT(move.x, 12.9);
  }
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_GT(seen[0].low.x, 12.9);
  EXPECT_LT(seen[1].high.x, -12.9);
}

TEST(PocketTest, TheToolComesDownFastWhereTheGroundIsClearedAlready) {
  const corpus::Case pocket = corpus::load("star");
  Progress progress;
  const Toolpath path = clear_pocket({pocket.region}, pocket.params(), progress);
  ASSERT_GT(path.report.retracts, 0);
  int rapid = 0, fed = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Move &before = path.moves[i - 1], &move = path.moves[i];
    if (move.z >= before.z) continue;
    rapid += move.kind == MoveKind::kRapid;
    fed += move.kind != MoveKind::kRapid && move.feed < pocket.params().link_feed;
    // The last stretch is no rapid.
    if (move.kind == MoveKind::kRapid) {
      EXPECT_GT(move.z, pocket.params().top);
    }
  }
  EXPECT_GE(rapid, path.report.retracts);
  EXPECT_LE(fed, 1) << "into the hole";
}

TEST(PocketTest, AHoleTooTightToStartFromIsNotUsedWhereTheEntryIsAutomatic) {
  ClearingParams params;
  params.entry_point = Vec2{15, 12};
  params.hole_diameter = params.tool_diameter;
  const std::vector<Region> regions = {make_region(rectangle(0, 0, 30, 24))};
  Progress progress;
  const Toolpath path = clear_pocket(regions, params, progress);
  EXPECT_EQ(path.report.uncut_area, 0);
  EXPECT_TRUE(corpus::tells(path.report, FindingCode::kHoleTooTight));
  params.entry = EntryKind::kPredrilledHole;
  try {
    clear_pocket(regions, params, progress);
    FAIL() << "no error";
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.refusal(), Refusal::kHoleTooTight);
    EXPECT_EQ(error.where(), *params.entry_point);
  }
}

TEST(PocketTest, AGapThatWidensInwardsIsClearedWithoutBitsOfItsBorder) {
  const corpus::Case pocket = corpus::load("gap_that_widens_inwards");
  // One for each bit in the two corners at its end.
  EXPECT_LE(corpus::clear(pocket, pocket.params()).report.retracts, 7);
}

TEST(PocketTest, AGapThatWidensBehindItsMouthIsEnteredThroughIt) {
  const corpus::Case pocket = corpus::load("gap_that_widens_outwards");
  const Toolpath path = corpus::clear(pocket, pocket.params());
  int entries = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    entries += path.moves[i].kind == MoveKind::kEntry && path.moves[i - 1].kind != MoveKind::kEntry;
  EXPECT_EQ(entries, 1);
  EXPECT_EQ(path.report.uncut_area, 0);
}

TEST(PocketTest, ATipOfMicrometresIsClearedWithoutTurnsThatPostsCannotWrite) {
  const corpus::Case pocket = corpus::load("tip_of_micrometres");
  const Toolpath path = corpus::clear(pocket, pocket.params());
  EXPECT_EQ(path.report.uncut_area, 0);
  const auto corners = std::count_if(path.moves.begin(), path.moves.end(), [](const Move& move) {
    return move.kind == MoveKind::kCut && move.sweep != 0 &&
           becomes_corners(std::hypot(move.x - move.cx, move.y - move.cy), move.sweep);
  });
  EXPECT_LE(corners, 5);  // 90 with turns of micrometres
}

// Cuts of one move or two that begin by going back along the cut before.
struct WaysBack {
  int count = 0, divided = 0;
  double longest = 0;  // mm
};

WaysBack ways_back(const std::vector<Move>& moves) {
  WaysBack result;
  const auto along = [&](std::size_t i) {
    return Vec2{moves[i].x - moves[i - 1].x, moves[i].y - moves[i - 1].y};
  };
  for (std::size_t i = 1; i + 2 < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::kLink) continue;
    if (moves[i + 1].kind != MoveKind::kCut) continue;
    const Vec2 back = along(i), on = along(i + 1);
    if (norm(back) == 0) continue;  // straight down
    if (dot(normalized(back), normalized(on)) > -0.99) continue;
    ++result.count;
    result.divided += moves[i + 2].kind == MoveKind::kCut &&
                      dot(normalized(on), normalized(along(i + 2))) > 0.999;
    result.longest = std::max(result.longest, norm(back));
  }
  return result;
}

TEST(PocketTest, BitsOfATipAreReachedByGoingBackAndARunUp) {
  const corpus::Case pocket = corpus::load("tip_of_micrometres");
  ClearingParams params = pocket.params();
  params.feed_control = FeedControl::kConstantRemovalRate;
  const Toolpath path = corpus::clear(pocket, params);
  const WaysBack ways = ways_back(path.moves);
  EXPECT_GT(ways.count, 10);
  EXPECT_GT(ways.divided, 5);
  EXPECT_LT(ways.longest, 1);
  EXPECT_LE(path.report.retracts, 10);  // one for each bit otherwise
  // A run-up is a move of its own for its feed only; beside that, two cuts in line are rare.
  params.feed_control = FeedControl::kConstantFeed;
  EXPECT_LT(ways_back(corpus::clear(pocket, params).moves).divided, 0.5 * ways.divided);
}

// Moves per mm of path.
double blocks_of(const Toolpath& path) {
  return static_cast<double>(path.moves.size()) /
         (path.report.cut_length + path.report.link_length);
}

Toolpath with_feed_steps(const corpus::Case& pocket, const FeedSteps& steps) {
  ClearingParams params = pocket.params();
  params.feed_steps = steps;
  return corpus::clear(pocket, params);
}

TEST(PocketTest, TheFeedChangesAsOftenAsTheControllerCanTake) {
  const corpus::Case star = corpus::load("star");
  ClearingParams params = star.params();
  const Toolpath free = corpus::clear(star, params);
  EXPECT_LE(blocks_of(free), 1.1);
  params.most_blocks_per_metre = 850;
  const Toolpath few = corpus::clear(star, params);
  EXPECT_LE(blocks_of(few), 0.85);
  EXPECT_GT(blocks_of(few), 0.8);
  EXPECT_LT(few.report.cutting_time, 1.04 * free.report.cutting_time);
  // Where not even 4 % more time makes so few of them, they are as if there was no limit.
  params.most_blocks_per_metre = 100;
  EXPECT_EQ(corpus::clear(star, params).moves.size(), free.moves.size());
  params.most_blocks_per_metre = -1;
  EXPECT_THROW(corpus::clear(star, params), std::invalid_argument);
}

TEST(PocketTest, TheFeedChangesAsOftenAsPays) {
  const FeedSteps coarse{0.043, 0.2};
  const corpus::Case square = corpus::load("square60");
  const Toolpath fine = with_feed_steps(square, {}), rough = with_feed_steps(square, coarse);
  EXPECT_LT(blocks_of(fine), 0.4);
  EXPECT_GT(blocks_of(fine), 1.1 * blocks_of(rough));
  EXPECT_LT(fine.report.cutting_time, 0.998 * rough.report.cutting_time);
}

}  // namespace
}  // namespace evenload
