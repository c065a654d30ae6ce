// Room for the tool outside open edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry_shapes.h"
#include "strategy/allowed_ground.h"
#include "strategy/constant_engagement.h"

namespace evenload {
namespace {

constexpr double kTool = 6;
// mm: beyond open edges, of the tool's side.
constexpr double kRoom = 2.5 * kTool;

Region region_of(const std::vector<Vertex>& vertices) { return make_region(Curve(vertices, true)); }

// Open above, from (90, 30) to (0, 30), with a wall beneath that meets it at `tip` rad on the left.
Region open_above(double tip) {
  const double depth = 20;
  return region_of({{{depth / std::tan(tip), 30 - depth}, 0, false},
                    {{90, 30 - depth}, 0, false},
                    {{90, 30}, 0, true},
                    {{0, 30}, 0, false}});
}

std::vector<Region> allowed(const Region& region, std::vector<std::string>& notes) {
  return allowed_ground(
      {region}, kTool, [](Vec2 p) { return p; }, notes);
}

bool contains(const std::vector<Region>& ground, Vec2 p) {
  return ground.size() == 1 && ground.front().outer.contains(p);
}

TEST(AllowedGround, IsARoomBeyondOpenEdgesAndNowhereElse) {
  std::vector<std::string> notes;
  const std::vector<Region> ground = allowed(open_above(kPi / 2), notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_TRUE(contains(ground, {20, 30 + 0.99 * kRoom}));
  EXPECT_FALSE(contains(ground, {20, 30 + 1.01 * kRoom}));
  EXPECT_FALSE(contains(ground, {-0.1, 31}));
  EXPECT_FALSE(contains(ground, {90.1, 31}));
  EXPECT_FALSE(contains(ground, {20, 9.9}));
}

TEST(AllowedGround, GoesOnAsTheWallBesideATip) {
  for (const double degrees : {15.0, 30.0, 60.0, 80.0}) {
    SCOPED_TRACE(degrees);
    const double tip = degrees * kPi / 180;
    const Vec2 past = {-std::cos(tip), std::sin(tip)};  // along the wall beneath, beyond the tip
    std::vector<std::string> notes;
    const std::vector<Region> ground = allowed(open_above(tip), notes);
    const Vec2 end = Vec2{0, 30} + 0.9 * kRoom * past, aside = {past.y, -past.x};
    EXPECT_TRUE(contains(ground, end + 0.05 * aside));
    EXPECT_FALSE(contains(ground, end - 0.05 * aside));
    EXPECT_FALSE(contains(ground, Vec2{0, 30} + 1.1 * kRoom * past + 0.05 * aside));
  }
}

TEST(AllowedGround, EndsSquareToAnOpenEdgeWhereAnObtuseWallBegins) {
  std::vector<std::string> notes;
  const std::vector<Region> ground = allowed(open_above(2.0), notes);
  EXPECT_TRUE(contains(ground, {0.1, 40}));
  EXPECT_FALSE(contains(ground, {-0.1, 40}));
}

// Two tips that point at each other across a gap: beyond each the other's walls are in the way.
TEST(AllowedGround, IsCutOffWhereOtherWallsAreInTheWayOfATip) {
  const Region region = region_of({{{0, 0}, 0, false},
                                   {{60, 0}, 0, false},
                                   {{60, 30}, 0, true},
                                   {{36, 30}, 0, false},
                                   {{48, 10}, 0, false},
                                   {{12, 10}, 0, false},
                                   {{24, 30}, 0, true},
                                   {{0, 30}, 0, false}});
  std::vector<std::string> notes;
  const std::vector<Region> ground = allowed(region, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_TRUE(contains(ground, {12, 40}));
  EXPECT_TRUE(contains(ground, {48, 40}));
  EXPECT_FALSE(contains(ground, {30, 40}));
}

// mm from `p` to the nearest place of the tool's centre in cuts.
double nearest_cut(const Toolpath& path, Vec2 p) {
  double least = 1e9;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind != MoveKind::kCut) continue;
    const Vec2 from{path.moves[i - 1].x, path.moves[i - 1].y}, to{move.x, move.y};
    for (int k = 0; k <= 50; ++k) {
      const double t = k / 50.0;
      Vec2 at = from + t * (to - from);
      if (move.sweep != 0) {
        const Vec2 centre{move.cx, move.cy};
        at = centre + distance(from, centre) * unit(angle_of(from - centre) + t * move.sweep);
      }
      least = std::min(least, distance(at, p));
    }
  }
  return least;
}

TEST(AllowedGround, LetsTheToolClearTipsBesideOpenEdges) {
  for (const double degrees : {25.0, 45.0, 70.0}) {
    for (const CutMode mode : {CutMode::kClimb, CutMode::kConventional}) {
      SCOPED_TRACE(degrees);
      const double tip = degrees * kPi / 180;
      ClearingParams params;
      params.tool_diameter = kTool;
      params.cut_mode = mode;
      params.roll_radius = 1;
      params.levels = {-3};
      Progress progress;
      const Toolpath path = clear_pocket({open_above(tip)}, params, progress);
      EXPECT_EQ(path.report.termination, Termination::kComplete);
      for (const double inside : {0.02, 0.5, 2.0})
        EXPECT_LE(nearest_cut(path, Vec2{0, 30} + inside * unit(-0.5 * tip)), 0.5 * kTool);
    }
  }
}

}  // namespace
}  // namespace evenload
