#include "geometry/medial_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include "geometry/boundary_index.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

using shapes::circle;
using shapes::Named;
using shapes::polygon;
using shapes::rectangle;

std::vector<std::size_t> degrees(const MedialAxis& axis) {
  std::vector<std::size_t> degree(axis.nodes.size(), 0);
  for (const MedialAxis::Edge& e : axis.edges) {
    ++degree[e.from];
    ++degree[e.to];
  }
  return degree;
}

// All that must hold of any medial axis.
void check_axis(const Region& region, double tolerance, const std::string& name) {
  SCOPED_TRACE(name);
  const MedialAxis axis = medial_axis(region, tolerance);
  ASSERT_FALSE(axis.nodes.empty());
  const BoundaryIndex boundary(region.curves());
  std::vector<Segment> pieces;
  for (const Curve& c : region.curves())
    for (const Segment& s : c.segments()) pieces.push_back(s);
  int complaints = 0;
  for (const MedialAxis::Edge& e : axis.edges) {
    ASSERT_EQ(e.points.size(), e.radii.size());
    ASSERT_GE(e.points.size(), 2u);
    EXPECT_EQ(e.points.front(), axis.nodes[e.from].p);
    EXPECT_EQ(e.points.back(), axis.nodes[e.to].p);
    for (std::size_t i = 0; i < e.points.size(); ++i) {
      const Vec2 p = e.points[i];
      const double r = boundary.nearest(p).distance;
      EXPECT_NEAR(e.radii[i], r, 1e-9);
      EXPECT_TRUE(r < 1e-6 || boundary.contains(p)) << p.x << " " << p.y;
      if (i == 0 || i + 1 == e.points.size() || pieces.size() > 300) continue;
      // Two places of contact, to within what flattening changes: two feet that lie apart.
      std::vector<Vec2> feet;
      for (const Segment& s : pieces) {
        const Vec2 foot = s.point(s.nearest(p));
        if (distance(foot, p) <= r + 6 * tolerance) feet.push_back(foot);
        // A wide arc touches more than once where its ends are as near as its middle.
        for (const Vec2 end : {s.a, s.b})
          if (distance(end, p) <= r + 6 * tolerance) feet.push_back(end);
      }
      double apart = 0;
      for (const Vec2 a : feet)
        for (const Vec2 b : feet) apart = std::max(apart, distance(a, b));
      if (apart < std::min(0.01 * r, tolerance) && ++complaints < 4)
        ADD_FAILURE() << "one foot only at " << p.x << " " << p.y << " radius " << r;
    }
  }
  // The axis keeps the region's shape: in one piece, with one ring per island.
  std::vector<std::size_t> group(axis.nodes.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const std::function<std::size_t(std::size_t)> find = [&](std::size_t i) {
    return group[i] == i ? i : group[i] = find(group[i]);
  };
  for (const MedialAxis::Edge& e : axis.edges) group[find(e.from)] = find(e.to);
  std::size_t pieces_of_axis = 0;
  for (std::size_t i = 0; i < group.size(); ++i) pieces_of_axis += find(i) == i ? 1 : 0;
  EXPECT_EQ(pieces_of_axis, 1u);
  EXPECT_EQ(axis.edges.size() + 1 - axis.nodes.size(), region.islands.size());
  // Every corner has its branch, and no other branch ends on the boundary.
  const std::vector<std::size_t> degree = degrees(axis);
  std::vector<Vec2> ends;
  for (std::size_t k = 0; k < axis.nodes.size(); ++k)
    if (degree[k] == 1 && axis.nodes[k].radius < 1e-5) ends.push_back(axis.nodes[k].p);
  std::size_t corners = 0;
  for (const Curve& c : region.curves()) {
    for (std::size_t i = 0; i < c.segment_count(); ++i) {
      const Segment s = c.segment(i),
                    before = c.segment((i + c.segment_count() - 1) % c.segment_count());
      const Vec2 u = before.tangent(1), v = s.tangent(0);
      if (std::atan2(cross(u, v), dot(u, v)) < 0.01) continue;
      ++corners;
      EXPECT_TRUE(
          std::any_of(ends.begin(), ends.end(), [&](Vec2 p) { return distance(p, s.a) < 1e-5; }))
          << "no branch to the corner " << s.a.x << " " << s.a.y;
    }
  }
  EXPECT_EQ(ends.size(), corners);
}

TEST(MedialAxis, OfASquareIsItsDiagonals) {
  const MedialAxis axis = medial_axis(make_region(rectangle(0, 0, 60, 60)), 0.01);
  EXPECT_EQ(axis.nodes.size(), 5u);
  ASSERT_EQ(axis.edges.size(), 4u);
  for (const MedialAxis::Edge& e : axis.edges)
    for (const Vec2 p : e.points)
      EXPECT_NEAR(std::min(std::abs(p.x - p.y), std::abs(p.x + p.y - 60)), 0, 1e-6);
}

TEST(MedialAxis, OfARectangleHasAMiddleLine) {
  const MedialAxis axis = medial_axis(make_region(rectangle(0, 0, 100, 9)), 0.01);
  EXPECT_EQ(axis.nodes.size(), 6u);
  EXPECT_EQ(axis.edges.size(), 5u);
}

TEST(MedialAxis, OfADiscIsItsCentre) {
  const MedialAxis axis = medial_axis(make_region(circle({3, 4}, 6)), 0.01);
  ASSERT_EQ(axis.nodes.size(), 1u);
  EXPECT_TRUE(axis.edges.empty());
  EXPECT_NEAR(distance(axis.nodes[0].p, {3, 4}), 0, 1e-6);
  EXPECT_NEAR(axis.nodes[0].radius, 6, 1e-6);
}

TEST(MedialAxis, OfARoundSlotIsTheLineBetweenItsEnds) {
  for (const double tolerance : {0.1, 0.01, 1e-3, 1e-4}) {
    const MedialAxis axis = medial_axis(make_region(shapes::slot({0, 0}, 16.25, 4.375)), tolerance);
    ASSERT_EQ(axis.edges.size(), 1u) << tolerance;
    double length = 0;
    for (std::size_t i = 1; i < axis.edges[0].points.size(); ++i)
      length += distance(axis.edges[0].points[i - 1], axis.edges[0].points[i]);
    EXPECT_NEAR(length, 16.25, 20 * std::sqrt(tolerance * 4.375));
  }
}

TEST(MedialAxis, OfARingIsOneCircle) {
  const MedialAxis axis = medial_axis(make_region(circle({0, 0}, 30), {circle({0, 0}, 18)}), 0.01);
  ASSERT_EQ(axis.edges.size(), 1u);
  EXPECT_EQ(axis.edges[0].from, axis.edges[0].to);
  for (const double r : axis.edges[0].radii) EXPECT_NEAR(r, 6, 0.02);
}

TEST(MedialAxis, HasNoTwigsFromFlatteningInRoundedCorners) {
  const double q = std::sqrt(2.0) - 1;
  for (const double tolerance : {0.05, 0.01, 1e-3}) {
    const Curve rounded({{{5, 0}},
                         {{35, 0}, q},
                         {{40, 5}},
                         {{40, 25}, q},
                         {{35, 30}},
                         {{5, 30}, q},
                         {{0, 25}},
                         {{0, 5}, q}},
                        true);
    const MedialAxis axis = medial_axis(make_region(rounded), tolerance);
    EXPECT_EQ(axis.edges.size(), 5u) << tolerance;
    for (const MedialAxis::Node& n : axis.nodes) EXPECT_GT(n.radius, 4.5);
  }
}

TEST(MedialAxis, LawsHoldForAllPockets) {
  for (const Named& n : shapes::pockets())
    for (const double tolerance : {0.1, 0.01, 1e-3})
      check_axis(n.region, tolerance, n.name + " at " + std::to_string(tolerance));
}

TEST(MedialAxis, LawsHoldForRandomRegions) {
  for (unsigned seed = 50; seed < 53; ++seed)
    for (const Named& n : shapes::random_regions(seed, 60)) check_axis(n.region, 0.01, n.name);
}

TEST(MedialAxis, SurvivesWallsThinnerThanTheTolerance) {
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8}) {
    EXPECT_NO_THROW(medial_axis(make_region(circle({0, 0}, 20), {circle({0, 0}, 20 - gap)}), 0.05));
    EXPECT_NO_THROW(
        medial_axis(make_region(rectangle(0, 0, 20, 20), {circle({10, 10}, 10 - gap)}), 0.05));
    EXPECT_NO_THROW(
        largest_circle(make_region(rectangle(0, 0, 20, 20), {circle({10, 10}, 10 - gap)}), 0.05));
  }
}

TEST(MedialAxis, RefusesAToleranceOfZero) {
  EXPECT_THROW(medial_axis(make_region(rectangle(0, 0, 1, 1)), 0), std::invalid_argument);
  EXPECT_THROW(largest_circle(make_region(rectangle(0, 0, 1, 1)), 0), std::invalid_argument);
}

TEST(LargestCircle, OfSimpleShapesIsExact) {
  for (const double tolerance : {0.1, 1e-3, 1e-6}) {
    const auto expect = [&](const Region& region, Vec2 centre, double radius) {
      const Circle c = largest_circle(region, tolerance);
      EXPECT_NEAR(c.radius, radius, 1e-7) << tolerance;
      EXPECT_NEAR(distance(c.centre, centre), 0, 1e-4)
          << tolerance << ": " << c.centre.x << " " << c.centre.y;
    };
    expect(make_region(circle({1, 2}, 6)), {1, 2}, 6);
    expect(make_region(rectangle(0, 0, 60, 60)), {30, 30}, 30);
    expect(make_region(rectangle(0, 0, 100, 9)), {4.5, 4.5}, 4.5);
    expect(make_region(shapes::slot({0, 0}, 16.25, 4.375)), {-8.125, 0}, 4.375);
    expect(make_region(polygon({{0, 0}, {30, 0}, {0, 40}})), {10, 10}, 10);
  }
  const Circle in_ring =
      largest_circle(make_region(circle({0, 0}, 30), {circle({0, 0}, 18)}), 1e-3);
  EXPECT_NEAR(in_ring.radius, 6, 1e-9);
  EXPECT_NEAR(norm(in_ring.centre), 24, 1e-6);
  EXPECT_NEAR(in_ring.centre.x, -24, 0.01);
}

TEST(LargestCircle, OfTwoRoomsAlikeIsTheLeftOne) {
  for (const Named& n : shapes::pockets()) {
    if (n.name.substr(0, 9) != "two_rooms") continue;
    const Circle c = largest_circle(n.region, 1e-3);
    EXPECT_GT(c.radius, 14.9);
    EXPECT_LT(c.centre.x, 20);
  }
}

TEST(LargestCircle, LiesInsideAndNoneOfManyIsLarger) {
  std::mt19937 random(60);
  for (unsigned seed = 60; seed < 63; ++seed) {
    for (const Named& n : shapes::random_regions(seed, 60)) {
      const BoundaryIndex boundary(n.region.curves());
      const double tolerance = 1e-4;
      const Circle c = largest_circle(n.region, tolerance);
      EXPECT_TRUE(boundary.contains(c.centre)) << n.name;
      EXPECT_NEAR(boundary.nearest(c.centre).distance, c.radius, 1e-9) << n.name;
      const Bounds box = bounds_of({n.region});
      for (int i = 0; i < 3000; ++i) {
        Vec2 q{uniform(random, box.low.x, box.high.x), uniform(random, box.low.y, box.high.y)};
        if (i % 3 == 0) q = c.centre + uniform(random, 0, 0.1) * (q - c.centre);
        EXPECT_TRUE(!boundary.contains(q) || boundary.nearest(q).distance <= c.radius + tolerance)
            << n.name;
      }
      for (const MedialAxis::Edge& e : medial_axis(n.region, 0.01).edges)
        for (const double r : e.radii) EXPECT_LE(r, c.radius + tolerance) << n.name;
    }
  }
}

TEST(LargestCircle, MovesWithItsRegion) {
  std::mt19937 random(64);
  std::vector<Named> all = shapes::random_regions(64, 60);
  for (const Named& n : shapes::pockets()) all.push_back(n);
  for (const Named& n : all) {
    const Vec2 shift{uniform(random, -200, 200), uniform(random, -200, 200)};
    const Circle c = largest_circle(n.region, 1e-3),
                 moved = largest_circle(shapes::moved(n.region, 0, false, 1, shift), 1e-3);
    EXPECT_NEAR(moved.radius, c.radius, 1e-7) << n.name;
    EXPECT_NEAR(distance(moved.centre, c.centre + shift), 0, 1e-4) << n.name;
    const Circle again = largest_circle(n.region, 1e-3);
    EXPECT_EQ(again.centre, c.centre);
  }
}

TEST(LargestCircle, OfTenThousandEdgesIsFound) {
  std::vector<Vec2> round;
  for (int i = 0; i < 10000; ++i) round.push_back(Vec2{5, 6} + 40 * unit(2 * kPi * i / 10000));
  const Circle c = largest_circle(make_region(polygon(round)), 1e-3);
  EXPECT_NEAR(distance(c.centre, {5, 6}), 0, 1e-4);
  EXPECT_NEAR(c.radius, 40, 1e-4);

  std::mt19937 random(65);
  const Region wavy = make_region(shapes::wavy_polygon(random, {0, 0}, 50, 10000));
  const Circle inside = largest_circle(wavy, 1e-3);
  EXPECT_NEAR(BoundaryIndex(wavy.curves()).nearest(inside.centre).distance, inside.radius, 1e-9);
}

TEST(LargestTool, IsTheWidthOfTheWidestPlace) {
  EXPECT_EQ(largest_tool({}), 0);
  EXPECT_NEAR(largest_tool({make_region(rectangle(0, 0, 5, 20)), make_region(circle({50, 0}, 3))}),
              6, 1e-6);
  EXPECT_NEAR(largest_tool({make_region(rectangle(0, 0, 5, 20))}), 5, 1e-6);
}

}  // namespace
}  // namespace evenload
