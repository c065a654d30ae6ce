// The simulator beside a judge of another method, which looks at points one by one, on every path
// of the corpus; and the simulator beside itself at other resolutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cutting/engagement.h"
#include "judge/judged.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests
using corpus::Case;

struct Scene {
  std::vector<Prism> stock, part;
};

// A pocket in a block that surrounds it, or a block that the outline bounds.
Scene scene_of(const Case& pocket) {
  Scene scene;
  std::vector<Curve> outlines{pocket.region.outer};
  const bool open = pocket.region.outer.vertices().front().open;
  for (const Curve& island : pocket.region.islands)
    scene.part.push_back({make_region(island.reversed()), 0});
  if (open) {
    scene.stock.push_back({make_region(pocket.region.outer), 0});
    return scene;
  }
  const Bounds box = bounds_of({pocket.region});
  const double margin = 2 * pocket.tool_diameter;
  const Region block =
      rectangle(box.low.x - margin, box.low.y - margin, box.high.x + margin, box.high.y + margin);
  scene.stock.push_back({block, 0});
  scene.part.push_back({make_region(block.outer, {pocket.region.outer}), 0});
  return scene;
}

Simulation simulate_case(const Case& pocket, const Toolpath& path, double resolution) {
  const Scene scene = scene_of(pocket);
  DexelStock stock(scene.stock, -pocket.axial_depth, resolution);
  if (pocket.hole)
    stock.cut(Segment::line(pocket.hole->centre, pocket.hole->centre), 0.5 * pocket.hole->diameter,
              -pocket.axial_depth);
  SimulationParams params = params_for(0.5 * pocket.tool_diameter);
  params.part = scene.part;
  params.step = 0.05;
  Progress progress;
  return simulate(path.moves, stock, params, progress);
}

double mean_cut_engagement(const LoadRecord& record) {
  double sum = 0, length = 0;
  for (std::size_t i = 1; i < record.size(); ++i) {
    if (static_cast<MoveKind>(record.kind[i]) != MoveKind::kCut) continue;
    sum += 0.5 * (record.engagement[i - 1] + record.engagement[i]) * record.length[i];
    length += record.length[i];
  }
  return length > 0 ? sum / length : 0;
}

class EverySimulatedPocket : public testing::TestWithParam<std::string> {};

TEST_P(EverySimulatedPocket, FeelsWhatAJudgeOfAnotherMethodSees) {
  const auto& [pocket, path, seen] = corpus::at_home(GetParam());
  // Side steps of a few rows only are told less exactly.
  const double step = side_step(pocket.engagement_angle, 0.5 * pocket.tool_diameter);
  const Simulation felt = simulate_case(pocket, path, std::min(kFine, step / 8));
  const LoadFigures& figures = felt.figures;
  EXPECT_NEAR(figures.engagement.value, seen.cut_engagement, 2 * kDegree);
  EXPECT_NEAR(mean_cut_engagement(felt.record), seen.mean_cut_engagement, 0.3 * kDegree);
  // The worst rate lasts for less than a step where small engagements begin and end.
  EXPECT_NEAR(figures.removal_rate.value / pocket.axial_depth, seen.removal_rate,
              0.06 * seen.removal_rate);
  EXPECT_NEAR(figures.gouge.value, seen.gouge, 0.001);
  EXPECT_NEAR(figures.cut_length, seen.cut_length, 1e-6 * seen.cut_length);
  EXPECT_LE(figures.rest.area, 0.001 * seen.reachable_area);
  EXPECT_EQ(figures.rapid_in_material.value, 0);
  EXPECT_EQ(figures.plunge_in_material.value, 0);
  // A degree is half a micrometre of material, a hundredth of a row.
  EXPECT_LE(figures.link_engagement.value, seen.link_engagement + 1.5 * kDegree);
  EXPECT_NEAR(figures.removed_volume, path.report.removed_volume,
              5e-3 * path.report.removed_volume);
  EXPECT_NEAR(figures.time, path.report.cutting_time, 0.05 * path.report.cutting_time);
}

INSTANTIATE_TEST_SUITE_P(Pocket, EverySimulatedPocket, testing::ValuesIn(corpus::clearable()),
                         [](const auto& pocket) { return pocket.param; });

// Mean error in degrees of the engagement on contours of several radii.
double contour_error(double resolution) {
  double sum = 0;
  int count = 0;
  for (int k = 0; k < 12; ++k) {
    const double rho = 6.1 + 2.37 * k, theta = (35 + 9 * k) * kDegree, radius = 3;
    const double step = side_step_on_contour(theta, radius, rho, Contour::kConcave);
    const Simulation run = cut_inside_circle(rho, rho + step - radius, radius, resolution);
    for (std::size_t i = run.record.size() / 3; i < run.record.size() * 9 / 10; ++i) {
      sum += std::abs(run.record.engagement[i] - theta) / kDegree;
      ++count;
    }
  }
  return sum / count;
}

// Mean error in mm^2 of the area of discs that lie anyhow between the dexels.
double area_error(double resolution) {
  double sum = 0;
  const int discs = 40;
  for (int k = 0; k < discs; ++k) {
    const Region disc = circle(5 + 0.317 * k, {0.0137 * k, 0.0291 * k});
    sum += std::abs(DexelStock({{disc, 0}}, -1, resolution).area() - disc.area());
  }
  return sum / discs;
}

TEST(Resolution, HalvedHalvesTheErrors) {
  double contour = contour_error(0.4), area = area_error(0.4);
  std::printf("resolution mm   engagement deg   area mm^2\n%13g %16.4f %11.5f\n", 0.4, contour,
              area);
  for (const double resolution : {0.2, 0.1, 0.05}) {
    const double finer_contour = contour_error(resolution), finer_area = area_error(resolution);
    std::printf("%13g %16.4f %11.5f\n", resolution, finer_contour, finer_area);
    EXPECT_LE(finer_contour, 0.5 * contour);
    EXPECT_LE(finer_area, 0.5 * area);
    contour = finer_contour;
    area = finer_area;
  }
}

}  // namespace
}  // namespace evenload
