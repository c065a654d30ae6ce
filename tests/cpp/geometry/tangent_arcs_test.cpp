#include "geometry/tangent_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

constexpr double kEnd = 4 * kPi;

// Twice round an ellipse.
PlanePoint on_ellipse(double u) {
  return {{15 * std::cos(u), 6 * std::sin(u)},
          normalized(Vec2{-15 * std::sin(u), 6 * std::cos(u)})};
}

double distance_to(const std::vector<Segment>& moves, Vec2 p) {
  double least = 1e9;
  for (const Segment& move : moves) least = std::min(least, move.distance_to(p));
  return least;
}

TEST(TangentArcs, StayWithinTheToleranceOfTheCurve) {
  for (const double tolerance : {0.0005, 0.004, 0.05}) {
    const TangentArcs arcs = tangent_arcs(on_ellipse, kEnd, kPi / 3, tolerance);
    for (double u = 0; u <= kEnd; u += 0.01)
      EXPECT_LE(distance_to(arcs.moves, on_ellipse(u).p), tolerance) << u;
  }
}

TEST(TangentArcs, AreTangentToEachOtherAndBeginAndEndAsTheCurveDoes) {
  const std::vector<Segment> moves = tangent_arcs(on_ellipse, 5, kPi / 3, 0.004).moves;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    EXPECT_LE(distance(moves[i - 1].b, moves[i].a), 1e-9);
    EXPECT_LE(norm(moves[i - 1].tangent(1) - moves[i].tangent(0)), 1e-6);
  }
  EXPECT_LE(distance(moves.front().a, on_ellipse(0).p), 1e-9);
  EXPECT_LE(distance(moves.back().b, on_ellipse(5).p), 1e-9);
  EXPECT_LE(norm(moves.front().tangent(0) - on_ellipse(0).direction), 1e-6);
  EXPECT_LE(norm(moves.back().tangent(1) - on_ellipse(5).direction), 1e-6);
}

TEST(TangentArcs, EndWhereTheirParametersTell) {
  const TangentArcs arcs = tangent_arcs(on_ellipse, kEnd, kPi / 3, 0.004);
  ASSERT_EQ(arcs.moves.size(), arcs.until.size());
  for (std::size_t i = 0; i < arcs.moves.size(); ++i)
    EXPECT_LE(distance(arcs.moves[i].b, on_ellipse(arcs.until[i]).p), 0.1);
}

TEST(TangentArcs, AreFewerThanPairsThatBeginAndEndOnTheCurve) {
  // A pair that does leaves a curve whose curvature changes by c by c length^3 / 40.
  double pairs = 0;
  for (double u = 0; u < kEnd; u += 1e-3) {
    const PlanePoint a = on_ellipse(u), b = on_ellipse(u + 1e-3), c = on_ellipse(u + 2e-3);
    const double first = cross(a.direction, b.direction) / distance(a.p, b.p);
    const double second = cross(b.direction, c.direction) / distance(b.p, c.p);
    const double change = std::abs(second - first) / distance(a.p, b.p);
    pairs += std::cbrt(change / (40 * 0.004)) * distance(a.p, b.p);
  }
  const TangentArcs arcs = tangent_arcs(on_ellipse, kEnd, kPi / 3, 0.004);
  EXPECT_LE(static_cast<double>(arcs.moves.size()), 0.95 * pairs);
}

TEST(TangentArcs, AreHardlyMoreThanTheCurveDemands) {
  double demanded = 0;
  for (double u = 0; u < kEnd; u += 1e-3) {
    const PlanePoint a = on_ellipse(u), b = on_ellipse(u + 1e-3), c = on_ellipse(u + 2e-3);
    const double first = cross(a.direction, b.direction) / distance(a.p, b.p);
    const double second = cross(b.direction, c.direction) / distance(b.p, c.p);
    const double change = std::abs(second - first) / distance(a.p, b.p);
    demanded += arcs_per_mm(change, 0.004) * distance(a.p, b.p);
  }
  const TangentArcs arcs = tangent_arcs(on_ellipse, kEnd, kPi / 3, 0.004);
  EXPECT_LE(static_cast<double>(arcs.moves.size()), 1.4 * demanded);
}

// From a corner straight on, and with corners at both ends.
TEST(TangentArcs, KeepToCurvesThatBeginAndEndWhereTheyTurnMost) {
  const auto place = [](double u) { return on_ellipse(u + 0.01 * std::sin(40 * u)); };
  for (const double end : {0.3, kPi, kEnd}) {
    const TangentArcs arcs = tangent_arcs(place, end, kPi / 3, 0.002);
    for (double u = 0; u <= end; u += 0.003)
      EXPECT_LE(distance_to(arcs.moves, place(u).p), 0.0021) << u;
  }
}

// A curve of lines and arcs: its curvature jumps.
TEST(TangentArcs, KeepToCurvesWhoseCurvatureJumps) {
  const auto stadium = [](double u) -> PlanePoint {
    if (u < 10) return {{u, 0}, {1, 0}};
    if (u > 10 + 4 * kPi) return {{10 - (u - 10 - 4 * kPi), 8}, {-1, 0}};
    const double angle = (u - 10) / 4 - kPi / 2;
    return {Vec2{10, 4} + 4 * unit(angle), left_normal(unit(angle))};
  };
  const double end = 20 + 4 * kPi;
  const TangentArcs arcs = tangent_arcs(stadium, end, 10, 0.004);
  for (double u = 0; u <= end; u += 0.01)
    EXPECT_LE(distance_to(arcs.moves, stadium(u).p), 0.0045) << u;
  EXPECT_LE(arcs.moves.size(), 30u);
  for (std::size_t i = 1; i < arcs.moves.size(); ++i)
    EXPECT_LE(norm(arcs.moves[i - 1].tangent(1) - arcs.moves[i].tangent(0)), 1e-6);
}

TEST(TangentArcs, SpanNoMoreThanAsked) {
  const auto on_circle = [](double u) -> PlanePoint { return {5 * unit(u), left_normal(unit(u))}; };
  const TangentArcs arcs = tangent_arcs(on_circle, 2 * kPi, kPi / 3, 0.01);
  EXPECT_GE(arcs.moves.size(), 6u);
  for (const Segment& move : arcs.moves) EXPECT_NEAR(move.radius, 5, 1e-6);
}

}  // namespace
}  // namespace evenload
