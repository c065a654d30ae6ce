// Room for the tool outside open edges.
#include "strategy/places/allowed_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "judge/path_check.h"
#include "strategy/pocket/constant_engagement.h"

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

std::vector<Region> allowed(const Region& region, std::vector<Finding>& found) {
  return allowed_ground(
      {region}, kTool, [](Vec2 p) { return p; }, found);
}

bool contains(const std::vector<Region>& ground, Vec2 p) {
  return ground.size() == 1 && ground.front().outer.contains(p);
}

TEST(AllowedGround, IsARoomBeyondOpenEdgesAndNowhereElse) {
  std::vector<Finding> found;
  const std::vector<Region> ground = allowed(open_above(kPi / 2), found);
  EXPECT_TRUE(found.empty());
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
    std::vector<Finding> found;
    const std::vector<Region> ground = allowed(open_above(tip), found);
    const Vec2 end = Vec2{0, 30} + 0.9 * kRoom * past, aside = {past.y, -past.x};
    EXPECT_TRUE(contains(ground, end + 0.05 * aside));
    EXPECT_FALSE(contains(ground, end - 0.05 * aside));
    EXPECT_FALSE(contains(ground, Vec2{0, 30} + 1.1 * kRoom * past + 0.05 * aside));
  }
}

TEST(AllowedGround, EndsSquareToAnOpenEdgeWhereAnObtuseWallBegins) {
  std::vector<Finding> found;
  const std::vector<Region> ground = allowed(open_above(2.0), found);
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
  std::vector<Finding> found;
  const std::vector<Region> ground = allowed(region, found);
  EXPECT_TRUE(found.empty());
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

// 25 x 20 mm with its lower left corner at (x, y); `open`: all of its edges, or the upper one.
enum class Open { kAll, kAbove };
Region plateau(double x, double y, Open open) {
  const bool all = open == Open::kAll;
  return region_of({{{x, y}, 0, all},
                    {{x + 25, y}, 0, all},
                    {{x + 25, y + 20}, 0, true},
                    {{x, y + 20}, 0, all}});
}

// The same, upside down.
Region open_beneath(double x, double y) {
  return region_of({{{x, y}, 0, true},
                    {{x + 25, y}, 0, false},
                    {{x + 25, y + 20}, 0, false},
                    {{x, y + 20}, 0, false}});
}

std::vector<Region> allowed(const std::vector<Region>& regions, std::vector<Finding>& found) {
  return allowed_ground(
      regions, kTool, [](Vec2 p) { return p; }, found);
}

TEST(AllowedGround, OfRegionsThatAreOpenAllRoundIsOneWhereTheirRoomsMeet) {
  for (const double gap : {0.5, 4.0, 20.0, 29.9, 30.1}) {
    SCOPED_TRACE(gap);
    Region with_boss = plateau(0, 0, Open::kAll);
    with_boss = make_region(with_boss.outer, {shapes::rectangle(5, 5, 9, 9)});
    std::vector<Finding> found;
    const std::vector<Region> ground =
        allowed({with_boss, plateau(25 + gap, 0, Open::kAll)}, found);
    EXPECT_TRUE(found.empty());
    ASSERT_EQ(ground.size(), gap < 2 * kRoom ? 1u : 2u);
    std::size_t islands = 0;
    for (const Region& region : ground) islands += region.islands.size();
    EXPECT_EQ(islands, 1u);
  }
}

// Rooms that overlap would be neither.
TEST(AllowedGround, EndsBeforeOtherRegionsAndTheirRooms) {
  const auto room_above = [](const std::vector<Region>& ground, double from, double to) {
    double most = from;
    for (double y = from; y < to; y += 0.01)
      if (ground.front().contains({10, y})) most = y;
    return most - from;
  };
  for (const double gap : {8.0, 10.0, 14.0, 20.0, 31.0}) {
    SCOPED_TRACE(gap);
    std::vector<Finding> found;
    const Region below = plateau(0, 0, Open::kAbove);
    const std::vector<Region> walled = allowed(
        {below, region_of({{{0, 20 + gap}, 0}, {{25, 20 + gap}, 0}, {{10, 60}, 0}})}, found);
    EXPECT_TRUE(found.empty());
    EXPECT_GT(room_above(walled, 20, 60), 0.89 * std::min(gap, kRoom));
    EXPECT_LT(room_above(walled, 20, 60), gap);

    const std::vector<Region> facing = allowed({below, open_beneath(0, 20 + gap)}, found);
    const bool is_wide = gap > 2.1 * kTool;
    EXPECT_EQ(found.size(), is_wide ? 0u : 2u);
    const double room = is_wide ? std::min(0.5 * gap, kRoom) : 0;
    EXPECT_GE(room_above(facing, 20, 60), 0.89 * room);
    EXPECT_LE(room_above(facing, 20, 60), room + 0.02);
  }
}

TEST(AllowedGround, IsWholeBesideRegionsThatAreOpenToTheSameSide) {
  for (const double wall : {0.5, 2.0, 5.0, 14.0}) {
    SCOPED_TRACE(wall);
    std::vector<Finding> found;
    const std::vector<Region> ground =
        allowed({plateau(0, 0, Open::kAbove), plateau(25 + wall, 0, Open::kAbove)}, found);
    EXPECT_TRUE(found.empty());
    ASSERT_EQ(ground.size(), 2u);
    for (const Region& region : ground) EXPECT_NEAR(bounds_of({region}).high.y, 20 + kRoom, 1e-9);
  }
}

// A floor in a recess of an island's top, or the other way round.
TEST(AllowedGround, OfAnIslandsOwnFloorIsKeptFromThatRoundIt) {
  std::vector<Finding> found;
  const Region around =
      make_region(plateau(0, 0, Open::kAll).outer, {shapes::rectangle(3, 3, 22, 17)});
  const Region within = region_of({{{8, 5}, 0}, {{17, 5}, 0}, {{17, 14}, 0}, {{8, 14}, 0}});
  const std::vector<Region> ground = allowed({around, within}, found);
  EXPECT_TRUE(found.empty());
  ASSERT_EQ(ground.size(), 2u);
  EXPECT_NEAR(bounds_of({ground.back()}).low.x, -kRoom, 1e-9);
}

// What has no room of its own takes none from others.
TEST(AllowedGround, IsNarrowedByNoRegionThatIsTakenForWalled) {
  std::vector<Finding> found;
  const Region walled = region_of({{{0, 0}, 0}, {{25, 0}, 0}, {{25, 20}, 0}, {{0, 20}, 0}});
  const std::vector<Region> ground =
      allowed({walled, plateau(28, 0, Open::kAll), plateau(62, 0, Open::kAll)}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, FindingCode::kOpenEdgesTakenForWalls);
  ASSERT_EQ(ground.size(), 3u);
  // The second ends at 53.
  EXPECT_GT(bounds_of({ground.back()}).low.x, 53);
  EXPECT_LT(bounds_of({ground.back()}).low.x, 62 - 0.89 * 9);
}

TEST(AllowedGround, LetsTheToolClearRegionsWhoseRoomsMeet) {
  for (const double gap : {4.0, 8.0, 13.0, 20.0}) {
    SCOPED_TRACE(gap);
    ClearingParams params;
    params.tool_diameter = kTool;
    params.roll_radius = 1;
    params.levels = {-3};
    const std::vector<std::vector<Region>> pairs{
        {plateau(0, 0, Open::kAll), plateau(25 + gap, 0, Open::kAll)},
        {plateau(0, 0, Open::kAbove), open_beneath(0, 20 + gap)},
        {plateau(0, 0, Open::kAll), open_beneath(0, 20 + gap)}};
    for (const std::vector<Region>& regions : pairs) {
      Progress progress;
      const Toolpath path = clear_pocket(regions, params, progress);
      EXPECT_EQ(path.report.termination, Termination::kComplete);
      EXPECT_EQ(path.report.uncut_area, 0);
      if (&regions == &pairs.front()) {  // the judge knows no edges that are open beside walls
        path_check::Stock stock;
        stock.regions = regions;
        const path_check::Findings found = path_check::check_path(stock, 0.5 * kTool, path.moves);
        EXPECT_LE(found.cut_engagement, params.engagement_angle + 2 * kPi / 180);
        EXPECT_LE(found.link_engagement, kPi / 180);
        EXPECT_EQ(found.bad_plunges, 0);
        EXPECT_LE(found.left_share, 0.0005);
      }
      for (const Region& region : regions)
        for (const double x : {0.2, 0.5, 0.8})
          for (const double y : {0.2, 0.5, 0.8}) {
            const Vec2 low = bounds_of({region}).low;
            EXPECT_LE(nearest_cut(path, low + Vec2{25 * x, 20 * y}), 0.5 * kTool);
          }
    }
  }
}

}  // namespace
}  // namespace evenload
