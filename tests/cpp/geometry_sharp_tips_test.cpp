// Tips of offset borders between walls that are nearly parallel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/sharp_tips.h"
#include "geometry_shapes.h"

namespace evenload {
namespace {

constexpr double kGap = 8e-4, kRadius = 3;

// A room with a tooth that narrows by `angle` rad from 6.2 mm on and is blunt at 5.8 mm.
Curve room_with_tooth(double angle) {
  const double depth = 0.2 / std::tan(0.5 * angle);
  return shapes::polygon(
      {{-15, -20}, {15, -20}, {15, 0}, {3.1, 0}, {2.9, depth}, {-2.9, depth}, {-3.1, 0}, {-15, 0}});
}

// The same tooth in a block.
Curve block_with_notch(double angle) {
  const double depth = 0.2 / std::tan(0.5 * angle);
  return shapes::polygon({{-15, depth + 20},
                          {-15, 0},
                          {-3.1, 0},
                          {-2.9, depth},
                          {2.9, depth},
                          {3.1, 0},
                          {15, 0},
                          {15, depth + 20}});
}

double highest(const std::vector<Region>& regions) { return bounds_of(regions).high.y; }

TEST(SharpTips, ReachWhereTheToolTouchesBothWallsButForTheGap) {
  for (const double angle : {0.002, 0.01, 0.03, 0.06}) {
    const Region room = make_region(room_with_tooth(angle));
    const std::vector<Region> at_gap = offset({room}, -(kRadius + kGap));
    const std::vector<Region> whole = with_sharp_tips(at_gap, kGap);
    const double touching = highest(offset({room}, -kRadius));
    EXPECT_GT(touching - highest(at_gap), 20 * kGap) << angle;
    EXPECT_NEAR(touching - highest(whole), kGap, 2e-5) << angle;
    const BoundaryIndex walls({room.outer});
    for (const Vertex& v : whole.front().outer.vertices())
      EXPECT_GE(walls.nearest(v.p).distance, kRadius - 1e-6);
    EXPECT_NO_THROW(make_region(whole.front().outer, whole.front().islands));
    // From any side, and in the notch of an island.
    const Curve turned = shapes::moved(room.outer, 2, true, 1, {1e3, -5e2});
    const Curve notched = shapes::moved(block_with_notch(angle), 2, true, 1, {1e3, -5e2});
    const Region frame = make_region(shapes::rectangle(0, -1500, 2000, 500), {notched});
    for (const Region& region : {make_region(turned), frame}) {
      const std::vector<Region> before = offset({region}, -(kRadius + kGap));
      EXPECT_GT(with_sharp_tips(before, kGap).front().area(), before.front().area());
    }
  }
}

TEST(SharpTips, AreAllThatChanges) {
  std::vector<Region> regions;
  for (const shapes::Named& named : shapes::pockets()) regions.push_back(named.region);
  for (const shapes::Named& named : shapes::random_regions(3, 60)) regions.push_back(named.region);
  for (const Region& region : regions)
    for (const Region& centres : offset({region}, -(kRadius + kGap))) {
      const Region whole = with_sharp_tips({centres}, kGap).front();
      const std::vector<Curve> before = centres.curves(), after = whole.curves();
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t c = 0; c < before.size(); ++c) {
        const std::vector<Vertex>&was = before[c].vertices(), &is = after[c].vertices();
        ASSERT_EQ(was.size(), is.size());
        for (std::size_t i = 0; i < was.size(); ++i) {
          EXPECT_EQ(was[i].bulge, is[i].bulge);
          if (was[i].p == is[i].p) continue;
          const Vec2 in = was[(i + was.size() - 1) % was.size()].p,
                     out = was[(i + 1) % was.size()].p;
          const Vec2 u = normalized(was[i].p - in), v = normalized(out - was[i].p);
          EXPECT_LT(dot(u, v), -0.99);
          EXPECT_LT(distance(was[i].p, is[i].p),
                    0.25 * std::min(distance(in, was[i].p), distance(out, was[i].p)));
        }
      }
    }
}

TEST(SharpTips, AreLeftAtOpenEdgesArcsAndCrampedWalls) {
  const double angle = 0.01;
  Region room = offset({make_region(room_with_tooth(angle))}, -(kRadius + kGap)).front();
  const auto tip_of = [](const Region& region) { return bounds_of({region}).high.y; };
  const double tip = tip_of(room);
  ASSERT_GT(tip_of(with_sharp_tips({room}, kGap).front()), tip);
  std::vector<Vertex> vertices = room.outer.vertices();
  const auto at_tip =
      std::max_element(vertices.begin(), vertices.end(),
                       [](const Vertex& a, const Vertex& b) { return a.p.y < b.p.y; });
  at_tip->open = true;
  EXPECT_EQ(tip_of(with_sharp_tips({{Curve(vertices, true), {}}}, kGap).front()), tip);
  at_tip->open = false;
  at_tip->bulge = 0.01;
  EXPECT_NEAR(tip_of(with_sharp_tips({{Curve(vertices, true), {}}}, kGap).front()), tip, 1e-9);
}

}  // namespace
}  // namespace evenload
