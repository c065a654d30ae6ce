// Whole finishing paths by each pattern over a waved ground: what the sanitizers see of them, and
// laws that all patterns keep.
#include "surface/finish.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "surface/drop.h"

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

class EachPattern : public testing::TestWithParam<Pattern> {};

TEST_P(EachPattern, NeverCutsIntoThePartAndIsTheSameOnAnyNumberOfThreads) {
  const FacetMesh mesh = waves();
  FinishParams params = params_of(GetParam());
  Progress progress;
  const Finish found = finish_surface(mesh, params, 0, progress);
  ASSERT_GT(found.toolpath.report.passes, 1);
  const Cutter& cutter = params.cutter;
  Move before = found.toolpath.moves.front();
  for (const Move& move : found.toolpath.moves) {
    for (const double share : {0.3, 0.7, 1.0}) {
      const Vec2 at{before.x + share * (move.x - before.x), before.y + share * (move.y - before.y)};
      const double z = before.z + share * (move.z - before.z);
      EXPECT_GT(z, drop(mesh, cutter, at, kLowest).z - 0.11 * params.tolerance);
    }
    before = move;
  }
  params.threads = 3;
  const Finish again = finish_surface(mesh, params, 0, progress);
  ASSERT_EQ(again.toolpath.moves.size(), found.toolpath.moves.size());
  for (std::size_t i = 0; i < again.toolpath.moves.size(); ++i) {
    EXPECT_EQ(again.toolpath.moves[i].x, found.toolpath.moves[i].x);
    EXPECT_EQ(again.toolpath.moves[i].z, found.toolpath.moves[i].z);
  }
}

const std::map<Pattern, std::string>& names() {
  static const std::map<Pattern, std::string> all{{Pattern::kZigZag, "ZigZag"},
                                                  {Pattern::kOneWay, "OneWay"},
                                                  {Pattern::kContoursInwards, "ContoursInwards"},
                                                  {Pattern::kContoursOutwards, "ContoursOutwards"},
                                                  {Pattern::kSpiralInwards, "SpiralInwards"},
                                                  {Pattern::kSpiralOutwards, "SpiralOutwards"},
                                                  {Pattern::kBetweenGuides, "BetweenGuides"}};
  return all;
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
