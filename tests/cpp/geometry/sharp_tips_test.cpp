// Tips of shrunk borders between walls that are nearly parallel.
#include "geometry/sharp_tips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

constexpr double kGap = 8e-4;

// A room with a tooth that narrows by `angle` rad from 6.2 mm on and ends where it is `end` mm
// wide.
std::vector<Vec2> room_with_tooth(double angle, double end) {
  const double depth = 0.5 * (6.2 - end) / std::tan(0.5 * angle), half = 0.5 * end;
  return {{-15, -20},    {15, -20},      {15, 0},   {3.1, 0},
          {half, depth}, {-half, depth}, {-3.1, 0}, {-15, 0}};
}

std::vector<Region> at_gap(const Region& region) { return offset({region}, -(kRadius + kGap)); }
std::vector<Region> without_gap(const Region& region) { return offset({region}, -kRadius); }
std::vector<Region> to_tips(const Region& region) {
  return shrunk_to_tips({region}, kRadius, kGap);
}

double highest(const std::vector<Region>& regions) { return bounds_of(regions).high.y; }

// The regions' own laws hold, and the tool gets through no wall.
void expect_within_walls(const Region& region, const std::vector<Region>& tips) {
  const BoundaryIndex walls(region.curves());
  for (const Region& part : tips) {
    EXPECT_NO_THROW(make_region(part.outer, part.islands));
    for (const Curve& curve : part.curves())
      for (const Segment& piece : curve.segments())
        for (const double t : {0.0, 0.5, 0.9, 0.99}) {
          EXPECT_TRUE(region.contains(piece.point(t)));
          EXPECT_GE(walls.nearest(piece.point(t)).distance, kRadius - 1e-6);
        }
  }
}

TEST(SharpTips, ReachWhereTheToolTouchesBothWallsButForTheGap) {
  for (const double angle : {0.002, 0.01, 0.03, 0.06}) {
    const Region room = make_region(shapes::polygon(room_with_tooth(angle, 5.8)));
    const double touching = highest(without_gap(room));
    EXPECT_GT(touching - highest(at_gap(room)), 20 * kGap) << angle;
    EXPECT_NEAR(touching - highest(to_tips(room)), kGap, 2e-5) << angle;
    expect_within_walls(room, to_tips(room));
    // From any side, and in the notch of an island.
    const Region turned = make_region(shapes::moved(room.outer, 2, true, 1, {1e3, -5e2}));
    const double depth = 0.2 / std::tan(0.5 * angle);
    const Curve block = shapes::polygon({{-15, depth + 20},
                                         {-15, 0},
                                         {-3.1, 0},
                                         {-2.9, depth},
                                         {2.9, depth},
                                         {3.1, 0},
                                         {15, 0},
                                         {15, depth + 20}});
    const Region frame = make_region(shapes::rectangle(0, -1500, 2000, 500),
                                     {shapes::moved(block, 2, true, 1, {1e3, -5e2})});
    for (const Region& region : {turned, frame}) {
      EXPECT_GT(to_tips(region).front().area(), at_gap(region).front().area());
      expect_within_walls(region, to_tips(region));
    }
  }
}

// Where the tool nearly touches both walls when it comes to a third one.
TEST(SharpTips, EndBeforeAWallAcross) {
  for (const double angle : {0.005, 0.01, 0.02})
    for (double end = 6; end < 6.003; end += 1e-4) {
      const Region room = make_region(shapes::polygon(room_with_tooth(angle, end)));
      SCOPED_TRACE(end);
      EXPECT_GE(highest(to_tips(room)), highest(at_gap(room)) - 1e-9);
      EXPECT_LE(highest(to_tips(room)), highest(without_gap(room)) - 0.9 * kGap);
      expect_within_walls(room, to_tips(room));
    }
}

// Where the tool just fits through, or just does not.
TEST(SharpTips, StayInNecks) {
  for (const double angle : {0.005, 0.01, 0.02})
    for (double neck = 5.998; neck < 6.003; neck += 2e-4) {
      const double rise = 20 * std::tan(0.5 * angle), half = 0.5 * neck;
      const Region rooms = make_region(shapes::polygon({{-40, -20},
                                                        {-20, -20},
                                                        {-20, -half - rise},
                                                        {0, -half},
                                                        {20, -half - rise},
                                                        {20, -20},
                                                        {40, -20},
                                                        {40, 20},
                                                        {20, 20},
                                                        {20, half + rise},
                                                        {0, half},
                                                        {-20, half + rise},
                                                        {-20, 20},
                                                        {-40, 20}}));
      SCOPED_TRACE(neck);
      const std::vector<Region> tips = to_tips(rooms);
      expect_within_walls(rooms, tips);
      if (tips.size() < 2) continue;
      const Bounds a = bounds_of({tips[0]}), b = bounds_of({tips[1]});
      EXPECT_TRUE(a.high.x < b.low.x || b.high.x < a.low.x);
      if (neck > 6) {
        EXPECT_EQ(tips[0].outer.vertices().size(), at_gap(rooms)[0].outer.vertices().size());
        EXPECT_EQ(bounds_of(tips).high.x, bounds_of(at_gap(rooms)).high.x);
        EXPECT_EQ(tips[0].area(), at_gap(rooms)[0].area());
      }
    }
}

// Through a neck that lets the tool through but for the gap, to a room that ends before the walls
// would meet: the tip would lie on that room's own region.
TEST(SharpTips, KeepOutOfRoomsBeyondNecks) {
  const Region rooms = make_region(shapes::polygon({{-50, -20},
                                                    {-40, -20},
                                                    {-40, -3.0804},
                                                    {0, -3.0004},
                                                    {0, -12},
                                                    {3.16, -12},
                                                    {3.16, 12},
                                                    {0, 12},
                                                    {0, 3.0004},
                                                    {-40, 3.0804},
                                                    {-40, 20},
                                                    {-50, 20}}));
  const std::vector<Region> tips = to_tips(rooms);
  ASSERT_EQ(tips.size(), 2);
  const Bounds a = bounds_of({tips[0]}), b = bounds_of({tips[1]});
  EXPECT_TRUE(a.high.x < b.low.x || b.high.x < a.low.x);
  expect_within_walls(rooms, tips);
}

// A spike of micrometres on a wall, beside the axis of a long tip.
TEST(SharpTips, KeepOffWhatStandsOnTheirWalls) {
  const double slope = 5e-5, missing = kGap / slope - kGap;
  for (double share = 0.05; share < 1; share += 0.03) {
    const double at = share * missing;
    const auto half = [&](double x) { return 3.00072 - slope * x; };
    const Region room = make_region(shapes::polygon({{-100, -half(-100)},
                                                     {at - 1e-3, -half(at)},
                                                     {at, -half(at) + 4e-3},
                                                     {at + 1e-3, -half(at)},
                                                     {28, -half(28)},
                                                     {28, half(28)},
                                                     {-100, half(-100)}}));
    SCOPED_TRACE(share);
    expect_within_walls(room, to_tips(room));
  }
}

TEST(SharpTips, AreAllThatChanges) {
  std::vector<Region> regions;
  for (const shapes::Named& named : shapes::pockets()) regions.push_back(named.region);
  for (const shapes::Named& named : shapes::random_regions(3, 200)) regions.push_back(named.region);
  regions.push_back(make_region(shapes::polygon(room_with_tooth(0.01, 5.8))));
  int moved = 0;
  for (const Region& region : regions) {
    const std::vector<Region> before = at_gap(region), after = to_tips(region);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t r = 0; r < before.size(); ++r) {
      const std::vector<Curve> was = before[r].curves(), is = after[r].curves();
      for (std::size_t c = 0; c < was.size(); ++c) {
        const std::vector<Vertex>&from = was[c].vertices(), &to = is[c].vertices();
        ASSERT_EQ(from.size(), to.size());
        const std::size_t n = from.size();
        for (std::size_t i = 0; i < n; ++i) {
          EXPECT_EQ(from[i].bulge, to[i].bulge);
          if (from[i].p == to[i].p) continue;
          ++moved;
          const Vec2 in = from[(i + n - 1) % n].p, out = from[(i + 1) % n].p;
          const Vec2 u = normalized(from[i].p - in), v = normalized(out - from[i].p);
          EXPECT_LT(dot(u, v), -0.99);
          EXPECT_LT(distance(from[i].p, to[i].p),
                    0.25 * std::min(distance(in, from[i].p), distance(out, from[i].p)));
        }
      }
    }
  }
  EXPECT_GE(moved, 1);
}

TEST(SharpTips, AreLeftAtOpenEdgesArcsAndShortWalls) {
  const double angle = 0.01;
  std::vector<Vec2> corners = room_with_tooth(angle, 5.8);
  const auto tip = [&](std::size_t marked, double bulge) {
    std::vector<Vertex> vertices;
    for (const Vec2 p : corners) vertices.push_back({p});
    if (marked < vertices.size()) {
      vertices[marked].open = bulge == 0;
      vertices[marked].bulge = bulge;
    }
    const Region room = make_region(Curve(std::move(vertices), true));
    return highest(to_tips(room)) - highest(at_gap(room));
  };
  const std::size_t right = 3, left = 5, none = 99;  // the tooth's walls begin there
  EXPECT_GT(tip(none, 0), 0.1);
  for (const std::size_t wall : {right, left}) {
    EXPECT_EQ(tip(wall, 0), 0);
    EXPECT_NEAR(tip(wall, 1e-5), 0, 1e-9);
  }
  // The last half millimetre, of which the tip would take a quarter and more, at an angle of its
  // own.
  const double depth = corners[4].y,
               where = 0.2 / 0.4 * depth;  // where the tool touches both walls
  const auto at = [&](double y) { return 3.1 - 0.2 * y / depth; };
  corners = {{-15, -20},
             {15, -20},
             {15, 0},
             {3.2, 0},
             {at(where - 0.3), where - 0.3},
             {2.9, depth},
             {-2.9, depth},
             {-at(where - 0.3), where - 0.3},
             {-3.2, 0},
             {-15, 0}};
  EXPECT_EQ(tip(none, 0), 0);
}

}  // namespace
}  // namespace evenload
