// Whole finishing paths by each pattern over a waved ground: what the sanitizers see of them, and
// laws that all patterns keep.
#include "surface/finish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "surface/contours.h"
#include "surface/contours_by_cusp.h"
#include "surface/drop.h"
#include "surface/waypoint.h"

namespace evenload {
namespace {

constexpr int kCells = 24;
constexpr double kSize = 48;  // mm
constexpr double kLowest = -100;

// A square about the origin whose height is a wave, its upper side in triangles.
FacetMesh waves() {
  std::vector<SpacePoint> points;
  std::vector<FacetMesh::Triangle> triangles;
  const auto number = [](int i, int k) { return static_cast<std::uint32_t>(i * (kCells + 1) + k); };
  for (int i = 0; i <= kCells; ++i)
    for (int k = 0; k <= kCells; ++k) {
      const double x = kSize * i / kCells - kSize / 2, y = kSize * k / kCells - kSize / 2;
      points.push_back({x, y, 3 * std::sin(0.2 * x) * std::cos(0.15 * y)});
    }
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells; ++k) {
      triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
      triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
    }
  const std::vector<bool> picked(triangles.size(), true);
  return FacetMesh(points, triangles, picked);
}

FinishParams params_of(Pattern pattern) {
  FinishParams params;
  params.cutter = {3, 3};
  params.pattern = pattern;
  params.stepover = 3;
  params.tolerance = 0.02;
  params.lead_radius = 1;
  params.guides = {{{-20, -20}, {20, -18}}, {{-20, 15}, {0, 20}, {20, 16}}};
  params.floor = kLowest;
  params.top = 10;
  params.safe_height = 12;
  params.clearance_height = 15;
  params.feed = 1000;
  params.plunge_feed = 300;
  params.rapid_feed = 5000;
  return params;
}

Waypoint corner_of(const Move& move) { return {{move.x, move.y, move.z}, move.sweep}; }

constexpr std::size_t kPlaces = 10000;

// Places of the tip, any of which is as likely, on moves that are no rapids.
std::vector<SpacePoint> random_places(const std::vector<Move>& moves) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const bool counts = i > 0 && moves[i].kind != MoveKind::kRapid;
    lengths.push_back(counts ? way_length(corner_of(moves[i - 1]), corner_of(moves[i])) : 0);
  }
  std::mt19937 random(1);
  std::discrete_distribution<std::size_t> which(lengths.begin(), lengths.end());
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<SpacePoint> places;
  while (places.size() < kPlaces) {
    const std::size_t i = which(random);
    places.push_back(place_on(corner_of(moves[i - 1]), corner_of(moves[i]), share(random)));
  }
  return places;
}

const std::map<Pattern, std::string>& names() {
  static const std::map<Pattern, std::string> all{
      {Pattern::kZigZag, "ZigZag"},
      {Pattern::kOneWay, "OneWay"},
      {Pattern::kContoursInwards, "ContoursInwards"},
      {Pattern::kContoursOutwards, "ContoursOutwards"},
      {Pattern::kSpiralInwards, "SpiralInwards"},
      {Pattern::kSpiralOutwards, "SpiralOutwards"},
      {Pattern::kBetweenGuides, "BetweenGuides"},
      {Pattern::kOneWayBetweenGuides, "OneWayBetweenGuides"}};
  return all;
}

// The laws of all paths: they do not cut into the triangles, and are the same on any number of
// threads.
void expect_lawful(const FacetMesh& mesh, FinishParams params) {
  Progress progress;
  const Finish found = finish_surface(mesh, params, 0, progress);
  ASSERT_GT(found.toolpath.report.passes, 1);
  for (const SpacePoint p : random_places(found.toolpath.moves))
    EXPECT_GT(p.z, drop(mesh, params.cutter, plan(p), kLowest).z - 0.11 * params.tolerance);
  params.threads = 3;
  const Finish again = finish_surface(mesh, params, 0, progress);
  ASSERT_EQ(again.toolpath.moves.size(), found.toolpath.moves.size());
  for (std::size_t i = 0; i < again.toolpath.moves.size(); ++i) {
    EXPECT_EQ(again.toolpath.moves[i].x, found.toolpath.moves[i].x);
    EXPECT_EQ(again.toolpath.moves[i].z, found.toolpath.moves[i].z);
    EXPECT_EQ(again.toolpath.moves[i].cx, found.toolpath.moves[i].cx);
  }
}

class EachPattern : public testing::TestWithParam<Pattern> {};

TEST_P(EachPattern, NeverCutsIntoThePartAndIsTheSameOnAnyNumberOfThreads) {
  expect_lawful(waves(), params_of(GetParam()));
}

TEST_P(EachPattern, IsAsLawfulByCusps) {
  FinishParams params = params_of(GetParam());
  params.cusp_height = 0.3;
  expect_lawful(waves(), params);
}

TEST_P(EachPattern, IsAsLawfulBeyondTheFaces) {
  FinishParams params = params_of(GetParam());
  params.extension = 2.5;
  expect_lawful(waves(), params);
}

// A round dome, seen from above a disc, as rings of triangles that a spline's could be.
FacetMesh dome() {
  constexpr int kRings = 40, kSides = 360;
  constexpr double kDisc = 20, kSphere = 50;
  std::vector<SpacePoint> points{{0, 0, kSphere}};
  std::vector<FacetMesh::Triangle> triangles;
  const auto number = [](int ring, int k) {
    return static_cast<std::uint32_t>(1 + (ring - 1) * kSides + k % kSides);
  };
  for (int ring = 1; ring <= kRings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const double r = kDisc * ring / kRings, angle = 2 * kPi * k / kSides;
      points.push_back(
          {r * std::cos(angle), r * std::sin(angle), std::sqrt(kSphere * kSphere - r * r)});
      if (ring == 1) {
        triangles.push_back({0, number(1, k), number(1, k + 1)});
      } else {
        triangles.push_back({number(ring - 1, k), number(ring, k), number(ring, k + 1)});
        triangles.push_back({number(ring - 1, k), number(ring, k + 1), number(ring - 1, k + 1)});
      }
    }
  const std::vector<bool> picked(triangles.size(), true);
  return FacetMesh(points, triangles, picked);
}

class RoundPattern : public testing::TestWithParam<Pattern> {};

TEST_P(RoundPattern, IsFewArcsThatNeverCutIntoThePart) {
  const FacetMesh mesh = dome();
  FinishParams params = params_of(GetParam());
  params.top = 60;
  params.safe_height = params.clearance_height = 62;
  params.stepover = 1;
  Progress progress;
  const Finish found = finish_surface(mesh, params, 0, progress);
  const std::vector<Move>& moves = found.toolpath.moves;
  for (const SpacePoint p : random_places(moves))
    EXPECT_GT(p.z, drop(mesh, params.cutter, plan(p), kLowest).z - 0.11 * params.tolerance);
  double on_arcs = 0, cut = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::kCut) continue;
    const double length = way_length(corner_of(moves[i - 1]), corner_of(moves[i]));
    cut += length;
    if (moves[i].sweep != 0) on_arcs += length;
  }
  EXPECT_NEAR(cut, found.toolpath.report.cut_length, 1e-6 * cut);
  EXPECT_GT(on_arcs, 0.95 * cut);
  EXPECT_EQ(found.toolpath.report.retracts, 0);
  // As lines a turn would take 2 pi / (2 acos(1 - 0.002/10)), some 150 of them.
  EXPECT_LT(static_cast<double>(moves.size()), 15 * found.toolpath.report.passes);
}

TEST_P(RoundPattern, IsLinesAloneWithoutArcs) {
  FinishParams params = params_of(GetParam());
  params.top = 60;
  params.safe_height = params.clearance_height = 62;
  params.arcs = false;
  const FacetMesh mesh = dome();
  expect_lawful(mesh, params);
  Progress progress;
  for (const Move& move : finish_surface(mesh, params, 0, progress).toolpath.moves)
    EXPECT_EQ(move.sweep, 0);
}

INSTANTIATE_TEST_SUITE_P(Finish, RoundPattern,
                         testing::Values(Pattern::kContoursInwards, Pattern::kContoursOutwards,
                                         Pattern::kSpiralInwards, Pattern::kSpiralOutwards),
                         [](const auto& each) { return names().at(each.param); });

// A rectangle, 60 x 40 mm, at z = 0.
FacetMesh level_rectangle() {
  return FacetMesh({{0, 0, 0}, {60, 0, 0}, {60, 40, 0}, {0, 40, 0}}, {{0, 1, 2}, {0, 2, 3}},
                   {true, true});
}

TEST(ContoursByCusp, HaveNoCornersWithinTheSidesOfALevelRectangle) {
  FinishParams params = params_of(Pattern::kContoursInwards);
  params.lead_radius = 0;
  params.cusp_height = 0.1;
  Progress progress;
  const Finish found = finish_surface(level_rectangle(), params, 0, progress);
  EXPECT_GT(found.toolpath.report.passes, 5);
  // A row: four sides, detours into four corners and back, the way to the next row.
  EXPECT_LT(static_cast<double>(found.toolpath.moves.size()),
            13 * found.toolpath.report.passes + 6);
}

// A level ring about the origin.
FacetMesh ring(double inner, double outer) {
  constexpr std::uint32_t kSides = 90;
  std::vector<SpacePoint> points;
  std::vector<FacetMesh::Triangle> triangles;
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const Vec2 out = unit(2 * kPi * k / kSides);
    for (const double radius : {inner, outer}) points.push_back({radius * out.x, radius * out.y});
    const std::uint32_t next = 2 * ((k + 1) % kSides);
    triangles.push_back({2 * k, 2 * k + 1, next + 1});
    triangles.push_back({2 * k, next + 1, next});
  }
  const std::vector<bool> picked(triangles.size(), true);
  return FacetMesh(points, triangles, picked);
}

// mm to the nearest place of a cut that a path makes on level ground, in plan.
double off_cuts(const std::vector<Move>& moves, Vec2 place) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::kCut) continue;
    const SpacePoint from = corner_of(moves[i - 1]);
    const Waypoint to = corner_of(moves[i]);
    const Vec2 way = plan(to - from);
    const double share = to.sweep != 0 ? nearest_share(from, to, place)
                                       : dot(place - plan(from), way) / squared_norm(way);
    nearest =
        std::min(nearest, norm(place - plan(place_on(from, to, std::clamp(share, 0.0, 1.0)))));
  }
  return nearest;
}

TEST(ContoursByCusp, LeaveNothingBetweenTheSidesOfARing) {
  FinishParams params = params_of(Pattern::kContoursInwards);
  params.cusp_height = 0.1;
  const double step = 2 * std::sqrt(3 * 3 - 2.9 * 2.9);  // on level ground
  Progress progress;
  // What the rows from both sides leave in the middle is as wide as a share of the step.
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double inner = 10, outer = inner + (4 + share) * step;
    const std::vector<Move> moves =
        finish_surface(ring(inner, outer), params, 0, progress).toolpath.moves;
    for (double radius = inner + 0.05; radius < outer - 0.05; radius += 0.05)
      for (const double angle : {0.1, 2.0, 4.5})
        EXPECT_LT(off_cuts(moves, radius * unit(angle)), 0.55 * step) << share << " " << radius;
  }
}

TEST(ContoursByCusp, AreStoppedInAllTheyDoAndTellNoShareOfIt) {
  const FacetMesh mesh = waves();
  const FinishParams params = params_of(Pattern::kSpiralInwards);
  const Ground ground{&mesh, params.cutter, 0, kLowest};
  const StepBeside beside(ground, 0.3, 0);
  const std::vector<Region> regions = covered_by_picked(mesh);
  std::size_t asked = 0;
  Progress counting([&](double share) {
    EXPECT_EQ(share, 0);
    ++asked;
    return true;
  });
  EXPECT_FALSE(border_rows(regions, beside, 1, counting).empty());
  // At each of some 190 stations, and for the ways outwards from them.
  EXPECT_GT(asked, 500);
  for (const double share : {0.1, 0.5, 0.9, 0.999}) {
    const auto last = static_cast<std::size_t>(share * static_cast<double>(asked));
    std::size_t count = 0;
    Progress stopping([&](double) { return ++count < last; });
    EXPECT_THROW(border_rows(regions, beside, 1, stopping), Cancelled);
    EXPECT_EQ(count, last);
  }
}

// A half cylinder along x of radius 20 mm, less its steep sides, 60 mm long.
FacetMesh vault() {
  constexpr std::uint32_t kSides = 60;
  std::vector<SpacePoint> points;
  std::vector<FacetMesh::Triangle> triangles;
  for (std::uint32_t k = 0; k <= kSides; ++k) {
    const double angle = kPi / 180 * (2.0 * k - kSides);
    for (const double x : {0.0, 60.0})
      points.push_back({x, 20 * std::sin(angle), 20 * std::cos(angle) - 20});
    if (k == kSides) break;
    triangles.push_back({2 * k, 2 * k + 1, 2 * k + 3});
    triangles.push_back({2 * k, 2 * k + 3, 2 * k + 2});
  }
  const std::vector<bool> picked(triangles.size(), true);
  return FacetMesh(points, triangles, picked);
}

// Detours round what is left in corners are more lines than rows at even distances have.
TEST(ContoursByCusp, OnAVaultTakeFewMovesForTheirLength) {
  FinishParams params = params_of(Pattern::kContoursInwards);
  params.stepover = 1;
  Progress progress;
  const auto moves_per_mm = [&](double cusp_height) {
    params.cusp_height = cusp_height;
    const Toolpath path = finish_surface(vault(), params, 0, progress).toolpath;
    return static_cast<double>(path.moves.size()) / path.report.cut_length;
  };
  EXPECT_LT(moves_per_mm(0.04), 3 * moves_per_mm(0));
}

std::vector<Pattern> patterns() {
  std::vector<Pattern> all;
  for (const auto& [pattern, name] : names()) all.push_back(pattern);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Finish, EachPattern, testing::ValuesIn(patterns()),
                         [](const auto& each) { return names().at(each.param); });

}  // namespace
}  // namespace evenload
