// The simulator's load against closed forms: straight cuts, contours of constant curvature, slots.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "cutting/engagement.h"
#include "simulate/load_figures.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

// Largest distance from `expected` over the middle of the path, degrees.
double worst_error(const Simulation& run, double expected, double from_share = 0.3,
                   double to_share = 0.9) {
  const LoadRecord& record = run.record;
  double worst = 0;
  const double from = from_share * run.figures.time, to = to_share * run.figures.time;
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (record.time[i] < from || record.time[i] > to) continue;
    if (static_cast<MoveKind>(record.kind[i]) != MoveKind::kCut) continue;
    ++looked_at;
    worst = std::max(worst, std::abs(record.engagement[i] - expected) / kDegree);
  }
  EXPECT_GT(looked_at, 20u);
  return worst;
}

TEST(StraightCut, HasTheEngagementOfItsSideStepInEveryDirection) {
  for (int degrees = 10; degrees <= 170; degrees += 20) {
    const double theta = degrees * kDegree, radius = 3;
    for (const double turn : {0.0, 17.0, 45.0, 90.0, 133.7, 270.0}) {
      // The stock's edge is the line y = 0; the tool runs along it, `step` mm deep in it.
      const double y = radius - side_step(theta, radius);
      const Simulation run =
          cut_along({{-20, y}, {20, y}}, rectangle(-60, -60, 60, 0), turn * kDegree, radius);
      EXPECT_LE(worst_error(run, theta), 0.2) << degrees << " degrees, turned by " << turn;
    }
  }
}

TEST(Contour, HasTheEngagementOfThesisOne) {
  const double radius = 3;
  for (const double rho : {4.0, 5.0, 8.0, 20.0, 100.0}) {
    for (const double theta : {30 * kDegree, 60 * kDegree, 90 * kDegree}) {
      for (const Contour contour : {Contour::kConcave, Contour::kConvex}) {
        const double step = side_step_on_contour(theta, radius, rho, contour);
        // Round a disc so small, the tool would meet its own cut again.
        if (contour == Contour::kConvex && rho - step < 0) continue;
        const Simulation run = contour == Contour::kConcave
                                   ? cut_inside_circle(rho, rho + step - radius, radius)
                                   : cut_outside_circle(rho, rho - step + radius, radius);
        EXPECT_LE(worst_error(run, theta), 0.3)
            << "rho " << rho << ", theta " << theta / kDegree << ", "
            << (contour == Contour::kConcave ? "concave" : "convex");
      }
    }
  }
}

TEST(Slot, TouchesTheWholeLeadingHalf) {
  const Simulation run = cut_along({{-20, 0}, {20, 0}}, rectangle(-60, -60, 60, 60), 0, 3);
  EXPECT_LE(worst_error(run, kPi), 0.01);
}

TEST(TwoSidedContact, IsToldFromASlot) {
  // A wall of material on either side of a slot that is 1 mm narrower than the tool.
  const double half = 2.5;
  Simulation run = cut_through({{-20, 0}, {20, 0}},
                               {rectangle(-60, half, 60, 60), rectangle(-60, -60, 60, -half)}, 3);
  const LoadRecord& record = run.record;
  const std::size_t i = record.size() / 2;
  ASSERT_EQ(record.first_arc[i + 1] - record.first_arc[i], 2u);
  const double theta = std::acos(half / 3);
  EXPECT_NEAR(record.arcs[record.first_arc[i]].low, -kPi / 2, 1e-9);
  EXPECT_NEAR(record.arcs[record.first_arc[i]].high, -kPi / 2 + theta, 0.2 * kDegree);
  EXPECT_NEAR(record.arcs[record.first_arc[i] + 1].low, kPi / 2 - theta, 0.2 * kDegree);
  EXPECT_NEAR(record.arcs[record.first_arc[i] + 1].high, kPi / 2, 1e-9);
}

TEST(RemovalRate, IsAreaRateTimesDepthTimesFeed) {
  for (const double turn : {0.0, 30.0, 90.0}) {
    const Simulation run =
        cut_along({{-20, 1.5}, {20, 1.5}}, rectangle(-60, -60, 60, 0), turn * kDegree, 3);
    const LoadRecord& record = run.record;
    const double expected = 1.5 * kDepth * kFeed;
    for (std::size_t i = record.size() / 3; i < record.size() * 9 / 10; ++i)
      ASSERT_NEAR(record.removal_rate[i], expected, 0.005 * expected) << i << " at " << turn;
    EXPECT_NEAR(run.figures.removal_rate.value, expected, 0.005 * expected);
  }
}

// The record of a cut along x with these engagements, in rad, at samples `apart` mm apart.
LoadRecord record_of(const std::vector<double>& engagements, double apart) {
  LoadRecord record;
  for (std::size_t i = 0; i < engagements.size(); ++i) {
    record.x.push_back(apart * static_cast<double>(i));
    record.length.push_back(i == 0 ? 0 : apart);
    for (auto* zeros : {&record.y, &record.z, &record.time, &record.removal_rate})
      zeros->push_back(0);
    record.kind.push_back(static_cast<std::int8_t>(MoveKind::kCut));
    record.engagement.push_back(engagements[i]);
  }
  return record;
}

TEST(WorstEngagement, IsTheMeanOverATenthWhereverSamplesLie) {
  LoadFigures figures;
  add_up_record(record_of({0, 1, 1, 0}, 0.08), figures);
  // 0.08 mm of the plateau, and 0.02 mm of a slope whose mean is 0.5.
  EXPECT_NEAR(figures.engagement.value, 0.9, 1e-12);
  EXPECT_NEAR(figures.engagement.at.x, 0.16, 1e-12);
  figures = {};
  add_up_record(record_of({0, 0, 1, 1, 1, 1, 0}, 0.03), figures);
  EXPECT_NEAR(figures.engagement.value, 0.09 / 0.1 + 0.01 / 0.1 * 0.5, 1e-12);
  figures = {};
  add_up_record(record_of({1, 1}, 0.25), figures);
  EXPECT_NEAR(figures.engagement.value, 1, 1e-12);
}

TEST(WorstEngagement, OfAPathShorterThanATenthIsThatOfOneThatGoesOnInTheAir) {
  LoadFigures figures;
  add_up_record(record_of({1, 1}, 0.05), figures);
  EXPECT_NEAR(figures.engagement.value, 0.5, 1e-12);
}

}  // namespace
}  // namespace evenload
