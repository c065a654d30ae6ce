// Faults of paths, put in where they are known.
#include "simulate/path_proof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "judge/numbers.h"

namespace evenload {
namespace {

const ProofTool kTool{2 * kRadius, 0};

Move rapid(double x, double y, double z) { return {MoveKind::kRapid, x, y, z, 0, 0, 0, 0}; }
Move cut(double x, double y, double z) { return {MoveKind::kCut, x, y, z, 0, 0, 0, 600}; }

// A block [0, 60] x [0, 40] with its top at z = 0.
HeightMap block() {
  return {{{0, 0, 0}, {60, 0, 0}, {60, 40, 0}, {0, 40, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

// The top edge of a wall along x = 50.
std::vector<Point3> wall() {
  std::vector<Point3> points;
  for (int k = 0; k <= 200; ++k) points.push_back({50, 0.2 * k, 0});
  return points;
}

// A groove at z = -2 from (10, 20) to (x, 20), entered by a slope.
std::vector<Move> groove(double x) {
  return {rapid(10, 20, 5), cut(10, 20, 0.1), cut(30, 20, -2),
          cut(10, 20, -2),  cut(x, 20, -2),   rapid(x, 20, 5)};
}

std::vector<Fault> of(const std::vector<Move>& moves,
                      const std::vector<EarlierPath>& earlier = {}) {
  return faults_of(moves, kTool, wall(), block(), earlier);
}

TEST(PathProof, FindsNothingInAPathThatKeepsOff) {
  EXPECT_TRUE(of(groove(47)).empty());
  EXPECT_TRUE(of({}).empty());
  EXPECT_TRUE(of({rapid(0, 0, 5)}).empty());
}

TEST(PathProof, MeasuresAGougeAndTellsItsPlaceAndMove) {
  for (const double depth : {0.02, 0.05, 0.5}) {
    const std::vector<Fault> faults = of(groove(47 + depth));
    ASSERT_EQ(faults.size(), 2u);  // there, and by the rapid up from there
    EXPECT_EQ(faults[0].kind, FaultKind::kGouge);
    EXPECT_EQ(faults[1].kind, FaultKind::kGouge);
    EXPECT_NEAR(faults[0].amount, depth, 1e-3);
    EXPECT_NEAR(faults[0].at.x, 50, 1e-9);
    EXPECT_NEAR(faults[0].at.y, 20, 0.2);
    EXPECT_EQ(faults[0].move, 4u);
  }
}

TEST(PathProof, SeesAGougeAlongAnArcAndOnASlope) {
  std::vector<Move> moves = groove(40);
  moves.back() = rapid(40, 30.1, 5);
  // A half circle about (40, 23) whose easternmost point is (43 + 4.1, 23).
  moves.insert(moves.end() - 1, cut(40, 15.9, -2));
  moves.insert(moves.end() - 1, Move{MoveKind::kCut, 40, 30.1, -2, kPi, 40, 23, 600});
  const std::vector<Fault> faults = of(moves);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].amount, 0.1, 2e-3);
  EXPECT_NEAR(faults[0].at.y, 23, 0.2);
  // Down along the wall: the tool is in it below the wall's top only.
  std::vector<Move> slope{rapid(48, 0, 5), cut(48, 0, 1), cut(48, 40, -1)};
  const std::vector<Fault> below = of(slope);
  ASSERT_FALSE(below.empty());
  EXPECT_NEAR(below[0].amount, 0.99, 0.03);
  EXPECT_GT(below[0].at.y, 20);
}

TEST(PathProof, ATipOnTopOfABodyIsNoGougeAndOneBelowItIsAsDeepAsThat) {
  EXPECT_TRUE(of({rapid(50, 20, 5), cut(50, 20, 0), cut(50, 30, 0), rapid(50, 30, 5)}).empty());
  const std::vector<Fault> faults =
      of({rapid(50, -20, 5), rapid(50, -20, -0.1), cut(50, 30, -0.1)});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].amount, 0.1, 1e-9);
}

TEST(PathProof, ARoundedCornerKeepsOffWhatASharpOneWouldCut) {
  // The wall's top is 0.2 mm over the tip and 0.2 mm within the tool's side.
  const std::vector<Move> moves{rapid(47.2, -20, 5), rapid(47.2, -20, -0.2), cut(47.2, 30, -0.2)};
  EXPECT_EQ(faults_of(moves, kTool, wall(), block(), {}).size(), 1u);
  EXPECT_TRUE(faults_of(moves, {2 * kRadius, 1}, wall(), block(), {}).empty());
}

TEST(PathProof, FindsARapidInMaterialAndNoneWhereItWasCut) {
  std::vector<Move> moves = groove(40);
  moves.insert(moves.end(), {rapid(20, 20, 5), rapid(20, 20, -2), rapid(20, 20, 5)});
  EXPECT_TRUE(of(moves).empty());
  moves.insert(moves.end(), {rapid(20, 24, 5), rapid(20, 24, -2), rapid(20, 24, 5)});
  const std::vector<Fault> faults = of(moves);
  ASSERT_EQ(faults.size(), 2u);  // down, and up again: a rapid cuts nothing
  EXPECT_EQ(faults[0].kind, FaultKind::kRapid);
  EXPECT_NEAR(faults[0].amount, 2, 1e-9);
  EXPECT_NEAR(faults[0].at.y, 24, 1e-9);
  EXPECT_EQ(faults[0].move, 10u);
}

TEST(PathProof, FindsAPlungeButNoRampAndNoneIntoAHole) {
  const std::vector<Move> moves{rapid(20, 20, 5), cut(20, 20, -2), rapid(20, 20, 5)};
  const std::vector<Fault> faults = of(moves);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].kind, FaultKind::kPlunge);
  EXPECT_NEAR(faults[0].amount, 2, 1e-9);
  const EarlierPath hole{{rapid(20, 20, 5), cut(20, 20, -3)}, {2 * kRadius + 0.1, 0}};
  EXPECT_TRUE(of(moves, {hole}).empty());
  const EarlierPath shallow{{rapid(20, 20, 5), cut(20, 20, -1)}, {2 * kRadius + 0.1, 0}};
  const std::vector<Fault> deeper = of(moves, {shallow});
  ASSERT_EQ(deeper.size(), 1u);
  EXPECT_NEAR(deeper[0].amount, 1, 1e-9);
}

TEST(PathProof, AnEarlierToolWithARoundCornerLeavesWhatIsUnderIt) {
  const std::vector<Move> moves{rapid(20, 20, 5), rapid(20, 20, -2)};
  const std::vector<Move> same{rapid(20, 20, 5), cut(20, 20, -2)};
  EXPECT_TRUE(of(moves, {{same, kTool}}).empty());
  const std::vector<Fault> faults = of(moves, {{same, {2 * kRadius, 1}}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].amount, 1, 1e-9);
}

TEST(PathProof, HasTheSameFaultsTurnedAndMoved) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle(0, 2 * kPi), shift(-500, 500);
  std::vector<Move> moves = groove(47.3);
  moves.insert(moves.end(), {rapid(20, 26, 5), cut(20, 26, -1), rapid(20, 26, 5)});
  const std::vector<Fault> home = of(moves);
  ASSERT_EQ(home.size(), 3u);
  for (int n = 0; n < 20; ++n) {
    const double turn = angle(random);
    const Vec2 by{shift(random), shift(random)};
    const auto place = [&](double x, double y) { return rotated({x, y}, turn) + by; };
    std::vector<Move> turned = moves;
    for (Move& m : turned) {
      const Vec2 p = place(m.x, m.y);
      m.x = p.x;
      m.y = p.y;
    }
    std::vector<Point3> bodies = wall();
    for (Point3& p : bodies) {
      const Vec2 q = place(p.x, p.y);
      p = {q.x, q.y, p.z};
    }
    std::vector<Point3> corners;
    for (const Vec2 p : {place(0, 0), place(60, 0), place(60, 40), place(0, 40)})
      corners.push_back({p.x, p.y, 0});
    const std::vector<Fault> faults =
        faults_of(turned, kTool, bodies, {corners, {{0, 1, 2}, {0, 2, 3}}}, {});
    ASSERT_EQ(faults.size(), home.size());
    for (std::size_t i = 0; i < faults.size(); ++i) {
      EXPECT_EQ(faults[i].kind, home[i].kind);
      EXPECT_EQ(faults[i].move, home[i].move);
      EXPECT_NEAR(faults[i].amount, home[i].amount, 1e-6);
    }
  }
}

TEST(PathProof, RefusesAToolWithoutDiameter) {
  EXPECT_THROW(faults_of(groove(40), {0, 0}, {}, block(), {}), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
