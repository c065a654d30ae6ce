#include "strategy/lame/lame_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/region.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

Curve polygon(int corners, double radius, double turn = 0, Vec2 centre = {}) {
  std::vector<Vertex> vertices;
  for (int i = 0; i < corners; ++i)
    vertices.push_back({centre + radius * unit(turn + 2 * kPi * i / corners)});
  return Curve(std::move(vertices), true);
}

Curve rectangle(double length, double width, double turn = 0, Vec2 centre = {}) {
  std::vector<Vertex> vertices;
  for (const Vec2 p : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}})
    vertices.push_back({centre + rotated({p.x * length / 2, p.y * width / 2}, turn)});
  return Curve(std::move(vertices), true);
}

double share_inside(const Curve& outline, double least_radius) {
  LameFitTask task;
  task.least_radius = least_radius;
  task.margin = 0;
  const std::optional<LameCurve> curve = fit_lame_curve(outline, task);
  return curve ? lame_area(*curve) / outline.signed_area() : 0;
}

// mm by which the curve keeps to its side of the outline, at the worst of many places.
double kept(const LameCurve& curve, const Curve& outline, LameSide side) {
  const BoundaryIndex index({outline});
  double least = 1e9;
  for (int i = 0; i < 5000; ++i) {
    const Vec2 p = lame_point(curve, 2 * kPi * i / 5000);
    const double away = index.nearest(p).distance;
    least = std::min(least, index.contains(p) == (side == LameSide::kInside) ? away : -away);
  }
  return least;
}

TEST(LameFit, FindsTheKnownBestCurvesOfPolygons) {
  EXPECT_NEAR(share_inside(polygon(3, 30, 0.3), 0.01), 0.77, 0.01);
  EXPECT_NEAR(share_inside(polygon(5, 30, 0.3), 0.01), 0.97, 0.01);
  EXPECT_NEAR(share_inside(polygon(6, 30, 0.3), 0.01), 0.97, 0.01);
  EXPECT_NEAR(share_inside(polygon(8, 30, 0.3), 0.01), 0.98, 0.01);
  EXPECT_GT(share_inside(rectangle(60, 40, 0.3), 0.01), 0.995);
}

TEST(LameFit, OfAnEllipseIsTheEllipse) {
  LameFitTask task;
  task.margin = 0;
  const std::optional<LameCurve> curve = fit_lame_curve(shapes::ellipse(30, 20), task);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->segments, 4);
  EXPECT_NEAR(std::max(curve->a, curve->b), 30, 0.02);
  EXPECT_NEAR(std::min(curve->a, curve->b), 20, 0.02);
  EXPECT_NEAR(curve->exponent, 1, 0.01);
  EXPECT_NEAR(norm(curve->centre), 0, 0.01);
}

std::vector<Vec2> corners_of(const Curve& outline) {
  std::vector<Vec2> points;
  for (const Vertex& v : outline.vertices()) points.push_back(v.p);
  return points;
}

// Its segments, and mm^2 inside it over those inside the outline.
std::pair<int, double> fitted_to(const Curve& outline, double least_radius) {
  LameFitTask task;
  task.least_radius = least_radius;
  const std::optional<LameCurve> curve = fit_lame_curve(outline, task);
  EXPECT_TRUE(curve);
  EXPECT_GE(kept(*curve, outline, LameSide::kInside), 0);
  EXPECT_GE(least_curvature_radius(*curve), 0.999 * least_radius);
  return {curve->segments, lame_area(*curve) / outline.signed_area()};
}

TEST(LameFit, FindsTheShapeOfOutlinesWithRoundedCorners) {
  for (const double radius : {2.0, 5.0, 8.0}) {
    const auto best = [&](const Curve& sharp) {
      return fitted_to(shapes::filleted(corners_of(sharp), radius), 0.01);
    };
    const std::vector<std::pair<Curve, int>> sharp = {{rectangle(60, 40, 0.3), 4},
                                                      {rectangle(40, 40, 0.3), 4},
                                                      {polygon(6, 30, 0.3), 6},
                                                      {polygon(8, 30, 0.3), 8}};
    for (const auto& [outline, segments] : sharp) {
      EXPECT_EQ(best(outline).first, segments) << radius;
      EXPECT_GT(best(outline).second, 0.96) << radius;
    }
    const Curve triangle = polygon(3, 40, 0.3);
    EXPECT_EQ(best(triangle).first, 3) << radius;
    EXPECT_GT(best(triangle).second, 0.77) << radius;
  }
}

TEST(LameFit, OfASlotTouchesItsSidesAndNearlyItsEnds) {
  const Curve slot = shapes::slot({5, 3}, 30, 15);
  LameFitTask task;
  task.margin = 0;
  const std::optional<LameCurve> curve = fit_lame_curve(slot, task);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->segments, 4);
  EXPECT_NEAR(std::max(curve->a, curve->b), 29.2, 0.8);
  EXPECT_NEAR(std::min(curve->a, curve->b), 15, 0.1);
  EXPECT_NEAR(distance(curve->centre, {5, 3}), 0, 0.02);
  EXPECT_GE(kept(*curve, slot, LameSide::kInside), 0);
  EXPECT_GT(lame_area(*curve), 0.93 * slot.signed_area());
}

TEST(LameFit, KeepsItsSideAndItsMargin) {
  std::mt19937 random(5);
  for (int i = 0; i < 30; ++i) {
    const Curve outline = i % 2 == 0
                              ? polygon(3 + i % 6, uniform(random, 10, 60), uniform(random, 0, 6))
                              : rectangle(uniform(random, 10, 60), uniform(random, 10, 60), 1);
    for (const LameSide side : {LameSide::kInside, LameSide::kAround}) {
      LameFitTask task;
      task.side = side;
      task.margin = 0.01;
      const std::optional<LameCurve> curve = fit_lame_curve(outline, task);
      ASSERT_TRUE(curve) << i;
      EXPECT_GE(kept(*curve, outline, side), 0.0095) << i;
      EXPECT_LE(kept(*curve, outline, side), 0.05) << i;
    }
  }
}

TEST(LameFit, TurnsAndShiftsWithItsOutline) {
  const Curve flat = rectangle(50, 30), turned = rectangle(50, 30, 0.7, {100, -20});
  const std::optional<LameCurve> a = fit_lame_curve(flat, {}), b = fit_lame_curve(turned, {});
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(distance(b->centre, rotated(a->centre, 0.7) + Vec2{100, -20}), 0, 0.02);
  EXPECT_NEAR(lame_area(*a), lame_area(*b), 1e-3 * lame_area(*a));
}

TEST(LameFit, HasNoTighterCornersThanItMay) {
  for (const double least : {1.0, 2.0, 6.0}) {
    LameFitTask task;
    task.least_radius = least;
    const std::optional<LameCurve> curve = fit_lame_curve(rectangle(60, 40), task);
    ASSERT_TRUE(curve);
    EXPECT_GE(least_curvature_radius(*curve), 0.999 * least);
    EXPECT_LE(least_curvature_radius(*curve), 1.003 * least);  // no more is given away
  }
}

TEST(LameFit, KeepsWhatIsWished) {
  LameFitTask task;
  task.wishes.centre = Vec2{2, 1};
  task.wishes.segments = 4;
  task.wishes.semi_axis_a = 20;
  task.wishes.exponent = 0.5;
  task.wishes.rotation = 0.1;
  const std::optional<LameCurve> curve = fit_lame_curve(rectangle(60, 40), task);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->centre, (Vec2{2, 1}));
  EXPECT_EQ(curve->segments, 4);
  EXPECT_EQ(curve->a, 20);
  EXPECT_EQ(curve->exponent, 0.5);
  EXPECT_EQ(curve->rotation, 0.1);
  EXPECT_GE(kept(*curve, rectangle(60, 40), LameSide::kInside), 0);
  task.wishes.segments = 6;  // with as many segments both semi-axes are one
  const std::optional<LameCurve> even = fit_lame_curve(rectangle(60, 60), task);
  ASSERT_TRUE(even);
  EXPECT_EQ(even->a, 20);
  EXPECT_EQ(even->b, 20);
}

TEST(LameFit, HasTheSegmentsThatAreWished) {
  for (int segments = 3; segments <= 12; ++segments) {
    LameFitTask task;
    task.wishes.segments = segments;
    for (const Curve& outline : {polygon(segments, 30, 0.3), polygon(4, 30)}) {
      const std::optional<LameCurve> curve = fit_lame_curve(outline, task);
      ASSERT_TRUE(curve) << segments;
      EXPECT_EQ(curve->segments, segments);
      EXPECT_GE(kept(*curve, outline, LameSide::kInside), 0) << segments;
    }
  }
}

TEST(LameFit, FindsNothingWhereWishesDoNotFit) {
  LameFitTask task;
  task.wishes.semi_axis_a = 31;
  task.wishes.rotation = 0;
  EXPECT_FALSE(fit_lame_curve(rectangle(60, 40), task));
  task.wishes = {};
  task.wishes.centre = Vec2{100, 0};
  EXPECT_FALSE(fit_lame_curve(rectangle(60, 40), task));
  task.wishes.exponent = 7;
  EXPECT_THROW(fit_lame_curve(rectangle(60, 40), task), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
