#include "geometry/arc_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "geometry/boundary_index.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

std::vector<Vec2> sampled(int n, const std::function<Vec2(double)>& at) {
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) points.push_back(at(static_cast<double>(i) / n));
  return points;
}

// All that must hold of any fit.
void check_fit(const std::vector<Vec2>& points, double tolerance, const std::string& name) {
  SCOPED_TRACE(name + ", tolerance " + std::to_string(tolerance));
  const Curve chain = fit_arcs(points, tolerance);
  EXPECT_FALSE(chain.closed());
  EXPECT_EQ(chain.vertices().front().p, points.front());
  EXPECT_EQ(chain.vertices().back().p, points.back());
  EXPECT_LE(chain.vertices().size(), points.size());
  std::vector<Vertex> vertices;
  for (const Vec2 p : points) vertices.push_back({p});
  const BoundaryIndex of_chain({chain}), of_points({Curve(vertices, false)});
  double worst = 0, worst_back = 0;
  for (const Vec2 p : points) worst = std::max(worst, of_chain.nearest(p).distance);
  for (std::size_t i = 1; i < points.size(); ++i)
    worst = std::max(worst, of_chain.nearest(0.5 * (points[i - 1] + points[i])).distance);
  for (const Segment& s : chain.segments()) {
    EXPECT_LE(std::abs(s.sweep), kPi + 1e-9);
    for (int i = 0; i <= 50; ++i)
      worst_back = std::max(worst_back, of_points.nearest(s.point(i / 50.0)).distance);
  }
  EXPECT_LE(worst, tolerance);
  EXPECT_LE(worst_back, tolerance);
  std::size_t next = 0;
  for (const Vertex& v : chain.vertices()) {
    while (next < points.size() && points[next] != v.p) ++next;
    EXPECT_LT(next, points.size()) << "a vertex that is none of the points, or out of order";
  }
}

TEST(FitArcs, MakesOneLineOfPointsInLine) {
  const Curve c = fit_arcs(sampled(100, [](double t) { return Vec2{10 * t, 5 * t}; }), 0.01);
  ASSERT_EQ(c.segment_count(), 1u);
  EXPECT_FALSE(c.segment(0).is_arc());
}

TEST(FitArcs, MakesOneArcOfPointsOnAnArc) {
  const Curve c = fit_arcs(sampled(200, [](double t) { return 10 * unit(1 + 2 * t); }), 1e-3);
  ASSERT_EQ(c.segment_count(), 1u);
  EXPECT_NEAR(c.segment(0).radius, 10, 2e-3);
  EXPECT_NEAR(c.segment(0).sweep, 2, 1e-3);
  const Curve clockwise =
      fit_arcs(sampled(200, [](double t) { return 10 * unit(1 - 2 * t); }), 1e-3);
  ASSERT_EQ(clockwise.segment_count(), 1u);
  EXPECT_NEAR(clockwise.segment(0).sweep, -2, 1e-3);
}

TEST(FitArcs, FindsTheJointOfALineAndAnArc) {
  std::vector<Vec2> points = sampled(50, [](double t) { return Vec2{-20 + 20 * t, -5}; });
  for (const Vec2 p : sampled(100, [](double t) { return 5 * unit(-kPi / 2 + 1.5 * t); }))
    points.push_back(p);
  const Curve c = fit_arcs(points, 1e-3);
  EXPECT_LE(c.segment_count(), 3u);
  check_fit(points, 1e-3, "line and arc");
}

TEST(FitArcs, GoesRoundFullCirclesAndSpirals) {
  for (const double turns : {1.0, 3.0}) {
    const std::vector<Vec2> points = sampled(
        static_cast<int>(turns * 400), [&](double t) { return 8 * unit(2 * kPi * turns * t); });
    const Curve c = fit_arcs(points, 1e-3);
    EXPECT_NEAR(c.length(), turns * 16 * kPi, 0.01);
    check_fit(points, 1e-3, "circles");
  }
  for (const double tolerance : {0.1, 0.01, 1e-3}) {
    const std::vector<Vec2> spiral =
        sampled(5000, [](double t) { return (2 + 20 * t) * unit(40 * t); });
    check_fit(spiral, tolerance, "spiral");
    EXPECT_LT(fit_arcs(spiral, tolerance).segment_count(), 300u);
  }
}

TEST(FitArcs, NeedsFewPiecesForSmoothCurves) {
  const std::vector<Vec2> ellipse = sampled(4000, [](double t) {
    return Vec2{30 * std::cos(6 * t), 12 * std::sin(6 * t)};
  });
  EXPECT_LE(fit_arcs(ellipse, 0.01).segment_count(), 24u);
  check_fit(ellipse, 0.01, "ellipse");
}

TEST(FitArcs, JoinsPiecesOfASmoothCurveNearlyWithoutKinks) {
  const std::vector<Vec2> wave = sampled(3000, [](double t) {
    return Vec2{60 * t, 5 * std::sin(12 * t)};
  });
  const Curve c = fit_arcs(wave, 0.01);
  for (std::size_t i = 1; i < c.segment_count(); ++i) {
    const Vec2 u = c.segment(i - 1).tangent(1), v = c.segment(i).tangent(0);
    EXPECT_LT(std::abs(std::atan2(cross(u, v), dot(u, v))), 0.1);
  }
}

TEST(FitArcs, KeepsCorners) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
  const Curve c = fit_arcs(square, 0.01);
  EXPECT_EQ(c.segment_count(), 4u);
  check_fit(square, 0.01, "square");
}

TEST(FitArcs, LawsHoldForRandomChains) {
  for (unsigned seed = 70; seed < 170; ++seed) {
    std::mt19937 random(seed);
    std::vector<Vec2> points{{uniform(random, -1e3, 1e3), 0}};
    const double step = std::pow(10, uniform(random, -3, 0)),
                 bend = std::pow(10, uniform(random, -3, 0.5));
    const double noise = seed % 3 == 0 ? std::pow(10, uniform(random, -5, -1)) : 0;
    double heading = 0, curvature = 0;
    for (int i = 0; i < 1500; ++i) {
      if (i % 100 == 0) curvature = bend * uniform(random, -1, 1);
      if (i % 300 == 299) heading += uniform(random, -3, 3);
      heading += step * curvature;
      points.push_back(points.back() + step * unit(heading) +
                       noise * Vec2{uniform(random, -1, 1), uniform(random, -1, 1)});
      if (random() % 50 == 0) points.push_back(points.back());
    }
    for (const double tolerance : {1e-4, 1e-2, 0.3})
      check_fit(points, tolerance, "chain of seed " + std::to_string(seed));
  }
}

TEST(FitArcs, LawsHoldForOutlinesOfRegions) {
  for (const shapes::Named& n : shapes::random_regions(71, 40))
    for (const double tolerance : {0.1, 0.005}) {
      std::vector<Vec2> points = n.region.outer.flattened(0.2 * tolerance);
      points.push_back(points[0]);
      check_fit(points, tolerance, n.name);
    }
}

TEST(FitArcs, TakesHardPoints) {
  check_fit({{0, 0}, {0, 0}}, 0.01, "one point twice");
  check_fit({{0, 0}, {1, 0}}, 0.01, "two points");
  check_fit({{0, 0}, {1, 0}, {0, 0}}, 0.01, "there and back");
  check_fit({{0, 0}, {1, 0}, {0.5, 0}, {2, 0}}, 0.01, "back on itself");
  check_fit({{0, 0}, {1e-9, 0}, {0, 1e-9}, {1, 1}}, 0.01, "tiny steps");
  EXPECT_THROW(fit_arcs({{0, 0}}, 0.01), std::invalid_argument);
  EXPECT_THROW(fit_arcs({{0, 0}, {1, 1}}, 0), std::invalid_argument);
}

TEST(FitArcs, TakesAHundredThousandPoints) {
  check_fit(sampled(100000, [](double t) { return (2 + 40 * t) * unit(100 * t); }), 0.01, "spiral");
}

}  // namespace
}  // namespace evenload
