// Where tools touch triangles: closed forms, and a search that knows nothing of them.
#include "surface/drop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "judge/numbers.h"

namespace evenload {
namespace {

constexpr double kFloor = -100;
const Cutter kTools[] = {{5, 5}, {5, 1.5}, {5, 0}};  // ball, bull nose, flat

FacetMesh mesh_of(const std::vector<std::array<SpacePoint, 3>>& triangles) {
  std::vector<SpacePoint> points;
  std::vector<FacetMesh::Triangle> numbers;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), triangle.begin(), triangle.end());
    numbers.push_back({first, first + 1, first + 2});
  }
  return FacetMesh(points, numbers, std::vector<bool>(numbers.size(), true));
}

// A square of 200 mm about the origin whose height is slope * x.
FacetMesh plane_of(double slope) {
  const auto at = [slope](double x, double y) { return SpacePoint{x, y, slope * x}; };
  return mesh_of({{at(-100, -100), at(100, -100), at(100, 100)},
                  {at(-100, -100), at(100, 100), at(-100, 100)}});
}

// The ground under a tool, looked at on rings: never higher than what drop finds.
double highest_on_rings(const std::vector<std::array<SpacePoint, 3>>& triangles, const Cutter& tool,
                        Vec2 at) {
  constexpr int kRings = 240, kRays = 240;
  double tip = kFloor;
  for (int i = 0; i <= kRings; ++i) {
    const double d = tool.radius * i / kRings;
    for (int k = 0; k < kRays; ++k) {
      const Vec2 p = at + d * unit(2 * kPi * k / kRays);
      for (const auto& [a, b, c] : triangles) {
        const double whole = cross(plan(b - a), plan(c - a));
        const double v = cross(p - plan(a), plan(c - a)) / whole;
        const double w = cross(plan(b - a), p - plan(a)) / whole;
        if (v < 0 || w < 0 || v + w > 1) continue;
        tip = std::max(tip, a.z + v * (b.z - a.z) + w * (c.z - a.z) - tool.rise(d));
      }
    }
  }
  return tip;
}

bool lies_on_one(const std::vector<std::array<SpacePoint, 3>>& triangles, SpacePoint p) {
  constexpr double kNear = 1e-6;
  for (const auto& [a, b, c] : triangles) {
    const double whole = cross(plan(b - a), plan(c - a));
    const double v = cross(plan(p - a), plan(c - a)) / whole;
    const double w = cross(plan(b - a), plan(p - a)) / whole;
    if (v < -kNear || w < -kNear || v + w > 1 + kNear) continue;
    if (std::abs(a.z + v * (b.z - a.z) + w * (c.z - a.z) - p.z) < kNear) return true;
  }
  return false;
}

TEST(Drop, OnAPlaneTheTubesCentreStandsOverTheContact) {
  for (const Cutter& tool : kTools)
    for (const double slope : {0.0, 0.3, 1.0, 4.0}) {
      const FacetMesh mesh = plane_of(slope);
      const double cosine = 1 / std::sqrt(1 + slope * slope), sine = slope * cosine;
      // The plane's height, and how far the tool is pushed up from it.
      const double expected = slope * 2 + tool.flat() * slope + tool.corner / cosine - tool.corner;
      const ToolContact found = drop(mesh, tool, {2, 3}, kFloor);
      EXPECT_NEAR(found.z, expected, 1e-12 * (1 + expected));
      EXPECT_NEAR(found.normal.z, cosine, 1e-12);
      EXPECT_NEAR(std::abs(found.normal.x), sine, 1e-12);
      EXPECT_TRUE(found.touches);
    }
}

TEST(Drop, OnACornerTheTipIsLowerByTheToolsRise) {
  const FacetMesh mesh = mesh_of({{{{0, 0, 7}, {0.01, 0, 0}, {0, 0.01, 0}}}});
  for (const Cutter& tool : kTools)
    for (const double d : {0.0, 2.0, 4.0, 4.99})
      EXPECT_NEAR(drop(mesh, tool, {-d, 0}, kFloor).z, 7 - tool.rise(d), 1e-12) << d;
}

TEST(Drop, OnAnEdgeNoPlaceOfItStandsHigher) {
  std::mt19937 random(3);
  const auto any = [&random] { return uniform(random, -6, 6); };
  for (int round = 0; round < 300; ++round) {
    const SpacePoint a{any(), any(), any()}, b{any(), any(), any()};
    // Two upright triangles have that edge alone for their upper side.
    const FacetMesh mesh =
        mesh_of({{{a, b, {b.x, b.y, -50}}}, {{a, {b.x, b.y, -50}, {a.x, a.y, -50}}}});
    for (const Cutter& tool : kTools) {
      double expected = kFloor, reached = kFloor;
      for (int i = 0; i <= 4000; ++i) {
        const SpacePoint p = a + (i / 4000.) * (b - a);
        if (norm(plan(p)) > tool.radius) continue;
        expected = std::max(expected, p.z - tool.rise(norm(plan(p))));
      }
      reached = drop(mesh, tool, {0, 0}, kFloor).z;
      EXPECT_GE(reached, expected - 1e-12);
      // Where a flat tool's rim, or a ball's side, meets the edge, the next sample is lower.
      if (expected > kFloor && tool.corner == tool.radius) {
        EXPECT_NEAR(reached, expected, 0.1);
      }
    }
  }
}

TEST(Drop, OnRandomTrianglesItIsTheHighestThatASearchFinds) {
  std::mt19937 random(11);
  for (int round = 0; round < 25; ++round) {
    std::vector<std::array<SpacePoint, 3>> triangles(12);
    for (auto& triangle : triangles)
      for (SpacePoint& p : triangle)
        p = {uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -2, 2)};
    const FacetMesh mesh = mesh_of(triangles);
    for (const Cutter& tool : kTools) {
      const ToolContact found = drop(mesh, tool, {0, 0}, kFloor);
      EXPECT_GE(found.z, highest_on_rings(triangles, tool, {0, 0}) - 1e-9);
      // No higher than it must be: there is ground where the tool touches.
      ASSERT_TRUE(found.touches);
      EXPECT_TRUE(lies_on_one(triangles, found.point));
      EXPECT_NEAR(found.z, found.point.z - tool.rise(norm(plan(found.point))), 1e-6);
    }
  }
}

// A step of 2 mm with upright walls: level facets, and edges that walls and floors share.
std::vector<std::array<SpacePoint, 3>> step() {
  std::vector<std::array<SpacePoint, 3>> triangles;
  const auto quad = [&](SpacePoint a, SpacePoint b, SpacePoint c, SpacePoint d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  quad({-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0});
  quad({-3, -4, 2}, {6, -4, 2}, {6, 5, 2}, {-3, 5, 2});
  quad({-3, -4, 0}, {6, -4, 0}, {6, -4, 2}, {-3, -4, 2});
  quad({6, -4, 0}, {6, 5, 0}, {6, 5, 2}, {6, -4, 2});
  return triangles;
}

TEST(Drop, InAWindowItIsTheSameOverLevelAndUprightFacets) {
  const FacetMesh mesh = mesh_of(step());
  std::mt19937 random(13);
  for (int round = 0; round < 200; ++round) {
    const Vec2 middle{uniform(random, -12, 12), uniform(random, -12, 12)};
    const double half = uniform(random, 0, 1) < 0.5 ? 0.2 : 2.0;
    for (const Cutter& tool : kTools) {
      const DropWindow window(mesh, tool, middle, half, kFloor);
      const std::uint32_t hint = drop(mesh, tool, middle, kFloor).facet;
      for (const double x : {-half, 0.3 * half, half})
        for (const double y : {-half, -0.7 * half, half}) {
          const Vec2 at{middle.x + x, middle.y + y};
          EXPECT_NEAR(window.drop(at, hint).z, drop(mesh, tool, at, kFloor).z, 1e-12);
          EXPECT_NEAR(window.drop(at, kNoFacet).z, drop(mesh, tool, at, kFloor, hint).z, 1e-12);
        }
    }
  }
}

TEST(Drop, InAWindowItIsTheSameAtEachPlace) {
  std::mt19937 random(12);
  for (const std::size_t count : {0U, 3U, 30U, 400U})  // of the many more than a window keeps
    for (int round = 0; round < 20; ++round) {
      std::vector<std::array<SpacePoint, 3>> triangles(count);
      for (auto& triangle : triangles) {
        const Vec2 about{uniform(random, -15, 15), uniform(random, -15, 15)};
        for (SpacePoint& p : triangle)
          p = {about.x + uniform(random, -4, 4), about.y + uniform(random, -4, 4),
               uniform(random, -3, 3)};
      }
      const FacetMesh mesh = mesh_of(triangles);
      const Vec2 middle{uniform(random, -20, 20), uniform(random, -20, 20)};
      const double half = uniform(random, 0, 1) < 0.5 ? 0.3 : 3.0;
      for (const Cutter& tool : kTools)
        for (const double floor : {kFloor, 1.0}) {
          const DropWindow window(mesh, tool, middle, half, floor);
          for (int i = 0; i < 20; ++i) {
            const Vec2 at{middle.x + uniform(random, -half, half),
                          middle.y + uniform(random, -half, half)};
            const ToolContact here = window.drop(at, kNoFacet), alone = drop(mesh, tool, at, floor);
            EXPECT_NEAR(here.z, alone.z, 1e-12);
            EXPECT_EQ(here.touches, alone.touches);
          }
        }
    }
}

TEST(Drop, OverASphereAndACylinderItIsAsFarOffAsTheTrianglesAre) {
  constexpr double kRound = 20;
  constexpr int kSides = 400;
  std::vector<std::array<SpacePoint, 3>> cylinder;
  const auto on = [&](int k, double x) {
    const double lean = kPi * k / kSides - 0.5 * kPi;
    return SpacePoint{x, kRound * std::sin(lean), kRound * std::cos(lean)};
  };
  for (int k = 0; k < kSides; ++k) {
    cylinder.push_back({on(k, -50), on(k, 50), on(k + 1, 50)});
    cylinder.push_back({on(k, -50), on(k + 1, 50), on(k + 1, -50)});
  }
  const FacetMesh mesh = mesh_of(cylinder);
  const double off = kRound * (1 - std::cos(0.5 * kPi / kSides));
  for (const double y : {0.0, 3.3, 11.0, 17.0}) {
    const double centre = std::sqrt((kRound + 5) * (kRound + 5) - y * y);
    const double lean = std::asin(y / (kRound + 5));
    const double found = drop(mesh, {5, 5}, {0, y}, kFloor).z;
    EXPECT_LE(found, centre - 5 + 1e-12);
    EXPECT_GE(found, centre - 5 - off / std::cos(lean) - 1e-12);
  }
}

TEST(Drop, ValleysAndFlatEdgesTouchNothingThatTheirTrianglesDoNot) {
  // A trough of many strips: with all edges told apart, or welded, the tool is as high.
  std::vector<std::array<SpacePoint, 3>> apart;
  const auto at = [](int k, double x) {
    const double y = 0.5 * k - 10;
    return SpacePoint{x, y, 0.05 * y * y};
  };
  for (int k = 0; k < 40; ++k) {
    apart.push_back({at(k, -30), at(k, 30), at(k + 1, 30)});
    apart.push_back({at(k, -30), at(k + 1, 30), at(k + 1, -30)});
  }
  const FacetMesh welded = mesh_of(apart);
  int touchable = 0;
  for (const Facet& facet : welded.facets())
    touchable +=
        static_cast<int>(std::count(facet.is_touchable.begin(), facet.is_touchable.end(), true));
  EXPECT_EQ(touchable, 2 + 2 * 40);  // the border alone
  for (const Cutter& tool : kTools)
    for (double y = -9; y < 9; y += 1.7) {
      const double searched = highest_on_rings(apart, tool, {0.2, y});
      EXPECT_GE(drop(welded, tool, {0.2, y}, kFloor).z, searched - 1e-9);
      EXPECT_NEAR(drop(welded, tool, {0.2, y}, kFloor).z, searched, 0.02);
    }
}

TEST(Drop, OverAWedgeItIsTheSameWhereverThePartLies) {
  // Upright triangles: the edge between the first two points is what a tool touches.
  const auto wedge = [](Vec2 by) {
    const SpacePoint a{by.x - 10, by.y, 1}, b{by.x + 10, by.y + 3, 7};
    return mesh_of({{{a, b, {b.x, b.y, -50}}}, {{a, {b.x, b.y, -50}, {a.x, a.y, -50}}}});
  };
  const Vec2 there{103.7, 55.3};
  const FacetMesh here = wedge({0, 0}), away = wedge(there);
  std::mt19937 random(5);
  for (const Cutter& tool : {Cutter{5, 5}, Cutter{5, 1.5}, Cutter{5, 0}, Cutter{0.5, 0}})
    for (int i = 0; i < 400; ++i) {
      // Off the upright sides, beyond which the edge's ends alone are touched.
      const double along = uniform(random, -8, 8);
      const Vec2 at = Vec2{along, 0.15 * along + 1.5} +
                      uniform(random, -0.9, 0.9) * tool.radius * unit(0.5 * kPi + 0.149);
      const double height = drop(here, tool, at, kFloor).z;
      EXPECT_NEAR(drop(away, tool, at + there, kFloor).z, height, 1e-6);
      EXPECT_GT(height, -10);
    }
}

TEST(Drop, ALevelFaceAtTheFloorIsTouched) {
  const FacetMesh mesh = mesh_of({{{{-100, -100, -3}, {100, -100, -3}, {0, 100, -3}}}});
  for (const Cutter& tool : kTools) {
    const ToolContact contact = drop(mesh, tool, {1, 2}, -3);
    EXPECT_TRUE(contact.touches && contact.is_within);
    EXPECT_EQ(contact.z, -3);
    EXPECT_TRUE(DropWindow(mesh, tool, {0, 0}, 3, -3).drop({1, 2}, kNoFacet).touches);
  }
}

TEST(Drop, OnALevelFaceItIsTheFaceThatCountsNotItsBorder) {
  const SpacePoint a{0, 0, 2}, b{40, 0, 2}, c{40, 6, 2}, d{0, 6, 2};
  const std::array<SpacePoint, 3> one{a, b, c}, other{a, c, d};
  for (const FacetMesh& mesh : {mesh_of({one, other}), mesh_of({other, one})})
    for (const Cutter& tool : kTools)
      for (int i = 0; i < 200; ++i) {
        const ToolContact contact = drop(mesh, tool, {0.5 + 0.19 * i, 0.3 + 0.027 * i}, kFloor);
        EXPECT_TRUE(contact.is_within) << i;
        EXPECT_EQ(contact.z, 2);
      }
}

TEST(Drop, PointsOnALineAreNoTriangle) {
  // A ridge beside which a triangle without a height lies, whose points rounding puts off the line.
  const SpacePoint a{100.1, 7.3, 3.1}, b{400.7, 109.9, 3.1};
  const SpacePoint between = a + (1.0 / 3) * (b - a);
  const FacetMesh mesh = mesh_of(
      {{{a, b, {b.x, b.y, -50}}}, {{a, {b.x, b.y, -50}, {a.x, a.y, -50}}}, {{a, between, b}}});
  for (int i = 1; i < 100; ++i) {
    const Vec2 at = plan(a + (i / 100.0) * (b - a));
    for (const Cutter& tool : kTools) EXPECT_NEAR(drop(mesh, tool, at, kFloor).z, 3.1, 1e-9);
  }
}

TEST(Drop, AToolThatFindsNothingStandsOnTheFloor) {
  const FacetMesh mesh = plane_of(0);
  EXPECT_EQ(drop(mesh, kTools[0], {300, 0}, -3).z, -3);
  EXPECT_FALSE(drop(mesh, kTools[0], {300, 0}, -3).touches);
  EXPECT_EQ(drop(FacetMesh({}, {}, {}), kTools[0], {0, 0}, -3).z, -3);
}

TEST(Drop, IsTheSameOnAnyNumberOfThreads) {
  const FacetMesh mesh = plane_of(0.4);
  std::vector<Vec2> places;
  for (int i = 0; i < 5000; ++i) places.push_back({0.01 * i, 0.003 * i});
  Progress progress;
  const std::vector<ToolContact> one = drop_all(mesh, kTools[1], places, kFloor, 1, progress);
  const std::vector<ToolContact> many = drop_all(mesh, kTools[1], places, kFloor, 4, progress);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(one[i].z, many[i].z);
}

TEST(FacetMesh, RefusesWhatIsNoMesh) {
  const std::vector<SpacePoint> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(FacetMesh(points, {{0, 1, 3}}, {true}), std::invalid_argument);
  EXPECT_THROW(FacetMesh(points, {{0, 1, 2}}, {}), std::invalid_argument);
  EXPECT_THROW(FacetMesh({{0, 0, std::nan("")}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {true}),
               std::invalid_argument);
  EXPECT_TRUE(FacetMesh(points, {{0, 1, 1}}, {true}).facets().empty());
}

}  // namespace
}  // namespace evenload
