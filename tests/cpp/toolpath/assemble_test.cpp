#include "toolpath/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "toolpath/ramp.h"

namespace evenload {
namespace {

PlanarMove planar(MoveKind kind, const Segment& segment) { return {kind, segment, 100}; }

AssemblyParams two_levels() {
  AssemblyParams params;
  params.top = 1;
  params.levels = {-1.25, -3.1};
  params.helix_angle = 0.05;
  return params;
}

PlanarRun helix_run() {
  PlanarRun run;
  run.descent.kind = DescentKind::kHelix;
  run.descent.centre = {10, 10};
  run.descent.radius = 2.7;
  run.descent.at = {12.7, 10};
  run.moves = {
      planar(MoveKind::kCut, Segment::arc({10, 10}, 2.7, 0, 1.9 * kPi)),
      planar(MoveKind::kLink, Segment::line(Segment::arc({10, 10}, 2.7, 0, 1.9 * kPi).b, {10, 4})),
      planar(MoveKind::kCut, Segment::line({10, 4}, {3, 4}))};
  return run;
}

PlanarRun plunge_run(bool over_cleared_ground) {
  PlanarRun run;
  run.descent.at = {4, 5};
  run.descent.over_cleared_ground = over_cleared_ground;
  run.moves = {planar(MoveKind::kCut, Segment::line({4, 5}, {4, 9}))};
  return run;
}

PlanarRun ramp_run() {
  PlanarRun run;
  run.descent.kind = DescentKind::kRamp;
  run.descent.at = {0, 0};
  run.descent.ramp_by = {Vec2{6, 3}};
  run.moves = {planar(MoveKind::kCut, Segment::line({0, 0}, {0, 9}))};
  return run;
}

PlanarRun ramp_round_run() {
  PlanarRun run = ramp_run();
  run.descent.ramp_by = {{6, 3}, {5, 4}, {1, 3}};
  return run;
}

double flat_length(const Move& from, const Move& to) {
  return to.sweep != 0 ? std::abs(to.sweep) * std::hypot(to.x - to.cx, to.y - to.cy)
                       : std::hypot(to.x - from.x, to.y - from.y);
}

std::vector<std::vector<PlanarRun>> jobs() {
  return {{helix_run()},
          {ramp_run()},
          {ramp_round_run()},
          {plunge_run(false)},
          {helix_run(), plunge_run(true), ramp_run(), plunge_run(false)}};
}

TEST(Assemble, ReachesEveryLevelExactlyAndTheLastLast) {
  for (const std::vector<PlanarRun>& runs : jobs()) {
    const AssemblyParams params = two_levels();
    double above = params.top;
    std::vector<double> levels;
    for (const Move& move : assemble(runs, params)) {
      if (move.kind != MoveKind::kCut) continue;
      if (levels.empty() || levels.back() != move.z) levels.push_back(move.z);
      EXPECT_LE(move.z, above);
      above = move.z;
    }
    EXPECT_EQ(levels, params.levels);
  }
}

// Three regions, the second with a retract of its own.
std::vector<PlanarRun> three_regions() {
  std::vector<PlanarRun> runs{helix_run(), ramp_run(), plunge_run(true), plunge_run(false)};
  runs[0].new_region = runs[1].new_region = runs[3].new_region = true;
  for (PlanarMove& move : runs[3].moves) {
    move.segment.a.x += 40;
    move.segment.b.x += 40;
  }
  runs[3].descent.at.x += 40;
  return runs;
}

// (region, level) of every cut, without repetitions in a row.
std::vector<std::pair<int, double>> order_of(const std::vector<Move>& moves) {
  std::vector<std::pair<int, double>> order;
  for (const Move& move : moves) {
    if (move.kind != MoveKind::kCut) continue;
    const int region = move.x > 30 ? 2 : move.x == 0 || move.x == 4 ? 1 : 0;
    if (order.empty() || order.back() != std::pair(region, move.z))
      order.emplace_back(region, move.z);
  }
  return order;
}

TEST(Assemble, CutsEveryRegionToItsEndBeforeTheNextByRegion) {
  AssemblyParams params = two_levels();
  const double a = params.levels[0], b = params.levels[1];
  const std::vector<std::pair<int, double>> by_region{{0, a}, {0, b}, {1, a},
                                                      {1, b}, {2, a}, {2, b}};
  EXPECT_EQ(order_of(assemble(three_regions(), params)), by_region);
}

TEST(Assemble, CutsAllRegionsAtOneLevelBeforeTheNextByDepth) {
  AssemblyParams params = two_levels();
  params.order_by = OrderBy::kDepth;
  const double a = params.levels[0], b = params.levels[1];
  const std::vector<std::pair<int, double>> by_depth{{0, a}, {1, a}, {2, a},
                                                     {0, b}, {1, b}, {2, b}};
  EXPECT_EQ(order_of(assemble(three_regions(), params)), by_depth);
}

TEST(Assemble, DescendsAnewIntoEveryRegionAtEveryLevelAndTravelsHighBetweenThem) {
  for (const OrderBy order : {OrderBy::kRegion, OrderBy::kDepth}) {
    AssemblyParams params = two_levels();
    params.order_by = order;
    const std::vector<Move> moves = assemble(three_regions(), params);
    int descents = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const Move &from = moves[i - 1], &to = moves[i];
      descents += to.kind == MoveKind::kEntry && from.kind != MoveKind::kEntry;
      if (to.kind != MoveKind::kRapid || (from.x == to.x && from.y == to.y)) continue;
      EXPECT_GE(std::min(from.z, to.z), params.safe_height);
      if (std::abs(from.x - to.x) > 20) {
        EXPECT_GE(std::min(from.z, to.z), params.clearance_height);
      }
    }
    EXPECT_EQ(descents, 6);
  }
}

// One region has no others to go to between its levels.
TEST(Assemble, IsTheSameByRegionAndByDepthForOneRegion) {
  for (const std::vector<PlanarRun>& runs : jobs()) {
    AssemblyParams params = two_levels();
    const std::vector<Move> by_region = assemble(runs, params);
    params.order_by = OrderBy::kDepth;
    const std::vector<Move> by_depth = assemble(runs, params);
    ASSERT_EQ(by_region.size(), by_depth.size());
    for (std::size_t i = 0; i < by_region.size(); ++i) {
      EXPECT_EQ(by_region[i].x, by_depth[i].x);
      EXPECT_EQ(by_region[i].z, by_depth[i].z);
    }
  }
}

TEST(Assemble, StartsHighAndEndsHigh) {
  for (const std::vector<PlanarRun>& runs : jobs()) {
    const AssemblyParams params = two_levels();
    const std::vector<Move> moves = assemble(runs, params);
    EXPECT_EQ(moves.front().kind, MoveKind::kRapid);
    EXPECT_EQ(moves.front().z, params.clearance_height);
    const Descent& descent = runs.front().descent;
    const Vec2 above{moves.front().x, moves.front().y};
    if (descent.kind == DescentKind::kHelix)
      EXPECT_NEAR(distance(above, descent.centre), descent.radius, 1e-9);
    else
      EXPECT_EQ(distance(above, descent.at), 0);
    EXPECT_EQ(moves.back().kind, MoveKind::kRapid);
    EXPECT_EQ(moves.back().z, params.clearance_height);
    EXPECT_TRUE(assemble({}, params).size() <= 1);
  }
}

TEST(Assemble, MovesRapidlyBelowTheSafeHeightOnlyStraightUpOrDownWhereItMay) {
  for (const std::vector<PlanarRun>& runs : jobs()) {
    const AssemblyParams params = two_levels();
    const std::vector<Move> moves = assemble(runs, params);
    double level = params.top;
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const Move &from = moves[i - 1], &to = moves[i];
      if (to.kind == MoveKind::kCut) level = to.z;
      if (to.kind != MoveKind::kRapid) continue;
      EXPECT_EQ(to.sweep, 0);
      EXPECT_EQ(to.feed, 0);
      if (from.x != to.x || from.y != to.y) {
        EXPECT_GE(std::min(from.z, to.z), params.safe_height);
      } else if (to.z < from.z) {
        // Down: to above what the levels before have left, also where this one is cleared.
        EXPECT_GT(to.z, level);
        EXPECT_EQ(std::count(params.levels.begin(), params.levels.end(), to.z), 0);
      }
    }
  }
}

TEST(Assemble, DescendsNoMoreSteeplyThanTheHelixAngle) {
  for (const std::vector<PlanarRun>& runs :
       {std::vector<PlanarRun>{helix_run()}, {ramp_run()}, {ramp_round_run()}})
    for (const double angle : {0.01, 0.05, 0.5}) {
      AssemblyParams params = two_levels();
      params.helix_angle = angle;
      const std::vector<Move> moves = assemble(runs, params);
      double flat_at_level = 0, floor = params.top;
      for (std::size_t i = 1; i < moves.size(); ++i) {
        const Move &from = moves[i - 1], &to = moves[i];
        if (to.kind == MoveKind::kCut) floor = to.z;
        if (to.kind != MoveKind::kEntry) continue;
        const double flat = flat_length(from, to), drop = from.z - to.z;
        EXPECT_EQ(to.feed, params.entry.plunge);
        if (flat == 0) {  // straight down in the air, to just above what is to be cut
          EXPECT_GT(to.z, floor);
          EXPECT_LT(to.z, floor + 0.1);
          continue;
        }
        EXPECT_GT(flat, 0);
        EXPECT_GE(drop, -1e-12);
        EXPECT_LE(drop, std::tan(angle) * flat + 1e-9);
        flat_at_level += drop <= 1e-12 && to.z == params.levels.back() ? flat : 0;
        if (moves[i + 1].kind == MoveKind::kCut) {
          const Vec2 at = runs.front().descent.at;
          EXPECT_LE(std::hypot(to.x - at.x, to.y - at.y), 1e-9);
          EXPECT_TRUE(to.z == params.levels[0] || to.z == params.levels[1]);
        }
      }
      // The floor under the slope is taken as well.
      const Descent& descent = runs.front().descent;
      const double whole =
          descent.kind == DescentKind::kHelix ? 2 * kPi * 2.7 : ramp_length(descent);
      EXPECT_GE(flat_at_level, whole - 1e-9);
    }
}

// Posts write heights to 0.0001 mm: a line of two micrometres would be level at the angle itself.
TEST(Assemble, DescendsOnTheShortestLineOfARampAndHoldsTheAngleOnTheOthers) {
  PlanarRun run = ramp_run();
  run.descent.ramp_by = {{0.1, 0}, {0.1, 0.0018}, {0, 0.05}};
  for (const double degrees : {0.3, 1.0, 3.0, 20.0}) {
    AssemblyParams params = two_levels();
    params.helix_angle = degrees * kPi / 180;
    const std::vector<Move> moves = assemble({run}, params);
    int lines = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const Move &from = moves[i - 1], &to = moves[i];
      const double flat = flat_length(from, to), drop = from.z - to.z;
      const bool is_level_round =
          std::min(std::abs(from.z - params.levels[0]), std::abs(from.z - params.levels[1])) < 1e-9;
      if (to.kind != MoveKind::kEntry || flat == 0 || is_level_round) continue;
      ++lines;
      EXPECT_GE(drop, 1e-4) << degrees;
      EXPECT_LE(drop, std::max(std::tan(params.helix_angle) * flat, kLeastDescent) + 1e-9);
    }
    EXPECT_GT(lines, 8);
  }
}

TEST(Assemble, TakesWhatTheSlopeLeftFasterWhereItThinsOut) {
  AssemblyParams params = two_levels();
  params.entry = {255, 400, 1.5 * 255};
  const std::vector<Move> moves = assemble({helix_run()}, params);
  double fastest = 0, turned = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::kEntry) continue;
    const bool level = moves[i].z == moves[i - 1].z;
    if (!level) {
      EXPECT_EQ(moves[i].feed, 255);
    }
    if (level) turned += moves[i].sweep;
    fastest = std::max(fastest, moves[i].feed);
  }
  EXPECT_NEAR(fastest, 400, 1e-9);
  EXPECT_NEAR(turned, 2 * 2 * kPi, 1e-6);
}

// The air above a shallow cut is no part of its depth.
TEST(Assemble, RemovesNoMoreThanACutInTheLevelTurnOfAShallowLevel) {
  AssemblyParams params = two_levels();
  params.top = 0;
  params.levels = {-0.1};
  params.helix_angle = 0.0035;
  params.entry = {30, 400, 1.5 * 255};
  const std::vector<Move> moves = assemble({helix_run()}, params);
  double left = 2 * 2 * kPi * 2.7 / 2;  // mm of the level turn
  double steepness = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::kEntry) continue;
    const double flat = flat_length(moves[i - 1], moves[i]), drop = moves[i - 1].z - moves[i].z;
    if (flat == 0) continue;
    if (drop > 1e-9) {
      steepness = drop / flat;
      continue;
    }
    const double layer = std::min(0.1, steepness * left);
    EXPECT_LE(moves[i].feed * layer * 2 * params.tool_radius,
              std::max(params.entry.rate * 0.1, params.entry.plunge * layer * 6) + 1e-6);
    left -= flat;
  }
  EXPECT_NEAR(left, 0, 1e-6);
}

TEST(Assemble, TurnsByHalfACircleAtMostAndNeverLeavesItsArcs) {
  for (const std::vector<PlanarRun>& runs : jobs()) {
    const std::vector<Move> moves = assemble(runs, two_levels());
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const Move &from = moves[i - 1], &to = moves[i];
      EXPECT_LE(std::abs(to.sweep), kPi * 1.001);
      if (to.sweep == 0) continue;
      const Vec2 centre{to.cx, to.cy};
      const Vec2 end = centre + rotated(Vec2{from.x, from.y} - centre, to.sweep);
      EXPECT_LE(distance(end, {to.x, to.y}), 1e-9);
    }
  }
}

// Arcs of any sweep, as long as they are arcs.
TEST(Assemble, SplitsFullCircles) {
  PlanarRun run = plunge_run(false);
  run.moves = {planar(MoveKind::kCut, Segment::arc({0, 5}, 4, 0, 2 * kPi)),
               planar(MoveKind::kCut, Segment::arc({0, 5}, 4, 0, -1.5 * kPi))};
  double turned = 0;
  for (const Move& move : assemble({run}, two_levels())) {
    EXPECT_LE(std::abs(move.sweep), kPi * 1.001);
    turned += std::abs(move.sweep);
  }
  EXPECT_NEAR(turned, 2 * 3.5 * kPi, 1e-9);
}

TEST(Assemble, KeepsLinesOnTheSideOfEachArcWhereTheToolMayBe) {
  for (const bool wall_on_left : {false, true})
    for (const double sweep : {2.0, -2.0, 5.5, -5.5}) {
      const Segment arc = Segment::arc({0, 0}, 5, 0.3, sweep);
      PlanarRun run;
      run.descent.at = arc.a;
      run.moves = {planar(MoveKind::kCut, arc)};
      AssemblyParams params = two_levels();
      params.arcs = false;
      params.wall_on_left = wall_on_left;
      const std::vector<Move> moves = assemble({run}, params);
      const bool wall_outside = (sweep > 0) != wall_on_left;
      for (std::size_t i = 1; i < moves.size(); ++i) {
        const Move &from = moves[i - 1], &to = moves[i];
        EXPECT_EQ(to.sweep, 0);
        if (to.kind != MoveKind::kCut) continue;
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const double r = std::hypot(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
          EXPECT_LE(std::abs(r - 5), 1.001 * params.tolerance);
          if (wall_outside) {
            EXPECT_LE(r, 5 + 1e-9);
          } else {
            EXPECT_GE(r, 5 - 1e-9);
          }
        }
      }
    }
}

TEST(Assemble, LiftsLinksAndNothingElse) {
  PlanarRun far = plunge_run(false);
  far.moves.push_back(planar(MoveKind::kLink, Segment::line({4, 9}, {64, 9})));
  far.moves.push_back(planar(MoveKind::kCut, Segment::line({64, 9}, {64, 12})));
  for (const double lift : {0.3, 100.0})
    for (const bool is_long : {false, true}) {
      AssemblyParams params = two_levels();
      params.link_lift = lift;
      const std::vector<Move> moves = assemble({is_long ? far : helix_run()}, params);
      double highest = -1e9;
      for (std::size_t i = 1; i < moves.size(); ++i) {
        if (moves[i].kind == MoveKind::kCut) {
          EXPECT_NEAR(moves[i - 1].z, moves[i].z, 1e-12) << "a cut that slopes";
        }
        if (moves[i].kind == MoveKind::kLink) {
          highest = std::max(highest, moves[i].z);
          EXPECT_LE(std::abs(moves[i].z - moves[i - 1].z),
                    0.3 * flat_length(moves[i - 1], moves[i]) + 1e-9)
              << "a link that is too steep";
        }
      }
      // From the first level, -1.25, and never above the stock's top; short links may rise less.
      const double whole = std::min(params.top, -1.25 + lift);
      EXPECT_LE(highest, whole + 1e-9);
      EXPECT_GT(highest, -1.25);
      if (is_long) {
        EXPECT_NEAR(highest, whole, 1e-9);
      }
    }
}

TEST(Assemble, TakesTheTimeOfEveryMove) {
  std::vector<Move> moves(4);
  moves[0].kind = moves[3].kind = MoveKind::kRapid;
  moves[1].x = 10;
  moves[1].feed = 100;
  moves[2].sweep = kPi;
  moves[2].cx = 10;
  moves[2].cy = 2;
  moves[2].x = 10;
  moves[2].y = 4;
  moves[2].feed = 200;
  moves[3] = moves[2];
  moves[3].kind = MoveKind::kRapid;
  moves[3].sweep = 0;
  moves[3].z = 50;
  EXPECT_NEAR(duration(moves, 5000), 60 * (10.0 / 100 + 2 * kPi / 200 + 50.0 / 5000), 1e-9);
}

}  // namespace
}  // namespace evenload
