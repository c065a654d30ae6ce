#include <gtest/gtest.h>

#include <cmath>

#include "strategy/row_fit.h"

namespace evenload {
namespace {

constexpr double kRadius = 3;
constexpr double kTheta = kPi / 3;

RowLimits limits() { return {kTheta + 0.02, kTheta, kRadius, 0.4, 0.1, 1}; }

// Tangent arcs of 1 mm each along a front from which they turn a little to and fro; what they meet
// is what the model has it.
Row row(const std::vector<double>& curvatures) {
  Row made;
  RowPlace begin;
  PlanePoint here{{0, 0}, {1, 0}};
  made.from = here;
  for (const double curvature : curvatures) {
    for (int i = 0; i < 10; ++i) {
      const double on = (i + 0.5) / 10;
      RowLook look;
      look.along = begin.along + on;
      look.turned = begin.turned + curvature * on;
      look.aside = begin.aside + on * (begin.turned + 0.5 * curvature * on);
      look.met = kTheta - look.turned - look.aside / (kRadius * std::sin(kTheta));
      look.width = kRadius * (1 - std::cos(look.met));
      made.looks.push_back(look);
    }
    begin = {begin.along + 1, begin.turned + curvature, begin.aside + begin.turned + curvature / 2};
    made.joints.push_back(begin);
    const double chord = 2 / curvature * std::sin(curvature / 2);
    const double heading = angle_of(here.direction);
    here = {here.p + chord * unit(heading + curvature / 2), unit(heading + curvature)};
  }
  made.to = here;
  return made;
}

TEST(RowFit, LeadsOnFromTheRowInFewerTangentArcs) {
  for (const std::size_t count : {3u, 4u}) {
    const Row old =
        count == 4 ? row({0.01, -0.02, 0.02, -0.02, 0.01}) : row({0.01, -0.02, 0.02, -0.01});
    double unused = 0;
    const std::vector<Segment> moves = fit_row(old, count, limits(), &unused);
    ASSERT_EQ(moves.size(), count);
    EXPECT_LE(distance(moves.front().a, old.from.p), 1e-9);
    EXPECT_LE(distance(moves.back().b, old.to.p), 1e-9);
    EXPECT_LE(norm(moves.front().tangent(0) - old.from.direction), 1e-6);
    EXPECT_LE(norm(moves.back().tangent(1) - old.to.direction), 1e-6);
    for (std::size_t k = 1; k < count; ++k)
      EXPECT_LE(norm(moves[k - 1].tangent(1) - moves[k].tangent(0)), 1e-6);
    EXPECT_LT(unused, unused_area(old, limits().least_width));
  }
}

TEST(RowFit, FindsNothingGoodWhereTheLimitCannotBeKept) {
  const Row old = row({0.01, -0.02, 0.02, -0.01});
  RowLimits low = limits();
  low.most_met = kTheta - 0.1;
  double unused = 0;
  fit_row(old, 3, low, &unused);
  EXPECT_GT(unused, unused_area(old, low.least_width) + 10);
}

TEST(RowFit, KeepsToTheTightestTurn) {
  RowLimits wide = limits();
  wide.most_curvature = 0.01;
  double unused = 0;
  fit_row(row({0.3, -0.3, 0.3, -0.3}), 3, wide, &unused);
  double free = 0;
  fit_row(row({0.3, -0.3, 0.3, -0.3}), 3, limits(), &free);
  EXPECT_GT(unused, free);
}

TEST(RowFit, AnUnusedAreaIsWhatTheWidestPlaceOfAMoveCouldHaveHad) {
  Row two;
  two.joints = {{1, 0, 0}, {3, 0, 0}};
  const auto look = [&](double along, double width) {
    RowLook at;
    at.along = along;
    at.width = width;
    two.looks.push_back(at);
  };
  look(0.25, 1);
  look(0.75, 2);
  look(1.5, 0.5);
  look(2.5, 0.5);
  const double area = 1.5 + 1;
  EXPECT_NEAR(unused_area(two, 0.1), 1 * 2 + 2 * 0.5 - 1.3 * area, 1e-9);
  EXPECT_NEAR(unused_area(two, 1.5), 1 * 2 + 2 * 1.5 - 1.3 * area, 1e-9);
}

}  // namespace
}  // namespace evenload
