// Rest machining: what earlier cuts left is cleared, from above cleared ground, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/shapes.h"
#include "simulate/simulate.h"
#include "simulate/standing.h"
#include "strategy/pocket/rest_levels.h"
#include "strategy/reach/free_place.h"
#include "support/errors.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr double kResolution = 0.02;  // mm
// Above the limit: where a cusp between two sweeps of the larger tool comes under the edge, a
// sample of the simulator stands for the whole step before it.
constexpr double kOver = 2.5 * kDegree;

Region square(double x0, double y0, double x1, double y1) {
  return make_region(rectangle(x0, y0, x1, y1));
}

ClearingParams params_for(double diameter, std::vector<double> levels = {-3.0}) {
  ClearingParams params;
  params.tool_diameter = diameter;
  params.roll_radius = params.minimum_radius = 0.15 * diameter;
  params.helix_diameter = 0.9 * diameter;
  params.levels = std::move(levels);
  return params;
}

Simulation run(const Toolpath& path, DexelStock& stock, double diameter,
               const std::vector<Prism>& part = {}) {
  SimulationParams params;
  params.tool_diameter = diameter;
  params.part = part;
  Progress progress;
  return simulate(path.moves, stock, params, progress);
}

// A square pocket of 40 mm in a block, with or without a boss, and what stands round it.
struct Pocket {
  explicit Pocket(bool boss, double depth = 3) {
    const Curve outline = rectangle(0, 0, 40, 40);
    std::vector<Curve> islands;
    if (boss) islands.push_back(rectangle(14, 15, 22, 27));
    region = make_region(outline, islands);
    block = square(-10, -10, 50, 50);
    part = {{make_region(block.outer, {outline}), 0}};
    if (boss) part.push_back({make_region(islands.front()), 0});
    bottom = -depth;
  }
  DexelStock stock() const { return DexelStock({{block, 0}}, bottom, kResolution); }

  Region region, block;
  std::vector<Prism> part;
  double bottom = -3;
};

Toolpath clear(const Pocket& pocket, const ClearingParams& params) {
  Progress progress;
  return clear_pocket({pocket.region}, params, progress);
}

Toolpath clear_what_stands(const Pocket& pocket, const DexelStock& stock,
                           const ClearingParams& params) {
  const std::vector<Region> reach =
      reachable_ground({pocket.region}, params.tool_diameter, params.stock_to_leave);
  std::vector<std::vector<Region>> stocks;
  for (const double z : params.levels) stocks.push_back(standing_regions(stock, z, reach));
  Progress progress;
  return clear_rest({pocket.region}, stocks, params, progress);
}

int count(const Toolpath& path, MoveKind kind) {
  return static_cast<int>(std::count_if(path.moves.begin(), path.moves.end(),
                                        [kind](const Move& m) { return m.kind == kind; }));
}

TEST(RestMachining, ClearsWithinTheLimitJustWhatALargerToolLeft) {
  for (const bool boss : {false, true})
    for (const CutMode mode : {CutMode::kClimb, CutMode::kConventional})
      for (const double first : {9.0, 12.0, 16.0}) {
        const Pocket pocket(boss);
        DexelStock stock = pocket.stock();
        run(clear(pocket, params_for(first)), stock, first);
        const double before = stock.volume();
        ClearingParams params = params_for(6);
        params.cut_mode = mode;
        const Toolpath path = clear_what_stands(pocket, stock, params);
        const LoadFigures found = run(path, stock, 6, pocket.part).figures;
        const std::string name = std::to_string(boss) + " " + std::to_string(first);
        EXPECT_EQ(path.report.termination, Termination::kComplete) << name;
        EXPECT_LE(found.engagement.value, params.engagement_angle + kOver) << name;
        EXPECT_LE(found.link_engagement.value, 1.5 * kDegree) << name;
        EXPECT_LE(found.gouge.value, 0.002) << name;
        EXPECT_TRUE(found.incidents.empty()) << name;
        EXPECT_LE(found.rest.area, 0.01) << name;
        EXPECT_GE(1 - found.air_length / found.cut_length, 0.75) << name;
        EXPECT_NEAR(path.report.removed_volume, before - stock.volume(),
                    0.01 * (before - stock.volume()) + 0.1)
            << name;
        EXPECT_EQ(count(path, MoveKind::kEntry), 0) << name;  // down beside it, not into it
      }
}

TEST(RestMachining, HasNothingToDoAfterTheSameTool) {
  const Pocket pocket(true);
  DexelStock stock = pocket.stock();
  run(clear(pocket, params_for(6)), stock, 6);
  const Toolpath path = clear_what_stands(pocket, stock, params_for(6));
  EXPECT_TRUE(path.moves.empty());
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_EQ(path.report.uncut_area, 0);
  ASSERT_EQ(path.report.findings.size(), 1U);
  EXPECT_EQ(path.report.findings.front().code, FindingCode::kNothingLeft);
}

TEST(RestMachining, OfAFullPocketIsClearingItByAHelix) {
  const Pocket pocket(false);
  DexelStock stock = pocket.stock();
  const Toolpath path = clear_what_stands(pocket, stock, params_for(6));
  const Toolpath whole = clear(pocket, params_for(6));
  EXPECT_GT(count(path, MoveKind::kEntry), 0);
  EXPECT_NEAR(path.report.removed_volume, whole.report.removed_volume, 2);
  EXPECT_NEAR(path.report.cutting_time, whole.report.cutting_time,
              0.05 * whole.report.cutting_time);
  EXPECT_LE(run(path, stock, 6, pocket.part).figures.rest.area, 0.01);
}

// What a bore as wide as a groove left: a post in its middle, beside which a helix comes down in
// air.
TEST(RestMachining, CountsWhatItRemovesAndNoAir) {
  const Pocket pocket(false, 10);
  DexelStock stock = pocket.stock();
  Toolpath bore;
  for (const double x : {24.0, 16.0, 24.0}) {
    Move move;
    move.kind = bore.moves.empty() ? MoveKind::kEntry : MoveKind::kCut;
    move.x = x;
    move.y = 20;
    move.z = -10;
    move.feed = 600;
    if (!bore.moves.empty()) {
      move.sweep = kPi;
      move.cx = move.cy = 20;
    }
    bore.moves.push_back(move);
  }
  run(bore, stock, 6);
  const double before = stock.volume();
  const Toolpath path = clear_what_stands(pocket, stock, params_for(6, {-10}));
  run(path, stock, 6);
  EXPECT_NEAR(path.report.removed_volume, before - stock.volume(),
              0.005 * (before - stock.volume()));
}

// Here nothing leads in from beside, and the tool's centre has some hundredths of a millimetre.
TEST(RestMachining, ComesDownByARampInARoomHardlyWiderThanTheTool) {
  for (const double width : {6.03, 6.08, 6.11}) {
    SCOPED_TRACE(width);
    const Region room = square(0, 0, 6.4, width);
    DexelStock stock({{square(-10, -10, 20, 20), 0}}, -3, kResolution);
    const std::vector<std::vector<Region>> stands{reachable_ground({room}, 6, 0)};
    Progress progress;
    const Toolpath path = clear_rest({room}, stands, params_for(6), progress);
    EXPECT_EQ(path.report.termination, Termination::kComplete);
    EXPECT_GT(count(path, MoveKind::kEntry), 0);
    const Prism part{make_region(square(-10, -10, 20, 20).outer, {room.outer}), 0};
    const LoadFigures found = run(path, stock, 6, {part}).figures;
    EXPECT_LE(found.rest.area, 0.01);
    EXPECT_LE(found.gouge.value, 0.002);
    EXPECT_TRUE(found.incidents.empty());
  }
}

TEST(RestMachining, TakesAPostThatTouchesNoWall) {
  const Pocket pocket(false);
  // All is clear but a post that is narrower than the tool, and a wider one.
  for (const double half : {1.0, 5.0}) {
    const Region post = square(20 - half, 18 - half, 20 + half, 18 + half);
    DexelStock stock({{post, 0}}, -3, kResolution);
    const Toolpath path = clear_what_stands(pocket, stock, params_for(6));
    const LoadFigures found = run(path, stock, 6).figures;
    EXPECT_EQ(path.report.uncut_area, 0) << half;
    EXPECT_LE(found.rest.area, 0.01) << half;
    EXPECT_LE(found.engagement.value, 62 * kDegree) << half;
    EXPECT_TRUE(found.incidents.empty()) << half;
    EXPECT_EQ(count(path, MoveKind::kEntry), 0) << half;
  }
}

// At a small angle a pass takes a layer that lies between the points by which what is left is
// known: asked for again only where points were cleared, this post stayed.
TEST(RestMachining, TakesAPostLayerByLayer) {
  ClearingParams params;
  params.engagement_angle = 3 * kDegree;
  params.maximum_feed = 1000;
  const Curve post = shapes::moved(rectangle(-0.81959117, -0.909151097, 0.81959117, 0.909151097),
                                   0.446909314, false, 1, {7.138743535, 40.37345214});
  params.stock = {make_region(post)};
  Progress progress;
  const Toolpath path = clear_pocket({square(0, 0, 62, 55)}, params, progress);
  EXPECT_EQ(path.report.uncut_area, 0);
  EXPECT_GT(path.report.passes, 100);
}

TEST(RestMachining, GivesNoEntryToRegionsThatHoldNothing) {
  const std::vector<Region> pockets{square(0, 0, 20, 20), square(30, 0, 50, 20)};
  ClearingParams params = params_for(6);
  Progress progress;
  const Toolpath path = clear_rest(pockets, {{square(30, 0, 50, 20)}}, params, progress);
  ASSERT_FALSE(path.moves.empty());
  for (const Move& move : path.moves) EXPECT_GT(move.x, 30);
}

TEST(RestMachining, KnowsTheStockOfEachLevel) {
  // The upper of three levels lost all but its corners to a larger tool.
  const Pocket pocket(false, 9);
  DexelStock stock = pocket.stock();
  run(clear(pocket, params_for(12)), stock, 12);
  const Toolpath path = clear_what_stands(pocket, stock, params_for(6, {-3, -6, -9}));
  const double corner = 1 - kPi / 4;
  const double volume = 3 * 4 * corner * 27 + 6 * (1600 - 4 * corner * 9);
  EXPECT_NEAR(path.report.removed_volume, volume, 2e-3 * volume);
  const LoadFigures found = run(path, stock, 6, pocket.part).figures;
  EXPECT_LE(found.rest.area, 0.01);
  EXPECT_LE(found.engagement.value, 62 * kDegree);
  EXPECT_TRUE(found.incidents.empty());
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kEntry) {
      EXPECT_LE(move.z, -3 + 0.5);
    }
}

TEST(RestMachining, LeavesOutALevelAtWhichNothingStands) {
  const Pocket pocket(false, 6);
  DexelStock stock = pocket.stock();
  run(clear(pocket, params_for(6)), stock, 6);
  const Toolpath path = clear_what_stands(pocket, stock, params_for(6, {-3, -6}));
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kCut) {
      EXPECT_EQ(move.z, -6);
    }
  EXPECT_GT(count(path, MoveKind::kCut), 10);
}

TEST(RestMachining, TakesOneStockForAllLevelsOrOneForEach) {
  const Pocket pocket(false);
  const std::vector<Region> corner{square(30, 30, 40, 40)};
  const ClearingParams params = params_for(6, {-1, -2, -3});
  Progress progress;
  const Toolpath once = clear_rest({pocket.region}, {corner}, params, progress);
  const Toolpath each = clear_rest({pocket.region}, {corner, corner, corner}, params, progress);
  EXPECT_GT(once.moves.size(), 10u);
  EXPECT_EQ(once.moves.size(), each.moves.size());
  EXPECT_THROW(clear_rest({pocket.region}, {corner, corner}, params, progress),
               std::invalid_argument);
}

TEST(RestMachining, RefusesAToolThatDoesNotFitEvenWhereNothingIsLeft) {
  Progress progress;
  EXPECT_THROW(clear_rest({square(0, 0, 5, 5)}, {{}}, params_for(6), progress), GeometryError);
}

TEST(RestMachining, StopsWhenItIsCancelled) {
  const Pocket pocket(false);
  Progress stop([](double) { return false; });
  const Toolpath path =
      clear_rest({pocket.region}, {{pocket.region}}, params_for(6, {-1, -2}), stop);
  EXPECT_EQ(path.report.termination, Termination::kCancelled);
}

TEST(FreeDisc, HoldsNoPostThatTheCircleGoesRound) {
  std::vector<Region> stock{square(9.5, 9.5, 10.5, 10.5)};
  for (Region& region : stock) {
    std::vector<Vertex> vertices = region.outer.vertices();
    for (Vertex& v : vertices) v.open = true;
    region.outer = Curve(vertices, true);
  }
  ClearedGround ground({{0, 0}, {20, 20}}, 3, &stock);
  EXPECT_TRUE(ground.is_clear({10.2, 10}));
  EXPECT_FALSE(is_free_disc(ground, stock, {10.2, 10}));
  EXPECT_FALSE(is_free_disc(ground, stock, {12, 10}));
  EXPECT_TRUE(is_free_disc(ground, stock, {14, 10}));
  EXPECT_TRUE(has_free_place(ground, stock, square(0, 0, 20, 20)));
  EXPECT_FALSE(has_free_place(ground, stock, square(9, 9, 11, 11)));
  ground.add_disc({10, 10}, 1);
  EXPECT_TRUE(is_free_disc(ground, stock, {10.2, 10}));
}

}  // namespace
}  // namespace evenload
