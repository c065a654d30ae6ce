// Inspection: exchange, bent steps, fits and the profile, on cases small enough to be known.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "inspection/bent_step.h"
#include "inspection/exchange.h"
#include "inspection/fit.h"
#include "inspection/rigid.h"

namespace evenload {
namespace {

// Values of three points on a parabola, to be met by a straight line.
Rows parabola() {
  Rows rows{Eigen::VectorXd(3), Columns(2, 3)};
  rows.values << 1, 0, 1;
  rows.gradients << -1, -1, -1, 1, 0, -1;
  return rows;
}

TEST(Exchange, MeetsAParabolaByTheLineOfEqualRipple) {
  const ExchangeStep found = best_linear_step(parabola(), true, 10, 1e-15);
  EXPECT_TRUE(found.is_solved);
  EXPECT_NEAR(found.level, 0.5, 1e-14);
  EXPECT_NEAR(found.step[0], 0.5, 1e-14);
  ASSERT_EQ(found.contacts.size(), 3U);
  double sum = 0;
  for (const Contact& each : found.contacts) {
    EXPECT_EQ(each.side, each.point == 1 ? -1 : 1);
    EXPECT_NEAR(each.multiplier, each.point == 1 ? 0.5 : 0.25, 1e-14);
    sum += each.multiplier;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
}

TEST(Exchange, SharesForcesAmongAllPointsThatCanPress) {
  Columns cross(2, 4);
  cross << 1, -1, 0, 0, 0, 0, 1, -1;
  const Eigen::VectorXd all = shared_multipliers(cross);
  EXPECT_GT(all.minCoeff(), 0.1);
  EXPECT_NEAR((cross * all).norm(), 0, 1e-12);
  // Nothing holds the third point.
  const Eigen::VectorXd two = shared_multipliers(cross.leftCols(3));
  EXPECT_NEAR(two[0], two[1], 1e-12);
  EXPECT_GT(two[0], 0.1);
  EXPECT_NEAR(two[2], 0, 1e-12);
  EXPECT_EQ(shared_multipliers(cross.col(0)).maxCoeff(), 0);
}

TEST(Exchange, StopsAtTheReach) {
  const ExchangeStep found = best_linear_step(parabola(), true, 0.1, 1e-15);
  EXPECT_TRUE(found.is_solved);
  EXPECT_NEAR(found.level, 0.9, 1e-14);
  EXPECT_NEAR(found.step[0], 0.1, 1e-14);
}

TEST(BentStep, BalancesTheBendWithFewerContacts) {
  // One contact: the step is -gradient / bend.
  Rows rows{Eigen::VectorXd::Constant(1, 1.0), Columns(2, 1)};
  rows.gradients << 0.5, 0;
  const Eigen::MatrixXd bends = 2 * Eigen::MatrixXd::Identity(2, 2);
  const ExchangeStep found = best_bent_step(rows, false, bends, 1e-15);
  EXPECT_TRUE(found.is_solved);
  EXPECT_NEAR(found.step[0], -0.25, 1e-14);
  EXPECT_NEAR(found.step[1], 0, 1e-14);
}

Points ring(double radius, int lobes, double height) {
  Points points(3, 72);
  for (int i = 0; i < 72; ++i) {
    const double turn = 2 * M_PI * i / 72, r = radius + height * std::cos(lobes * turn);
    points.col(i) << r * std::cos(turn), r * std::sin(turn), 0;
  }
  return points;
}

TEST(MinimumZone, OfALobedCircleIsTheLobes) {
  // Points at places where the lobes reach their full height, both ways.
  const FittedFeature found = fit(Kind::kCircle, Method::kMinimumZone, ring(20, 3, 0.01), false);
  EXPECT_NEAR(found.zone, 0.02, 1e-12);
  EXPECT_NEAR(found.radius, 20, 1e-12);
  EXPECT_TRUE(found.is_proved);
}

TEST(MinimumZone, OfPointsOnALineRefusesACircle) {
  Points points = Points::Zero(3, 5);
  for (int i = 0; i < 5; ++i) points(0, i) = i;
  EXPECT_THROW(fit(Kind::kCircle, Method::kMinimumZone, points, false), std::invalid_argument);
  EXPECT_NEAR(fit(Kind::kPlanarLine, Method::kMinimumZone, points, false).zone, 0, 1e-14);
}

TEST(Profile, OfAPlaneIsItsMinimumZone) {
  Points points(3, 5);
  points << 0, 1, 1, 0, 0.5, 0, 0, 1, 1, 0.5, 0.01, 0.02, 0.03, 0.02, 0.05;
  const Part plane = [](const Points& at, const Which&) {
    Feet feet{at, Points::Zero(3, at.cols())};
    feet.points.row(2).setZero();
    feet.normals.row(2).setOnes();
    return feet;
  };
  ProfileTask task;
  task.is_free = {true, true, true, true, true, true};
  const Profile found = profile(points, plane, task);
  const FittedFeature zone = fit(Kind::kPlane, Method::kMinimumZone, points, true);
  EXPECT_TRUE(found.is_proved);
  EXPECT_NEAR(found.width, zone.zone, 1e-14);
  task.is_free = {};
  EXPECT_NEAR(profile(points, plane, task).width, 0.1, 1e-15);
}

}  // namespace
}  // namespace evenload
