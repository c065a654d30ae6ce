// What passes leave on planes, slopes and cylinders, against closed forms; what is cut too deep.
#include "simulate/surface_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include "judge/numbers.h"
#include "simulate/paths.h"
#include "simulate/swept_cutter.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

constexpr double kBall = 5, kStep = 0.4, kStock = 0.3;

// A square of 24 mm about the origin, which rises along x.
HeightMap plane_of(double slope) {
  const auto at = [slope](double x, double y) { return Point3{x, y, slope * x}; };
  return {{at(-12, -12), at(12, -12), at(12, 12), at(-12, 12)}, {{0, 1, 2}, {0, 2, 3}}};
}

// Over [-6, 6] along x, the upper side of a cylinder about the x axis up to 0.3 rad to both sides;
// `nature` 1: a dome, -1: a trough.
HeightMap cylinder_of(double radius, double nature) {
  constexpr int kStrips = 2000;
  std::vector<Point3> points;
  std::vector<HeightMap::Triangle> triangles;
  for (std::uint32_t k = 0; k <= kStrips; ++k) {
    const double angle = 0.6 * k / kStrips - 0.3;
    for (const double x : {-6., 6.})
      points.push_back({x, radius * std::sin(angle), nature * radius * std::cos(angle)});
    if (k == 0) continue;
    triangles.push_back({2 * k - 2, 2 * k - 1, 2 * k + 1});
    triangles.push_back({2 * k - 2, 2 * k + 1, 2 * k});
  }
  return {points, triangles};
}

SurfaceMapParams params_of(double spacing, double half = 2) {
  SurfaceMapParams params;
  params.cutter = {kBall, kBall};
  params.spacing = spacing;
  params.columns = params.rows = static_cast<int>(2 * half / spacing);
  params.first = {-half + 0.31 * spacing, -half + 0.17 * spacing};
  params.stock = kStock;
  params.threads = 2;
  return params;
}

SurfaceMap map_of(const HeightMap& part, const std::vector<Move>& moves,
                  const SurfaceMapParams& params) {
  Progress progress;
  return map_surface(part, std::vector<bool>(part.triangle_count(), true), moves, params, progress);
}

// There and back along `way`, kStep apart across it in plan, tips at the height of their place.
template <typename Height>
std::vector<Move> passes(Vec2 way, double step, const Height& height) {
  std::vector<Move> moves;
  const Vec2 side{-way.y, way.x};
  for (int k = -12; k <= 12; ++k)
    for (const double end : {-9., 9.}) {
      const Vec2 p = (k % 2 == 0 ? end : -end) * way + k * step * side;
      const MoveKind kind = moves.empty() ? MoveKind::kRapid : MoveKind::kCut;
      moves.push_back(move_to(kind, p.x, p.y, height(p)));
      moves.back().feed = 1600;
    }
  return moves;
}

double cusp_of(double step) { return kBall - std::sqrt(kBall * kBall - step * step / 4); }

// All cusps there are, which must be some.
void expect_cusps(const SurfaceMap& map, double expected, double bound) {
  int found = 0;
  for (const double cusp : map.cusp)
    if (std::isfinite(cusp)) {
      ++found;
      EXPECT_NEAR(cusp, expected, bound);
    }
  EXPECT_GT(found, 40);
}

TEST(SurfaceMap, CuspsOfParallelPassesOnAPlaneAreExactOnCoarseCells) {
  for (const double angle : {0.0, 0.4, 1.1, 2.2})
    for (const double spacing : {0.02, 0.05, 0.13}) {
      const auto moves = passes(unit(angle), kStep, [](Vec2) { return 0.0; });
      const SurfaceMap map = map_of(plane_of(0), moves, params_of(spacing));
      expect_cusps(map, cusp_of(kStep), 1e-9);
      for (const double above : map.above) {
        EXPECT_GE(above, -1e-12);
        EXPECT_LE(above, cusp_of(kStep) + 1e-12);
      }
    }
}

TEST(SurfaceMap, OnASlopeCuspsAreAcrossIt) {
  for (const double slope : {0.3, 1.0}) {
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    const auto tip = [&](Vec2 p) { return slope * p.x + kBall / cosine - kBall; };
    for (const double angle : {0.0, 0.5 * kPi, 0.7}) {
      const Vec2 way = unit(angle), side{-way.y, way.x};
      const SurfaceMap map = map_of(plane_of(slope), passes(way, kStep, tip), params_of(0.1));
      // Across a feed that climbs by g the slope's other part g' tells how far passes are apart.
      const double g = slope * way.x, across = slope * side.x;
      const double apart = kStep * std::sqrt(1 + across * across / (1 + g * g));
      expect_cusps(map, cusp_of(apart), 1e-9);
    }
  }
}

TEST(SurfaceMap, CuspsOnCylindersFollowTheirCurvature) {
  constexpr double kRadius = 45, kTurn = 0.008;
  for (const double nature : {1.0, -1.0}) {
    const double centres = kRadius + nature * kBall;
    std::vector<Move> moves;
    for (int k = -10; k <= 10; ++k)
      for (const double end : {-9., 9.}) {
        const double angle = k * kTurn;
        const MoveKind kind = moves.empty() ? MoveKind::kRapid : MoveKind::kCut;
        moves.push_back(move_to(kind, k % 2 == 0 ? end : -end, centres * std::sin(angle),
                                nature * centres * std::cos(angle) - kBall));
        moves.back().feed = 1600;
      }
    const double half = centres * std::sin(0.5 * kTurn);
    const double ridge =
        centres * std::cos(0.5 * kTurn) - nature * std::sqrt(kBall * kBall - half * half);
    const SurfaceMap map = map_of(cylinder_of(kRadius, nature), moves, params_of(0.1));
    expect_cusps(map, nature * (ridge - kRadius), 2e-6);  // the strips' own sagitta
  }
}

TEST(SurfaceMap, ABullNoseLeavesTheCuspsOfItsCornerAndItsFlatNone) {
  SurfaceMapParams params = params_of(0.05);
  params.cutter = {5, 1};
  const auto flat = passes({1, 0}, kStep, [](Vec2) { return 0.0; });
  for (const double above : map_of(plane_of(0), flat, params).above) EXPECT_NEAR(above, 0, 1e-12);
  // On a slope, passes along the contour touch by the corner alone.
  const double slope = 0.5, cosine = 1 / std::sqrt(1 + slope * slope);
  const auto tip = [&](Vec2 p) { return slope * p.x + 4 * slope + 1 / cosine - 1; };
  const SurfaceMap map = map_of(plane_of(slope), passes({0, 1}, kStep, tip), params);
  const double apart = kStep / cosine;
  expect_cusps(map, 1 - std::sqrt(1 - apart * apart / 4), 1e-6);
}

TEST(SurfaceMap, WhatNoPassReachesKeepsItsStock) {
  const std::vector<Move> moves{move_to(MoveKind::kRapid, -20, 0, 0),
                                move_to(MoveKind::kCut, 20, 0, 0)};
  const SurfaceMapParams params = params_of(0.1, 3);
  const SurfaceMap map = map_of(plane_of(0), moves, params);
  const double reach = std::sqrt(kStock * (2 * kBall - kStock));
  for (int j = 0; j < params.rows; ++j)
    for (int i = 0; i < params.columns; ++i) {
      const auto k = static_cast<std::size_t>(j * params.columns + i);
      const double y = params.first.y + j * params.spacing;
      if (std::abs(y) > reach) {
        EXPECT_EQ(map.above[k], kStock);
        EXPECT_EQ(map.move[k], -1);
      } else {
        EXPECT_NEAR(map.above[k], params.cutter.rise(std::abs(y)), 1e-12);
        EXPECT_EQ(map.move[k], 1);
      }
    }
}

TEST(SurfaceMap, APassThatIsTooLowGougesByThat) {
  const double slope = 0.5, cosine = 1 / std::sqrt(1 + slope * slope), deep = 0.05;
  const auto tip = [&](Vec2 p) { return slope * p.x + (kBall - deep) / cosine - kBall; };
  const SurfaceMap map = map_of(plane_of(slope), passes({0, 1}, kStep, tip), params_of(0.02));
  const double deepest = *std::min_element(map.above.begin(), map.above.end());
  EXPECT_NEAR(deepest, -deep, 2e-5);  // half a cell beside the deepest place: of its square / 2 r
  EXPECT_GE(deepest, -deep - 1e-12);
}

TEST(SurfaceMap, BesideAWallAGougeIsTheWaySideways) {
  // A floor, and a block of 10 mm from x = 1 on; a flat tool runs 0.03 mm into the wall.
  const HeightMap part({{-12, -12, 0},
                        {1, -12, 0},
                        {1, 12, 0},
                        {-12, 12, 0},
                        {1, -12, 10},
                        {12, -12, 10},
                        {12, 12, 10},
                        {1, 12, 10}},
                       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  SurfaceMapParams params = params_of(0.01, 1.5);
  params.cutter = {kBall, 0};
  const std::vector<Move> moves{move_to(MoveKind::kRapid, 1.03 - kBall, -9, 0),
                                move_to(MoveKind::kCut, 1.03 - kBall, 9, 0)};
  const SurfaceMap map = map_of(part, moves, params);
  const double deepest = *std::min_element(map.above.begin(), map.above.end());
  EXPECT_LE(deepest, -0.02);
  EXPECT_GE(deepest, -0.031);
}

TEST(SurfaceMap, RandomPathsLeaveWhatASearchFinds) {
  std::mt19937 random(21);
  for (int round = 0; round < 12; ++round) {
    const auto any = [&random](double most) { return uniform(random, -most, most); };
    std::vector<Move> moves{move_to(MoveKind::kRapid, any(4), any(4), 0.5)};
    for (int k = 0; k < 60; ++k)
      moves.push_back(k % 7 == 3 ? move_to(MoveKind::kRapid, any(4), any(4), 0.1 + 0.1 * (k % 5))
                                 : move_to(MoveKind::kCut, any(4), any(4), 0.1 * (k % 5)));
    SurfaceMapParams params = params_of(0.11, 4);
    params.cutter = {kBall, round % 2 == 0 ? kBall : 1.5};
    const HeightMap part = plane_of(0.03 * (round % 3));
    const SurfaceMap map = map_of(part, moves, params);
    const std::vector<CutterRun> runs = cutter_runs(moves, 0);
    for (int j = 0; j < params.rows; j += 3)
      for (int i = 0; i < params.columns; i += 3) {
        const Vec2 at = params.first + params.spacing * Vec2{1. * i, 1. * j};
        const Top top = *part.highest_at(at);
        double lowest = top.z + kStock / top.normal.z;
        for (const CutterRun& run : runs)
          lowest = std::min(lowest, underside(params.cutter, run, at).z);
        const double above = (lowest - top.z) * top.normal.z;
        const auto k = static_cast<std::size_t>(j * params.columns + i);
        if (above > -1e-3) {
          EXPECT_NEAR(map.above[k], above, 1e-7);
        }
      }
  }
}

TEST(SurfaceMap, TeethLeaveMarksAlongTheFeed) {
  SurfaceMapParams params = params_of(0.01, 0.5);
  params.teeth_per_minute = 1600 / 0.2;  // 0.2 mm apart
  const auto moves = passes({1, 0}, kStep, [](Vec2) { return 0.0; });
  const SurfaceMap map = map_of(plane_of(0), moves, params);
  const double highest = *std::max_element(map.above.begin(), map.above.end());
  // Highest in the middle of four teeth, of two passes, at most; they are out of step.
  EXPECT_LE(highest, kBall - std::sqrt(kBall * kBall - 0.2 * 0.2 - 0.1 * 0.1) + 1e-9);
  EXPECT_GE(highest, cusp_of(kStep) - 1e-5);
  double along = 0;  // in the row next to a pass
  const int row = static_cast<int>(std::lround((0 - params.first.y) / params.spacing));
  for (int i = 0; i < params.columns; ++i)
    along = std::max(along, map.above[static_cast<std::size_t>(row * params.columns + i)]);
  EXPECT_NEAR(along, cusp_of(0.2), 1e-4);  // half a cell beside the mark's ridge
}

TEST(SurfaceMap, IsTheSameOnAnyNumberOfThreads) {
  const auto moves = passes(unit(0.7), kStep, [](Vec2 p) { return 0.01 * p.x; });
  SurfaceMapParams params = params_of(0.03, 3);
  params.threads = 1;
  const SurfaceMap one = map_of(plane_of(0.01), moves, params);
  for (const int threads : {2, 5}) {
    params.threads = threads;
    const SurfaceMap more = map_of(plane_of(0.01), moves, params);
    EXPECT_EQ(one.above, more.above);
    EXPECT_EQ(one.move, more.move);
    EXPECT_EQ(std::memcmp(one.cusp.data(), more.cusp.data(), 8 * one.cusp.size()), 0);
  }
}

TEST(SurfaceMap, TellsWhatIsDoneAndNeverTurnsBack) {
  const auto moves = passes({1, 0}, kStep, [](Vec2) { return 0.0; });
  std::vector<double> told;
  Progress progress([&](double share) {
    told.push_back(share);
    return true;
  });
  map_surface(plane_of(0), {true, true}, moves, params_of(0.02), progress);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.back(), 0.7);
  EXPECT_LE(told.back(), 1);
}

TEST(SurfaceMap, OnlyWhatIsPickedHasCuspsAndOnlyAPartHasHeights) {
  const auto moves = passes({1, 0}, kStep, [](Vec2) { return 0.0; });
  SurfaceMapParams params = params_of(0.1, 2);
  params.first = {-13, -1};
  Progress progress;
  const SurfaceMap map = map_surface(plane_of(0), {false, true}, moves, params, progress);
  for (int j = 0; j < params.rows; ++j)
    for (int i = 0; i < params.columns; ++i) {
      const auto k = static_cast<std::size_t>(j * params.columns + i);
      const bool has_part = params.first.x + i * params.spacing >= -12;
      EXPECT_EQ(map.part[k] != kNoMaterial, has_part);
      EXPECT_EQ(map.is_picked[k], has_part);  // all there is there belongs to the second triangle
    }
  const SurfaceMap none = map_surface(plane_of(0), {false, false}, moves, params, progress);
  for (const double cusp : none.cusp) EXPECT_TRUE(std::isnan(cusp));
}

TEST(SurfaceMap, RefusesWhatCannotBeAndStopsWhenAsked) {
  const auto moves = passes({1, 0}, kStep, [](Vec2) { return 0.0; });
  const HeightMap part = plane_of(0);
  const auto refused = [&](auto change) {
    SurfaceMapParams params = params_of(0.1);
    change(params);
    EXPECT_THROW(map_of(part, moves, params), std::invalid_argument);
  };
  refused([](SurfaceMapParams& p) { p.cutter = {0, 0}; });
  refused([](SurfaceMapParams& p) { p.cutter = {5, 6}; });
  refused([](SurfaceMapParams& p) { p.spacing = 0; });
  refused([](SurfaceMapParams& p) { p.columns = 0; });
  refused([](SurfaceMapParams& p) { p.columns = p.rows = 10000; });
  refused([](SurfaceMapParams& p) { p.stock = 0; });
  EXPECT_THROW(map_of(part, {moves[0]}, params_of(0.1)), std::invalid_argument);
  Progress progress;
  EXPECT_THROW(map_surface(part, {true}, moves, params_of(0.1), progress), std::invalid_argument);
  const HeightMap upright({{0, 0, 0}, {1, 0, 0}, {1, 0, 5}}, {{0, 1, 2}});
  EXPECT_THROW(map_of(upright, moves, params_of(0.1)), std::invalid_argument);
  Progress stopped([](double) { return false; });
  EXPECT_THROW(map_surface(part, {true, true}, moves, params_of(0.1), stopped), Cancelled);
}

}  // namespace
}  // namespace evenload
