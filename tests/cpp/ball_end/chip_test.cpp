// Chips of ball-end tools: closed forms, laws, the surfaces and passes beneath them.
#include "ball_end/chip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "ball_end/bent_surface.h"
#include "ball_end/chips.h"
#include "ball_end/part_profile.h"
#include "ball_end/swept_pass.h"

namespace evenload {
namespace {

ChipCase task(double feed, double stepover, double degrees, Uncut uncut = Uncut::kRight) {
  return {5, feed, stepover, 0.3, degrees * kDegree, uncut};
}

Chip on_cylinder(double radius, double y, const ChipCase& wanted, Steps steps = Steps::kPlan) {
  const ExtrudedSurface surface(cylinder_profile(radius), wanted.ball_radius, steps);
  return chip(surface, {0, surface.step_coordinate(y)}, wanted);
}

Chip on_plane(const ChipCase& wanted) {
  return chip(ExtrudedSurface(plane_profile(), wanted.ball_radius, Steps::kPlan), {}, wanted);
}

TEST(BallEndChip, OnAPlaneHasTheVolumeAndFacesOfSlices) {
  struct Row {
    double feed, stepover, volume, tool, previous;
  };
  for (const Row& row : {Row{0.08, 0.35, 8.36324e-3, 1.41377, 1.26057},
                         {0.08, 0.25, 5.98163e-3, 1.19034, 1.04117},
                         {0.08, 0.15, 3.59001e-3, 0.925376, 0.780264},
                         {0.12, 0.15, 5.37053e-3, 0.96151, 0.74413},
                         {0.16, 0.15, 7.13376e-3, 0.997471, 0.70817},
                         {0.16, 0.35, 16.6775e-3, 1.49015, 1.18419}})
    for (const double degrees : {0.0, 33.0, 90.0}) {
      const Chip found = on_plane(task(row.feed, row.stepover, degrees));
      EXPECT_NEAR(found.volume / row.volume, 1, 2e-5);
      EXPECT_NEAR(found.tool_face / row.tool, 1, 2e-5);
      EXPECT_NEAR(found.previous_face / row.previous, 1, 2e-5);
    }
  const Chip slot = on_plane(task(0.08, 0, 0, Uncut::kSlot));
  EXPECT_NEAR(slot.volume / 54.9092e-3, 1, 2e-5);
  EXPECT_NEAR(slot.tool_face / 4.85164, 1, 2e-5);
  EXPECT_NEAR(slot.previous_face / 4.57313, 1, 2e-5);
}

TEST(BallEndChip, OfAFineFeedTakesTheLayerThatThePassLeaves) {
  const double feed = 1e-3, stepover = 0.3, radius = 5;
  const double layer = stepover * 0.3 - std::pow(stepover, 3) / (24 * radius);
  EXPECT_NEAR(on_plane(task(feed, stepover, 0)).volume / (feed * layer), 1, 1e-5);
}

TEST(BallEndChip, IsTheSameInAMirror) {
  for (const double radius : {45.0, -45.0, -8.0}) {
    const double y = radius == -8 ? 1 : 18;
    const Chip one = on_cylinder(radius, y, task(0.12, 0.2, 35));
    const Chip across = on_cylinder(radius, -y, task(0.12, 0.2, -35, Uncut::kLeft));
    const Chip along = on_cylinder(radius, y, task(0.12, 0.2, 145, Uncut::kLeft));
    for (const Chip& twin : {across, along}) {
      EXPECT_NEAR(twin.volume / one.volume, 1, 1e-6);
      EXPECT_NEAR(twin.previous_face / one.previous_face, 1, 1e-6);
      EXPECT_NEAR(twin.max_thickness / one.max_thickness, 1, 1e-4);
      EXPECT_NEAR(twin.edge_to, one.edge_to, 1e-4);
    }
  }
}

TEST(BallEndChip, ChangesSmoothlyWithTheDirectionOfFeed) {
  // A bound that is overlooked, or taken for another, shows as a jump.
  for (const Uncut uncut : {Uncut::kLeft, Uncut::kSlot, Uncut::kStrip})
    for (int i = 0; i < 36; ++i) {
      double volume[3], face[3];
      for (int k = 0; k < 3; ++k) {
        const Chip c = on_cylinder(-10, 1.2, task(0.05, 0.3, 10 * i + 0.01 * k, uncut));
        volume[k] = c.volume;
        face[k] = c.tool_face;
      }
      EXPECT_NEAR((volume[0] + volume[2]) / (2 * volume[1]), 1, 1e-4) << i;
      EXPECT_NEAR((face[0] + face[2]) / (2 * face[1]), 1, 1e-4) << i;
    }
}

TEST(BallEndChip, OfASlotInANarrowTroughIsFound) {
  ChipCase wanted = task(0.11197610599388721, 0.4, 21.778719711263705, Uncut::kSlot);
  wanted.allowance = 0.4576324938642345;
  EXPECT_GT(on_cylinder(-10, -0.23878228433537907, wanted).volume, 0.05);
}

TEST(BallEndChip, RefusesWhatIsNone) {
  EXPECT_THROW(on_plane(task(0, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(on_plane(task(NAN, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(on_plane(task(0.1, 10, 0)), std::invalid_argument);
  EXPECT_THROW(on_plane(task(4, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(on_cylinder(-5, 0, task(0.1, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(on_cylinder(45, 48.5, task(0.1, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(BentSurface({}, 5, Steps::kPlan), std::invalid_argument);
}

TEST(BallEndChips, AreTheSameOnAnyNumberOfThreads) {
  std::vector<WantedChip> wanted;
  for (int i = -10; i <= 10; ++i) wanted.push_back({0, 3.5 * i, task(0.12, 0.15, 45)});
  Progress nobody;
  const std::vector<Worked> part{test_part_profile(true)};
  const std::vector<Chip> one = chips(part, Steps::kPlan, wanted, 1, nobody);
  const std::vector<Chip> three = chips(part, Steps::kPlan, wanted, 3, nobody);
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(one[i].volume, three[i].volume);
  // On the concave fillet, beside the joint, twice that of the flat.
  EXPECT_NEAR(one[18].volume / one[0].volume, 2.1, 0.1);
}

// ---- surfaces ----

TEST(PartProfile, OfTheTestPartHasTheSourceSPlaces) {
  const ExtrudedSurface dome(test_part_profile(true), 5, Steps::kPlan);
  EXPECT_NEAR(dome.lowest(), -40, 1e-9);
  EXPECT_NEAR(dome.highest(), 40, 1e-9);
  EXPECT_NEAR(dome.centre({0, 0}, {0, 1}).at.z(), 50, 1e-9);
  EXPECT_NEAR(dome.centre({0, 35}, {0, 1}).at.z(), 41.0977, 1e-3);
  EXPECT_NEAR(dome.normal({0, 25}).y(), 0.5, 1e-9);
  EXPECT_NEAR(dome.distance({0, 0, 45.3}), 0.3, 1e-9);
  EXPECT_NEAR(dome.distance({0, -35, 36.0977}), 0, 1e-3);
  const ExtrudedSurface trough(test_part_profile(false), 5, Steps::kPlan);
  EXPECT_NEAR(trough.centre({0, 0}, {0, 1}).at.z(), -40, 1e-9);
  EXPECT_NEAR(trough.distance({0, 0, -44.7}), 0.3, 1e-9);
}

void expect_derivatives(const WorkedSurface& surface, Vec2 at, Vec2 along) {
  const double h = 1e-4;
  const PathPoint here = surface.centre(at, along), ahead = surface.centre(at + h * along, along),
                  behind = surface.centre(at - h * along, along);
  EXPECT_LT((here.first - (ahead.at - behind.at) / (2 * h)).norm(), 1e-7);
  EXPECT_LT((here.second - (ahead.first - behind.first) / (2 * h)).norm(), 1e-7);
  EXPECT_NEAR(surface.distance(here.at), 5, 1e-9);
  EXPECT_NEAR(surface.distance(here.at - 5 * surface.normal(at)), 0, 1e-9);
}

TEST(WorkedSurface, HasCentresABallAwayAndTheirDerivatives) {
  for (const Steps steps : {Steps::kPlan, Steps::kCentre, Steps::kSurface})
    for (const bool is_convex : {true, false}) {
      const ExtrudedSurface surface(test_part_profile(is_convex), 5, steps);
      for (const double y : {-36.0, -29.0, -13.0, 2.0, 20.0, 28.5})
        expect_derivatives(surface, {1, surface.step_coordinate(y)}, unit(0.7));
      const double q = surface.step_coordinate(17);
      EXPECT_NEAR(surface.centre({0, q}, {0, 1}).at.y(), 17, 1e-9);
    }
  for (const Steps steps : {Steps::kCentre, Steps::kSurface})
    for (const double second : {0.02, 0.0, -0.1}) {
      const BentSurface surface({0.05, second, 0.4, 1.1}, 5, steps);
      expect_derivatives(surface, {0.3, -0.7}, unit(0.7));
    }
}

TEST(SweptPass, IsAsFarAsItsNearestPlace) {
  const ExtrudedSurface surface(test_part_profile(true), 5, Steps::kPlan);
  const Vec2 through{0, 26}, along = unit(1.1);
  const SweptPass pass(surface, through, along);
  const Eigen::Vector3d point =
      surface.centre({0.3, 26.5}, along).at - Eigen::Vector3d(1, 0.4, 4.8);
  double nearest = 1e9;
  for (int i = -200000; i <= 200000; ++i)
    nearest =
        std::min(nearest, (surface.centre(through + 2e-5 * i * along, along).at - point).norm());
  EXPECT_NEAR(pass.distance(point), nearest, 1e-8);
  EXPECT_NEAR(pass.distance(point), nearest, 1e-8);  // from the place found before
}

TEST(BentSurface, OfOneCurvatureIsACylinder) {
  const double slope = std::asin(21.0 / 50);
  const Chip bent = chip(BentSurface({0, 1.0 / 45, slope, kPi / 2}, 5, Steps::kSurface), {},
                         task(0.12, 0.15, 45));
  const Chip cylinder = on_cylinder(45, 21, task(0.12, 0.15, 45), Steps::kSurface);
  EXPECT_NEAR(bent.volume / cylinder.volume, 1, 1e-6);
  EXPECT_NEAR(bent.edge_from, cylinder.edge_from, 1e-5);
  EXPECT_NEAR(bent.edge_to, cylinder.edge_to, 1e-5);
}

}  // namespace
}  // namespace evenload
