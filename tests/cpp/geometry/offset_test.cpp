#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/boundary_index.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "support/errors.h"

namespace evenload {
namespace {

using shapes::circle;
using shapes::Named;
using shapes::polygon;
using shapes::rectangle;

std::vector<Curve> curves_of(const std::vector<Region>& regions) {
  std::vector<Curve> all;
  for (const Region& r : regions)
    for (const Curve& c : r.curves()) all.push_back(c);
  return all;
}

double area_of(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& r : regions) sum += r.area();
  return sum;
}

bool inside(const std::vector<Region>& regions, Vec2 q) {
  for (const Region& r : regions)
    if (r.contains(q)) return true;
  return false;
}

// All that must hold of any offset: its curves lie at distance |d|, it holds just the points that
// it should, and its regions are well formed. `scale` widens the tolerances for large shapes.
void check_offset(const std::vector<Region>& regions, double d, const std::string& name,
                  unsigned seed = 1, double scale = 1) {
  SCOPED_TRACE(name + ", d = " + std::to_string(d));
  std::vector<Region> result;
  ASSERT_NO_THROW(result = offset(regions, d));
  const std::vector<Curve> original = curves_of(regions), moved = curves_of(result);
  const BoundaryIndex boundary(original), boundary_moved(moved);
  const double tolerance = 1e-5 * scale;
  int complaints = 0;
  for (const Curve& c : moved) {
    for (const Segment& s : c.segments()) {
      EXPECT_GT(s.length(), 0);
      for (const double t : {0.0, 0.13, 0.5, 0.77}) {
        const double off = std::abs(boundary.nearest(s.point(t)).distance - std::abs(d));
        if (off > tolerance && ++complaints < 5)
          ADD_FAILURE() << "off by " << off << " at " << s.point(t).x << " " << s.point(t).y;
      }
    }
  }
  for (const Region& r : result) {
    EXPECT_GT(r.outer.signed_area(), 0);
    for (const Curve& island : r.islands) {
      EXPECT_LT(island.signed_area(), 0);
      EXPECT_TRUE(r.outer.contains(island.segment(0).point(0.5)));
    }
  }
  std::mt19937 random(seed);
  Bounds box = bounds_of(regions);
  const double reach = std::max(0.0, d) + 0.05 * (box.high.x - box.low.x);
  complaints = 0;
  for (int i = 0; i < 600; ++i) {
    const Vec2 q{uniform(random, box.low.x - reach, box.high.x + reach),
                 uniform(random, box.low.y - reach, box.high.y + reach)};
    const double signed_distance = (boundary.contains(q) ? -1 : 1) * boundary.nearest(q).distance;
    if (std::abs(signed_distance - d) < tolerance) continue;
    if (inside(result, q) != (signed_distance < d) && ++complaints < 5)
      ADD_FAILURE() << "wrong at " << q.x << " " << q.y << ", signed distance " << signed_distance;
  }
}

const std::vector<double>& usual_distances() {
  static const std::vector<double> all{-0.01, -0.5, -1,  -2, -2.5, -3, -4, -5, -7.5,
                                       -12,   0.01, 0.5, 1,  2.5,  3,  5,  10, 25};
  return all;
}

TEST(Offset, OfAllPocketsIsTheSetOfPointsAtThatDistance) {
  for (const Named& n : shapes::pockets())
    for (const double d : usual_distances()) check_offset({n.region}, d, n.name);
}

TEST(Offset, OfRandomRegionsIsTheSetOfPointsAtThatDistance) {
  std::mt19937 random(20);
  for (unsigned seed = 20; seed < 24; ++seed)
    for (const Named& n : shapes::random_regions(seed, 60))
      for (const double low : {-12.0, -3.0, 0.0, 0.0})
        check_offset({n.region}, uniform(random, low, low < 0 ? 0 : low + 6), n.name, seed);
}

TEST(Offset, OfCirclesIsACircle) {
  const std::vector<Region> disc{make_region(circle({3, 4}, 10))};
  EXPECT_NEAR(area_of(offset(disc, -4)), 36 * kPi, 1e-9);
  EXPECT_NEAR(area_of(offset(disc, 5)), 225 * kPi, 1e-9);
  EXPECT_TRUE(offset(disc, -10).empty());
  EXPECT_TRUE(offset(disc, -11).empty());
  const std::vector<Region> grown = offset(disc, 5);
  ASSERT_EQ(grown.size(), 1u);
  EXPECT_EQ(grown[0].outer.segment_count(), 2u);  // arcs stay arcs
}

TEST(Offset, OfASquareHasSharpCornersInsideAndRoundOnesOutside) {
  const std::vector<Region> square{make_region(rectangle(0, 0, 10, 10))};
  const std::vector<Region> shrunk = offset(square, -2), grown = offset(square, 2);
  ASSERT_EQ(shrunk.size(), 1u);
  EXPECT_EQ(shrunk[0].outer.segment_count(), 4u);
  EXPECT_NEAR(shrunk[0].area(), 36, 1e-9);
  ASSERT_EQ(grown.size(), 1u);
  EXPECT_EQ(grown[0].outer.segment_count(), 8u);
  EXPECT_NEAR(grown[0].area(), 100 + 80 + 4 * kPi, 1e-9);
}

TEST(Offset, ByNothingChangesNothing) {
  const std::vector<Region> square{make_region(rectangle(0, 0, 10, 10))};
  EXPECT_EQ(area_of(offset(square, 0)), 100);
  EXPECT_TRUE(offset({}, -3).empty());
  EXPECT_THROW(offset(square, std::nan("")), std::invalid_argument);
}

TEST(Offset, ExactlyAsWideAsTheSlotVanishes) {
  EXPECT_TRUE(offset({make_region(rectangle(0, 0, 100, 6))}, -3).empty());
  EXPECT_TRUE(offset({make_region(shapes::slot({0, 0}, 20, 3))}, -3).empty());
  EXPECT_TRUE(offset({make_region(circle({0, 0}, 30), {circle({0, 0}, 24)})}, -3).empty());
  // The corners of a square frame are wider than its sides.
  const std::vector<Region> corners =
      offset({make_region(rectangle(0, 0, 60, 60), {rectangle(6, 6, 54, 54)})}, -3);
  EXPECT_EQ(corners.size(), 4u);
  EXPECT_NEAR(area_of(corners), 4 * (9 - 9 * kPi / 4), 1e-4);
  for (const double nearly : {1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
    for (const double sign : {-1.0, 1.0}) {
      const double d = -3 + sign * nearly;
      EXPECT_LT(area_of(offset({make_region(rectangle(0, 0, 100, 6))}, d)), 1e-3) << d;
      EXPECT_LT(area_of(offset({make_region(circle({0, 0}, 30), {circle({0, 0}, 24)})}, d)), 1e-3)
          << d;
    }
  }
}

TEST(Offset, RoomsJoinedByANeckExactlyAsWideAsTheToolFallApart) {
  const auto rooms = [](double half) {
    return make_region(polygon({{0, 0},
                                {30, 0},
                                {30, 15 - half},
                                {45, 15 - half},
                                {45, 0},
                                {75, 0},
                                {75, 30},
                                {45, 30},
                                {45, 15 + half},
                                {30, 15 + half},
                                {30, 30},
                                {0, 30}}));
  };
  const double expected = area_of(offset({rooms(2.99999)}, -3));
  for (const double off : {0.0, 1e-13, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
    for (const double sign : {-1.0, 1.0}) {
      const std::vector<Region> result = offset({rooms(3 + sign * off)}, -3);
      EXPECT_NEAR(area_of(result), expected, 1e-1) << off * sign;
      check_offset({rooms(3 + sign * off)}, -3, "neck off by " + std::to_string(sign * off));
    }
  }
}

TEST(Offset, SurvivesTaperedNecks) {
  for (const double taper : {1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
    check_offset({make_region(polygon({{0, 0},
                                       {30, 0},
                                       {30, 12 + taper},
                                       {45, 12 - taper},
                                       {45, 0},
                                       {75, 0},
                                       {75, 30},
                                       {45, 30},
                                       {45, 18 + taper},
                                       {30, 18 - taper},
                                       {30, 30},
                                       {0, 30}}))},
                 -3, "taper " + std::to_string(taper));
}

TEST(Offset, GrowsRegionsThatMeetIntoOne) {
  const std::vector<Region> two{make_region(rectangle(0, 0, 10, 10)),
                                make_region(rectangle(14, 0, 24, 10))};
  EXPECT_EQ(offset(two, 1.9).size(), 2u);
  EXPECT_EQ(offset(two, 2.1).size(), 1u);
  for (const double d : {1.0, 1.999, 2.0, 2.0000001, 2.5, 6.0, 30.0})
    check_offset(two, d, "two squares");
  const std::vector<Region> nest{make_region(rectangle(0, 0, 40, 40), {rectangle(10, 10, 30, 30)}),
                                 make_region(circle({20, 20}, 5))};
  for (const double d : {-6.0, -5.0, -2.0, 1.0, 2.5, 2.6, 4.0, 8.0})
    check_offset(nest, d, "region inside an island's hole");
}

TEST(Offset, FillsAHoleThatGrowsShut) {
  const std::vector<Region> ring{make_region(circle({0, 0}, 20), {circle({0, 0}, 5)})};
  EXPECT_EQ(offset(ring, 4.9)[0].islands.size(), 1u);
  EXPECT_EQ(offset(ring, 5)[0].islands.size(), 0u);
  EXPECT_EQ(offset(ring, 5.1)[0].islands.size(), 0u);
}

TEST(Offset, SurvivesFilletsOfJustTheOffset) {
  const double q = std::sqrt(2.0) - 1;
  const auto rounded = [q](double r) {
    return make_region(Curve({{{r, 0}},
                              {{30 - r, 0}, q},
                              {{30, r}},
                              {{30, 20 - r}, q},
                              {{30 - r, 20}},
                              {{r, 20}, q},
                              {{0, 20 - r}},
                              {{0, r}, q}},
                             true));
  };
  for (const double off : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3, 0.1})
    for (const double sign : {-1.0, 1.0}) {
      check_offset({rounded(3 + sign * off)}, -3, "fillet off by " + std::to_string(sign * off));
      EXPECT_NEAR(area_of(offset({rounded(3 + sign * off)}, -3)), 24 * 14, 0.05);
    }
}

TEST(Offset, SurvivesTangentialTouches) {
  // Islands whose grown outlines just touch each other, the wall, or both.
  for (const double off : {0.0, 1e-13, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5}) {
    for (const double sign : {-1.0, 1.0}) {
      const double e = sign * off;
      const std::string name = "off by " + std::to_string(e);
      check_offset(
          {make_region(rectangle(0, 0, 60, 40), {circle({20, 20}, 5), circle({36 + e, 20}, 5)})},
          -3, "two discs " + name);
      check_offset({make_region(rectangle(0, 0, 60, 40), {circle({20, 11 + e}, 5)})}, -3,
                   "disc and wall " + name);
      check_offset({make_region(rectangle(0, 0, 60, 40),
                                {rectangle(6 + e, 6, 20, 20), rectangle(26, 6, 40, 20)})},
                   -3, "blocks " + name);
      check_offset({make_region(circle({0, 0}, 20), {circle({9 + e, 0}, 5)})}, -3,
                   "disc in disc " + name);
      check_offset({make_region(polygon({{0, 0}, {20, 0}, {20, 20}, {10, 6 + e}, {0, 20}}))}, -3,
                   "corner near a wall " + name);
    }
  }
}

TEST(Offset, SurvivesThreeFrontsMeetingInOnePoint) {
  for (const int n : {3, 4, 6, 7, 12, 100}) {
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) points.push_back(20 * unit(2 * kPi * i / n));
    const double inradius = 20 * std::cos(kPi / n);
    for (const double off : {-1e-3, -1e-5, -1e-7, -1e-9, 0.0, 1e-9, 1e-7, 1e-5, 1e-3, 1.0, 30.0})
      check_offset({make_region(polygon(points))}, -inradius - off,
                   "polygon of " + std::to_string(n));
  }
}

TEST(Offset, SurvivesSliversAndSpikes) {
  for (const double w : {1e-2, 1e-4, 1e-6}) {
    check_offset({make_region(polygon({{0, 0}, {50, 0}, {50, w}}))}, 2, "sliver");
    check_offset({make_region(polygon({{0, 0}, {50, 0}, {50, w}}))}, -0.5 * w, "sliver");
    check_offset(
        {make_region(polygon(
            {{0, 0}, {20, 0}, {20, 10}, {60, 10 + w}, {20, 10 + 2 * w}, {20, 20}, {0, 20}}))},
        -3, "spike");
    check_offset(
        {make_region(polygon(
            {{0, 0}, {20, 0}, {20, 10}, {60, 10 + w}, {20, 10 + 2 * w}, {20, 20}, {0, 20}}))},
        3, "spike");
    check_offset(
        {make_region(polygon(
            {{0, 0}, {40, 0}, {40, 10}, {10, 10 + w}, {40, 10 + 2 * w}, {40, 20}, {0, 20}}))},
        3, "cut");
    check_offset(
        {make_region(polygon(
            {{0, 0}, {40, 0}, {40, 10}, {10, 10 + w}, {40, 10 + 2 * w}, {40, 20}, {0, 20}}))},
        -3, "cut");
  }
}

TEST(Offset, SurvivesCusps) {
  // Two arcs that start out tangent to each other: a drop's tip, thin inside and thin outside.
  const double q = std::sqrt(2.0) - 1;
  const Curve crescent({{{0, 0}, 1}, {{20, 0}, -q * 1.2}}, true);
  const Curve moon({{{-10, 0}, 1}, {{10, 0}, 0.5}, {{0, 5}, -1}}, true);
  for (const double d : usual_distances()) {
    check_offset({make_region(crescent)}, d, "crescent");
    try {
      check_offset({make_region(moon)}, d, "moon");
    } catch (const GeometryError&) {
    }
  }
  // A semicircle, closed by two semicircles of half its size that run back: tips of no width.
  const Curve arbelos({{{20, 0}, 1}, {{-20, 0}, -1}, {{1, 0}, -1}}, true);
  for (const double d : usual_distances()) check_offset({make_region(arbelos)}, d, "arbelos");
}

TEST(Offset, SurvivesCollinearVerticesAndTinyKinks) {
  for (const double kink : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    for (const int n : {30, 1000}) {
      std::mt19937 random(5);
      std::vector<Vec2> points{{0, 0}};
      double heading = 0;
      for (int i = 0; i < n; ++i) {
        points.push_back(points.back() + 60.0 / n * unit(heading));
        heading = 0.5 * heading + kink * uniform(random, -1, 1);
      }
      points.push_back({60, 30});
      points.push_back({0, 30});
      for (const double d : {-3.0, -0.3, 3.0, -10.0})
        check_offset({make_region(polygon(points))}, d,
                     "kinks of " + std::to_string(kink) + ", " + std::to_string(n));
    }
  }
}

TEST(Offset, SurvivesChainsOfThousandsOfTinyPieces) {
  std::mt19937 random(31);
  for (const int n : {500, 3000, 10000})
    for (const double d : {-0.2, -3.0, -9.0, 0.2, 3.0, 20.0}) {
      check_offset({make_region(shapes::wavy_polygon(random, {0, 0}, 40, n))}, d,
                   "chain of " + std::to_string(n) + " lines");
      check_offset({make_region(shapes::wavy_arcs(random, {0, 0}, 40, n))}, d,
                   "chain of " + std::to_string(n) + " arcs");
    }
}

TEST(Offset, AddsNoMicroscopicJoinArcs) {
  std::mt19937 random(32);
  const std::vector<Region> chain{make_region(shapes::wavy_arcs(random, {0, 0}, 40, 2000))};
  for (const Region& r : offset(chain, -1))
    for (const Segment& s : r.outer.segments()) EXPECT_GT(s.length(), 0.5 * kOffsetTolerance);
}

TEST(Offset, WorksFarFromTheOriginAndAtHundredfoldSize) {
  std::mt19937 random(34);
  for (const Named& n : shapes::random_regions(34, 60)) {
    const double d = uniform(random, -5, 5);
    check_offset({shapes::moved(n.region, 0.3, false, 1, {1e4, -1e4})}, d, n.name + " far");
    check_offset({shapes::moved(n.region, 0.3, true, 100, {0, 0})}, 100 * d, n.name + " large", 1,
                 10);
    check_offset({shapes::moved(n.region, 0.3, true, 0.05, {0, 0})}, 0.05 * d, n.name + " small");
  }
}

TEST(Offset, TurnsMirrorsAndShiftsWithItsInput) {
  std::mt19937 random(35);
  for (const Named& n : shapes::random_regions(35, 80)) {
    const double d = uniform(random, -4, 3), angle = uniform(random, 0, 6);
    const bool mirrored = random() % 2 == 0;
    const Vec2 shift{uniform(random, -100, 100), uniform(random, -100, 100)};
    const std::vector<Region> result = offset({n.region}, d);
    const std::vector<Region> other =
        offset({shapes::moved(n.region, angle, mirrored, 1, shift)}, d);
    EXPECT_EQ(result.size(), other.size()) << n.name << " " << d;
    EXPECT_NEAR(area_of(result), area_of(other), 1e-4) << n.name << " " << d;
    if (other.empty()) continue;
    const BoundaryIndex boundary(curves_of(other));
    for (const Curve& c : curves_of(result))
      for (const Segment& s : c.segments())
        EXPECT_LT(boundary.nearest(shapes::moved(s.point(0.4), angle, mirrored, 1, shift)).distance,
                  1e-4)
            << n.name << " " << d;
  }
}

TEST(Offset, InTwoStepsIsTheSameAsInOne) {
  std::mt19937 random(36);
  for (const Named& n : shapes::random_regions(36, 100)) {
    const double d1 = uniform(random, 0, 3), d2 = uniform(random, 0, 3);
    EXPECT_NEAR(area_of(offset({n.region}, -d1 - d2)),
                area_of(offset(offset({n.region}, -d1), -d2)), 1e-3)
        << n.name << " " << d1 << " " << d2;
    EXPECT_NEAR(area_of(offset({n.region}, d1 + d2)), area_of(offset(offset({n.region}, d1), d2)),
                1e-3)
        << n.name << " " << d1 << " " << d2;
  }
}

TEST(Offset, OpeningLiesInsideAndClosingOutside) {
  std::mt19937 random(37);
  for (const Named& n : shapes::random_regions(37, 80)) {
    const double d = uniform(random, 0.1, 5);
    const BoundaryIndex boundary(n.region.curves());
    for (const double sign : {-1.0, 1.0}) {
      const std::vector<Region> there_and_back = offset(offset({n.region}, sign * d), -sign * d);
      for (const Curve& c : curves_of(there_and_back))
        for (const Segment& s : c.segments())
          for (const double t : {0.0, 0.3, 0.6}) {
            const Vec2 p = s.point(t);
            if (boundary.nearest(p).distance < 1e-4) continue;
            EXPECT_EQ(boundary.contains(p), sign < 0) << n.name << " " << d;
          }
    }
  }
}

TEST(Offset, ResultsAreRegionsAgain) {
  std::mt19937 random(38);
  for (const Named& n : shapes::random_regions(38, 100)) {
    const double d = uniform(random, -5, 5);
    for (const Region& r : offset({n.region}, d))
      EXPECT_NO_THROW(make_region(r.outer, r.islands)) << n.name << " " << d;
  }
}

TEST(Offset, FrontsThatJustTouchArePartedOrMerged) {
  const std::vector<Region> touching{
      make_region(rectangle(0, 0, 60, 40), {circle({20, 20}, 5), circle({36, 20}, 5)}),
      make_region(rectangle(0, 0, 60, 40), {circle({20, 11}, 5)}),
      make_region(rectangle(0, 0, 60, 40), {rectangle(6, 6, 20, 20), rectangle(26, 6, 40, 20)}),
      make_region(circle({0, 0}, 20), {circle({9, 0}, 5)}),
      make_region(polygon({{0, 0}, {20, 0}, {20, 20}, {10, 6}, {0, 20}}))};
  for (const Region& region : touching)
    for (const Region& r : offset({region}, -3)) EXPECT_NO_THROW(make_region(r.outer, r.islands));
}

TEST(Offset, KeepsOpenMarks) {
  Curve outline({{{0, 0}, 0, true}, {{40, 0}}, {{40, 30}}, {{0, 30}}}, true);
  const std::vector<Region> shrunk = offset({make_region(outline)}, -3);
  ASSERT_EQ(shrunk.size(), 1u);
  for (const Segment& s : shrunk[0].outer.segments())
    EXPECT_EQ(s.open, s.a.y == s.b.y && s.a.y < 10);
}

}  // namespace
}  // namespace evenload
