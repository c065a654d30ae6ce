// What tools with rounded ends sweep, against a search along the piece that knows no closed form.
#include "simulate/swept_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "judge/numbers.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

const Cutter kCutters[] = {{5, 5}, {5, 1.5}, {5, 0}};  // ball, bull nose, flat

double lowest_of(const Cutter& cutter, const CutterRun& run, Vec2 at, int samples) {
  double lowest = HUGE_VAL;
  for (int k = 0; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples, d = distance(run.path.point(t), at);
    if (d <= cutter.radius)
      lowest = std::min(lowest, run.z0 + t * (run.z1 - run.z0) + cutter.rise(d));
  }
  return lowest;
}

TEST(SweptCutter, OverALineItIsAsLowAsTheLowestPlaceOfTheTool) {
  std::mt19937 random(5);
  int reached = 0;
  for (int round = 0; round < 600; ++round) {
    const auto any = [&random](double most) { return uniform(random, -most, most); };
    const Vec2 a{any(6), any(6)}, b{any(6), any(6)}, at{any(6), any(6)};
    const CutterRun run{Segment::line(a, b), any(4), any(4), 0, distance(a, b), 0, 0, 1};
    for (const Cutter& cutter : kCutters) {
      const double found = underside(cutter, run, at).z;
      const double searched = lowest_of(cutter, run, at, 20000);
      if (searched == HUGE_VAL) continue;  // the search may miss what is hardly reached
      EXPECT_LE(found, searched + 1e-12);
      // A sample may lie half a step beside the lowest place, where rims end at a steep slope.
      if (cutter.corner == cutter.radius) {
        EXPECT_NEAR(found, searched, 0.02);
      }
      if (lowest_of(cutter, run, at, 40000) - searched > -1e-9) {
        EXPECT_NEAR(found, searched, 1e-2);
        ++reached;
      }
    }
  }
  EXPECT_GT(reached, 300);
}

TEST(SweptCutter, TheLowestPlaceIsWhereItSaysItIs) {
  std::mt19937 random(6);
  for (int round = 0; round < 300; ++round) {
    const auto any = [&random](double most) { return uniform(random, -most, most); };
    const Vec2 a{any(6), any(6)}, b{any(6), any(6)}, at{any(6), any(6)};
    const CutterRun run{Segment::line(a, b), any(4), any(4), 0, 10, 0, 0, 1};
    for (const Cutter& cutter : kCutters) {
      const Underside found = underside(cutter, run, at);
      if (found.z == HUGE_VAL) continue;
      const double t = found.along / run.length;
      const double d = std::min(cutter.radius, distance(run.path.point(t), at));
      EXPECT_NEAR(found.z, run.z0 + t * (run.z1 - run.z0) + cutter.rise(d), 1e-9);
    }
  }
}

TEST(SweptCutter, ABallThatClimbsTouchesBehindItsAxis) {
  const Cutter ball{5, 5};
  const CutterRun run{Segment::line({-20, 0}, {20, 0}), -20, 20, 0, 40 * std::sqrt(2.0), 0, 0, 1};
  // The centre runs at z = x + 5; a distance of 5 below that line is 5 sqrt 2 straight down.
  EXPECT_NEAR(underside(ball, run, {0, 0}).z, 5 - 5 * std::sqrt(2.0), 1e-12);
  // Beside the line the cylinder that is swept rises.
  EXPECT_NEAR(underside(ball, run, {0, 3}).z, 5 - 4 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(underside(ball, run, {0, 5.001}).z, HUGE_VAL);
}

TEST(SweptCutter, AnUprightMoveLeavesTheToolAtItsLowerEnd) {
  const CutterRun down{Segment::line({1, 1}, {1, 1}), 9, 2, 0, 7, 0, 0, 1};
  EXPECT_NEAR(underside({5, 5}, down, {4, 1}).z, 2 + 1, 1e-12);
  const CutterRun up{Segment::line({1, 1}, {1, 1}), 2, 9, 0, 7, 0, 0, 1};
  EXPECT_NEAR(underside({5, 5}, up, {4, 1}).z, 2 + 1, 1e-12);
}

TEST(SweptCutter, ALevelArcIsFollowedExactlyAndAHelixWithinItsSagitta) {
  const Cutter ball{5, 5};
  const std::vector<Move> level{move_to(MoveKind::kRapid, 20, 0, 1),
                                arc_to({-20, 0}, {0, 0}, kPi, 1)};
  double lowest = HUGE_VAL;
  for (const CutterRun& run : cutter_runs(level, 0))
    lowest = std::min(lowest, underside(ball, run, {0, 17}).z);
  EXPECT_NEAR(lowest, 1 + ball.rise(3), 1e-12);

  std::mt19937 random(8);
  const std::vector<Move> helix{move_to(MoveKind::kRapid, 6, 0, 3),
                                arc_to({-6, 0}, {0, 0}, kPi, 1)};
  const std::vector<CutterRun> runs = cutter_runs(helix, 0);
  EXPECT_NEAR(runs.back().begin + runs.back().length, std::hypot(6 * kPi, 2), 1e-3);
  for (int round = 0; round < 40; ++round) {
    const Vec2 at{uniform(random, -8, 8), uniform(random, 0, 8)};
    double found = HUGE_VAL, searched = HUGE_VAL;
    for (const CutterRun& run : runs) found = std::min(found, underside(ball, run, at).z);
    for (int k = 0; k <= 100000; ++k) {
      const double t = k / 100000., d = distance(6 * unit(t * kPi), at);
      if (d <= 4.5) searched = std::min(searched, 3 - 2 * t + ball.rise(d));
    }
    if (searched == HUGE_VAL) continue;
    EXPECT_NEAR(found, searched, 3 * kSagitta);  // times the slope of the ball there
  }
}

TEST(SweptCutter, TeethStandAPitchApartOverAllMoves) {
  const Cutter ball{5, 5};
  std::vector<Move> moves{move_to(MoveKind::kRapid, 0, 0, 0)};
  for (const double x : {0.07, 1.0, 1.9, 4.0}) {
    moves.push_back(move_to(MoveKind::kCut, x, 0, 0));
    moves.back().feed = 300;
  }
  const std::vector<CutterRun> runs = cutter_runs(moves, 300 / 0.25);  // a tooth in each quarter
  for (double x = 0.3; x < 3.5; x += 0.037) {
    double found = HUGE_VAL, expected = HUGE_VAL;
    for (const CutterRun& run : runs) found = std::min(found, underside(ball, run, {x, 1}).z);
    for (int k = 0; k <= 16; ++k)
      expected = std::min(expected, ball.rise(std::hypot(x - 0.25 * k, 1)));
    EXPECT_NEAR(found, expected, 1e-12) << x;
  }
}

}  // namespace
}  // namespace evenload
