#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/intersect.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "support/errors.h"

namespace evenload {
namespace {

using shapes::circle;
using shapes::polygon;
using shapes::rectangle;

std::vector<Segment> random_segments(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Segment> found;
  for (int i = 0; i < count; ++i) {
    const Vec2 a{uniform(random, -20, 20), uniform(random, -20, 20)};
    const Vec2 b{uniform(random, -20, 20), uniform(random, -20, 20)};
    const double bulge = i % 4 == 0 ? 0.0 : std::tan(uniform(random, -1.5, 1.5));
    found.push_back(Segment::from_bulge(a, b, i % 4 == 1 ? 0.01 * bulge : bulge));
  }
  return found;
}

TEST(Segment, StartsAtAAndEndsAtBOnItsCircleWithAUnitTangent) {
  for (const Segment& s : random_segments(1, 400)) {
    EXPECT_EQ(s.point(0), s.a);
    EXPECT_EQ(s.point(1), s.b);
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      EXPECT_NEAR(norm(s.tangent(t)), 1, 1e-12);
      if (s.is_arc()) {
        EXPECT_NEAR(distance(s.point(t), s.centre), s.radius, 1e-11 * s.radius + 1e-11);
      }
    }
  }
}

TEST(Segment, RunsAtEvenSpeedAlongItsTangent) {
  for (const Segment& s : random_segments(2, 200)) {
    const double h = 1e-5;
    for (const double t : {0.1, 0.5, 0.8}) {
      const Vec2 speed = (s.point(t + h) - s.point(t - h)) / (2 * h);
      EXPECT_NEAR(norm(speed), s.length(), 1e-6 * s.length());
      EXPECT_NEAR(distance(normalized(speed), s.tangent(t)), 0, 1e-6);
    }
  }
}

TEST(Segment, BulgeAndReversalAreInverses) {
  for (const Segment& s : random_segments(3, 200)) {
    const Segment again = Segment::from_bulge(s.a, s.b, s.bulge());
    EXPECT_NEAR(again.sweep, s.sweep, 1e-12);
    const Segment back = s.reversed();
    EXPECT_EQ(back.a, s.b);
    EXPECT_NEAR(distance(back.point(0.3), s.point(0.7)), 0, 1e-9);
    EXPECT_DOUBLE_EQ(back.curvature(), -s.curvature());
  }
}

TEST(Segment, PartsJoinUp) {
  for (const Segment& s : random_segments(4, 100)) {
    const Segment first = s.part(0, 0.4), second = s.part(0.4, 1);
    EXPECT_EQ(first.b, second.a);
    EXPECT_EQ(first.a, s.a);
    EXPECT_EQ(second.b, s.b);
    EXPECT_NEAR(first.length() + second.length(), s.length(), 1e-9);
    EXPECT_NEAR(distance(second.point(0.5), s.point(0.7)), 0, 1e-9);
  }
}

TEST(Segment, NearestPointIsNoFartherThanAnySample) {
  std::mt19937 random(5);
  for (const Segment& s : random_segments(5, 200)) {
    const Vec2 q{uniform(random, -30, 30), uniform(random, -30, 30)};
    double best = 1e300;
    for (int i = 0; i <= 2000; ++i) best = std::min(best, distance(q, s.point(i / 2000.0)));
    EXPECT_LE(s.distance_to(q), best + 1e-9);
    EXPECT_GE(s.distance_to(q), best - s.length() / 2000);
  }
}

TEST(Segment, BoundsHoldItTightly) {
  for (const Segment& s : random_segments(6, 200)) {
    const Bounds box = s.bounds();
    Vec2 low = s.a, high = s.a;
    for (int i = 0; i <= 2000; ++i) {
      const Vec2 p = s.point(i / 2000.0);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double sag = 1e-5 * (s.length() + 1);
    EXPECT_NEAR(distance(low, box.low), 0, sag);
    EXPECT_NEAR(distance(high, box.high), 0, sag);
  }
}

TEST(Segment, AlmostStraightArcsAreLines) {
  EXPECT_FALSE(Segment::from_bulge({0, 0}, {1, 0}, 1e-10).is_arc());
  EXPECT_TRUE(Segment::from_bulge({0, 0}, {100, 0}, 1e-7).is_arc());
}

TEST(Curve, CircleHasAreaAndLengthOfACircle) {
  const Curve c = circle({1e4, -1e4}, 7);
  EXPECT_NEAR(c.signed_area(), 49 * kPi, 1e-8);
  EXPECT_NEAR(c.length(), 14 * kPi, 1e-8);
  EXPECT_NEAR(c.reversed().signed_area(), -49 * kPi, 1e-8);
}

TEST(Curve, ReversedRunsTheSamePiecesBackwards) {
  Curve c({{{0, 0}, 0.3, true}, {{10, 0}, 0, false}, {{10, 10}, -0.5, true}, {{0, 10}, 0.1, false}},
          true);
  const Curve r = c.reversed();
  EXPECT_NEAR(r.signed_area(), -c.signed_area(), 1e-12);
  for (std::size_t i = 0; i < 4; ++i) {
    const Segment expected = c.segment(i).reversed();
    bool found = false;
    for (const Segment& s : r.segments())
      found = found || (s.a == expected.a && s.b == expected.b &&
                        std::abs(s.sweep - expected.sweep) < 1e-12 && s.open == expected.open);
    EXPECT_TRUE(found) << i;
  }
  const Curve open({{{0, 0}, 0.3, true}, {{10, 0}, 0, false}, {{10, 10}}}, false);
  EXPECT_NEAR(open.reversed().segment(1).sweep, -open.segment(0).sweep, 1e-12);
  EXPECT_TRUE(open.reversed().segment(1).open);
}

TEST(Curve, FlatteningStaysWithinItsTolerance) {
  std::mt19937 random(8);
  for (const auto& [name, region] : shapes::random_regions(8, 24)) {
    for (const double tolerance : {0.5, 0.01}) {
      const std::vector<Vec2> points = region.outer.flattened(tolerance);
      const BoundaryIndex index({region.outer});
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LT(index.nearest(points[i]).distance, 1e-9) << name;
        EXPECT_LE(index.nearest(0.5 * (points[i] + points[(i + 1) % points.size()])).distance,
                  tolerance * 1.000001)
            << name;
      }
    }
  }
  EXPECT_THROW(circle({0, 0}, 1).flattened(0), std::invalid_argument);
}

TEST(Curve, ContainsAgreesWithItsFlattening) {
  std::mt19937 random(9);
  for (const auto& [name, region] : shapes::random_regions(9, 40)) {
    const Curve flat = polygon(region.outer.flattened(1e-4));
    const BoundaryIndex index({region.outer});
    for (int i = 0; i < 200; ++i) {
      const Vec2 q{uniform(random, -45, 95), uniform(random, -45, 45)};
      if (index.nearest(q).distance > 1e-3) {
        EXPECT_EQ(region.outer.contains(q), flat.contains(q)) << name;
      }
    }
  }
}

TEST(Curve, ContainsIsNotFooledAtTheHeightOfVertices) {
  const Curve c = circle({0, 0}, 5);
  EXPECT_TRUE(c.contains({0, 0}));
  EXPECT_FALSE(c.contains({-6, 0}));
  EXPECT_FALSE(c.contains({6, 0}));
  const Curve diamond = polygon({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  EXPECT_TRUE(diamond.contains({0, 0}));
  EXPECT_FALSE(diamond.contains({-2, 0}));
  EXPECT_FALSE(diamond.contains({-2, 1}));
  EXPECT_FALSE(diamond.contains({-2, -1}));
}

TEST(Meetings, LieOnBothPiecesAndNoneIsMissed) {
  const std::vector<Segment> all = random_segments(10, 160);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Segment &a = all[i], &b = all[k];
      const Meetings met = meetings(a, b, 1e-9);
      for (const Meeting& m : met) {
        EXPECT_LT(distance(a.point(m.ta), m.p), 1e-7);
        EXPECT_LT(distance(b.point(m.tb), m.p), 1e-7);
      }
      // Count the sign changes of b's implicit form along a.
      const auto side = [&](Vec2 p) {
        return b.is_arc() ? distance(p, b.centre) - b.radius : cross(b.b - b.a, p - b.a);
      };
      std::size_t crossings = 0;
      const int n = 500;
      for (int j = 0; j < n; ++j) {
        const Vec2 p = a.point(static_cast<double>(j) / n), q = a.point((j + 1.0) / n);
        if ((side(p) > 0) == (side(q) > 0)) continue;
        const double reach = b.distance_to(0.5 * (p + q));
        const double t = b.nearest(0.5 * (p + q));
        if (reach < distance(p, q) && t > 0.01 && t < 0.99) ++crossings;
      }
      EXPECT_GE(met.count, std::min<std::size_t>(crossings, 2)) << i << " " << k;
    }
  }
}

TEST(Meetings, TangentPiecesTouchOnce) {
  const Segment line = Segment::line({-5, 3}, {5, 3});
  const Segment arc = Segment::arc({0, 0}, 3, 0, kPi);
  ASSERT_EQ(meetings(line, arc, 1e-9).count, 1u);
  EXPECT_NEAR(meetings(line, arc, 1e-9).at[0].p.x, 0, 1e-6);
  EXPECT_EQ(
      meetings(Segment::arc({0, 0}, 2, 0, kPi), Segment::arc({0, 5}, 3, kPi, kPi), 1e-9).count, 1u);
}

TEST(MakeRegion, SetsTheSenseOfRotation) {
  const Region r = make_region(rectangle(0, 0, 10, 10).reversed(), {rectangle(2, 2, 4, 4)});
  EXPECT_NEAR(r.outer.signed_area(), 100, 1e-12);
  EXPECT_NEAR(r.islands[0].signed_area(), -4, 1e-12);
  EXPECT_NEAR(r.area(), 96, 1e-12);
  EXPECT_TRUE(r.contains({1, 1}));
  EXPECT_FALSE(r.contains({3, 3}));
}

TEST(MakeRegion, DropsZeroLengthPiecesAndClosesTinyGaps) {
  const Region r =
      make_region(polygon({{0, 0}, {0, 0}, {5, 0}, {5, 5}, {5, 5 + 1e-8}, {0, 5}, {0, 0}}));
  EXPECT_EQ(r.outer.segment_count(), 4u);
  const Curve nearly({{{0, 0}}, {{5, 0}}, {{5, 5}}, {{1e-8, 1e-8}}}, false);
  EXPECT_EQ(make_region(nearly).outer.segment_count(), 3u);
}

// Why it is refused, and the numbers that come with that.
std::pair<Refusal, std::vector<double>> refusal_of(const Curve& outer,
                                                   const std::vector<Curve>& islands = {}) {
  try {
    make_region(outer, islands);
  } catch (const GeometryError& e) {
    return {e.refusal(), e.numbers()};
  }
  ADD_FAILURE() << "no error";
  return {Refusal::kHoleOutOfReach, {}};
}

GeometryErrorCode code_of(const Curve& outer, const std::vector<Curve>& islands = {}) {
  return code_of(refusal_of(outer, islands).first);
}

TEST(MakeRegion, NamesWhatIsWrong) {
  using enum GeometryErrorCode;
  EXPECT_EQ(code_of(polygon({{0, 0}, {std::nan(""), 0}, {1, 1}})), kNotFinite);
  EXPECT_EQ(code_of(Curve()), kTooFewPoints);
  EXPECT_EQ(code_of(polygon({{0, 0}, {1, 1}})), kTooFewPoints);
  EXPECT_EQ(code_of(polygon({{0, 0}, {1, 0}, {2, 0}})), kTooFewPoints);
  EXPECT_EQ(code_of(Curve({{{0, 0}}, {{5, 0}}, {{5, 5}}}, false)), kOpen);
  EXPECT_EQ(code_of(polygon({{0, 0}, {10, 10}, {10, 0}, {0, 9}})), kSelfCrossing);
  EXPECT_EQ(code_of(polygon({{0, 0}, {10, 0}, {5, 0}, {5, 5}})), kSelfCrossing);  // folds back
  EXPECT_EQ(code_of(polygon({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}})),
            kSelfCrossing);  // touches
  EXPECT_EQ(code_of(rectangle(0, 0, 10, 10), {rectangle(5, 5, 15, 8)}), kSelfCrossing);
  EXPECT_EQ(code_of(rectangle(0, 0, 10, 10), {rectangle(2, 2, 10, 8)}),
            kSelfCrossing);                                                    // shares a stretch
  EXPECT_EQ(code_of(circle({0, 0}, 10), {circle({5, 0}, 5)}), kSelfCrossing);  // touches inside
  EXPECT_EQ(code_of(rectangle(0, 0, 10, 10), {rectangle(2, 2, 5, 5), rectangle(4, 4, 8, 8)}),
            kSelfCrossing);
  EXPECT_EQ(code_of(rectangle(0, 0, 10, 10), {rectangle(12, 2, 15, 5)}), kIslandOutside);
  EXPECT_EQ(code_of(rectangle(0, 0, 10, 10), {rectangle(1, 1, 9, 9), rectangle(4, 4, 5, 5)}),
            kIslandOutside);
}

TEST(MakeRegion, NamesTheCurvesThatAreWrong) {
  using enum Refusal;
  using Told = std::pair<Refusal, std::vector<double>>;
  const Curve square = rectangle(0, 0, 20, 20), inside = rectangle(2, 2, 5, 5),
              infinite = polygon({{6, 6}, {std::nan(""), 0}, {7, 7}}),
              crossing = polygon({{6, 6}, {9, 9}, {9, 6}, {6, 8.5}}),
              flat = polygon({{6, 6}, {7, 7}}), open = Curve({{{6, 7}}, {{8, 7}}, {{8, 8}}}, false);
  EXPECT_EQ(refusal_of(infinite), Told(kCurveNotFinite, {0}));
  EXPECT_EQ(refusal_of(square, {inside, infinite}), Told(kCurveNotFinite, {2}));
  EXPECT_EQ(refusal_of(open), Told(kCurveNotClosed, {0, 6, 7}));
  EXPECT_EQ(refusal_of(square, {open}), Told(kCurveNotClosed, {1, 6, 7}));
  EXPECT_EQ(refusal_of(square, {inside, flat}), Told(kCurveWithoutArea, {2}));
  EXPECT_EQ(refusal_of(crossing), Told(kOutlineCrossesItself, {}));
  EXPECT_EQ(refusal_of(square, {inside, crossing}), Told(kIslandCrossesItself, {2}));
  EXPECT_EQ(refusal_of(square, {inside, rectangle(15, 5, 25, 8)}),
            Told(kOutlineCrossesIsland, {2}));
  EXPECT_EQ(refusal_of(square, {inside, rectangle(8, 8, 9, 9), rectangle(4, 4, 7, 7)}),
            Told(kIslandsCross, {1, 3}));
  EXPECT_EQ(refusal_of(square, {inside, rectangle(22, 2, 25, 5)}),
            Told(kIslandOutsideOutline, {2}));
  EXPECT_EQ(refusal_of(square, {inside, rectangle(3, 3, 4, 4)}),
            Told(kIslandInsideAnother, {2, 1}));
}

TEST(MakeRegion, SaysWhereTheOutlineCrossesItself) {
  try {
    make_region(polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10.0}, {-5, 5}}));
    FAIL();
  } catch (const GeometryError& e) {
    EXPECT_NEAR(distance(e.where(), {5, 5}), 0, 1e-9);
    EXPECT_STREQ(e.what(), "outline_crosses_itself at (5, 5)");
  }
}

TEST(MakeRegion, AcceptsAllPockets) { EXPECT_EQ(shapes::pockets().size(), 16u); }

TEST(MakeRegion, TakesTenThousandEdges) {
  std::mt19937 random(3);
  const Curve big = shapes::wavy_polygon(random, {0, 0}, 50, 10000);
  EXPECT_EQ(make_region(big).outer.segment_count(), 10000u);
}

TEST(BoundaryIndex, AgreesWithASearchOfAllPieces) {
  std::mt19937 random(11);
  for (const auto& [name, region] : shapes::random_regions(11, 40)) {
    const std::vector<Curve> curves = region.curves();
    const BoundaryIndex index(curves);
    for (int i = 0; i < 300; ++i) {
      const double reach = i % 10 == 0 ? 500 : 50;
      const Vec2 q{uniform(random, -reach, reach), uniform(random, -reach, reach)};
      double best = 1e300;
      for (const Curve& c : curves)
        for (const Segment& s : c.segments()) best = std::min(best, s.distance_to(q));
      const BoundaryIndex::Hit hit = index.nearest(q);
      EXPECT_NEAR(hit.distance, best, 1e-9) << name;
      EXPECT_NEAR(distance(q, hit.point), best, 1e-9);
      EXPECT_NEAR(distance(curves[hit.curve].segment(hit.segment).point(hit.t), hit.point), 0,
                  1e-9);
      EXPECT_NEAR(index.distance_below(q, 3), std::min(3.0, best), 1e-9);
      EXPECT_NEAR(index.distance_below(q, 1e6), best, 1e-9);
      EXPECT_EQ(index.distance_below(q, 0.5 * best), 0.5 * best);
      if (best > 1e-9) {
        EXPECT_EQ(index.contains(q), region.contains(q)) << name << " " << q.x << " " << q.y;
      }
    }
  }
}

TEST(BoundaryIndex, FindsTheEndsOfVeryFlatArcs) {
  const Curve flat({{{0, 0}, 2e-8}, {{1, 0}}}, false);
  ASSERT_TRUE(flat.segment(0).is_arc());
  const BoundaryIndex index({flat});
  EXPECT_NEAR(index.nearest({1.001, 0.5}).distance, std::hypot(0.001, 0.5), 1e-8);
  EXPECT_NEAR(index.nearest({-0.03, 0}).distance, 0.03, 1e-8);
}

TEST(BoundaryIndex, KnowsItIsEmpty) {
  const BoundaryIndex index({});
  EXPECT_TRUE(index.empty());
  EXPECT_FALSE(index.contains({0, 0}));
  EXPECT_EQ(index.distance_below({0, 0}, 5), 5);
}

TEST(BoundaryIndex, AgreesWithASearchOfTenThousandPieces) {
  std::mt19937 random(12);
  const Curve big = shapes::wavy_polygon(random, {0, 0}, 50, 10000);
  const BoundaryIndex index({big});
  for (int i = 0; i < 300; ++i) {
    const Vec2 q{uniform(random, -60, 60), uniform(random, -60, 60)};
    double best = 1e300;
    for (const Segment& s : big.segments()) best = std::min(best, s.distance_to(q));
    EXPECT_NEAR(index.nearest(q).distance, best, 1e-9);
  }
}

}  // namespace
}  // namespace evenload
