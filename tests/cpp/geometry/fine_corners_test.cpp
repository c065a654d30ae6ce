// Laws of borders without rows of fine corners.
#include "geometry/fine_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/boundary_index.h"

namespace evenload {
namespace {

constexpr double kTolerance = 0.002;

// A square of `side` mm with corners rounded by `radius`, each by so many lines.
Region rounded_square(double side, double radius, int lines) {
  std::vector<Vertex> vertices;
  for (int corner = 0; corner < 4; ++corner) {
    const Vec2 centre = rotated(Vec2{side / 2 - radius, side / 2 - radius}, corner * kPi / 2);
    for (int i = 0; i <= lines; ++i)
      vertices.push_back(
          {centre + radius * unit((corner + static_cast<double>(i) / lines) * kPi / 2)});
  }
  return make_region(Curve(std::move(vertices), true));
}

Region polygon(int corners, double radius) {
  std::vector<Vertex> vertices;
  for (int i = 0; i < corners; ++i) vertices.push_back({radius * unit(2 * kPi * i / corners)});
  return make_region(Curve(std::move(vertices), true));
}

// rad: the sharpest turn between two pieces.
double sharpest(const Curve& curve) {
  const std::vector<Segment> pieces = curve.segments();
  double most = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec2 a = pieces[i].tangent(1), b = pieces[(i + 1) % pieces.size()].tangent(0);
    most = std::max(most, std::abs(std::atan2(cross(a, b), dot(a, b))));
  }
  return most;
}

void expect_inside_and_near(const Region& smooth, const Region& given) {
  const BoundaryIndex old_border(given.curves()), new_border(smooth.curves());
  const auto visit = [](const Region& region, const auto& look) {
    for (const Curve& curve : region.curves())
      for (const Segment& piece : curve.segments())
        for (int i = 0; i < 7; ++i) look(piece.point(i / 7.0));
  };
  visit(smooth, [&](Vec2 p) {
    EXPECT_TRUE(given.contains(p) || old_border.nearest(p).distance < 2e-7) << p.x << " " << p.y;
  });
  visit(given, [&](Vec2 p) {
    EXPECT_LT(new_border.nearest(p).distance, kTolerance) << p.x << " " << p.y;
  });
}

TEST(FineCorners, OfRoundedCornersBecomeTangentArcs) {
  for (const double radius : {0.1, 0.163, 1.0, 4.0})
    for (const int lines : {8, 24, 60}) {
      SCOPED_TRACE(testing::Message() << radius << " by " << lines);
      const Region given = rounded_square(20, radius, lines);
      const std::vector<Region> smooth = without_fine_corners({given}, kTolerance);
      ASSERT_EQ(smooth.size(), 1u);
      expect_inside_and_near(smooth[0], given);
      EXPECT_LT(sharpest(smooth[0].outer), 1e-4);
      EXPECT_LE(smooth[0].outer.segment_count(), 4u * (2 * static_cast<std::size_t>(lines) + 4));
    }
  // Where the lines are short enough, a few arcs take the place of all of them.
  const Region smooth = without_fine_corners({rounded_square(20, 0.163, 24)}, kTolerance)[0];
  EXPECT_LE(smooth.outer.segment_count(), 28u);
}

TEST(FineCorners, OfAPolygonAllRoundBecomeArcsWithoutABeginning) {
  const Region given = polygon(180, 3), smooth = without_fine_corners({given}, kTolerance)[0];
  expect_inside_and_near(smooth, given);
  EXPECT_LT(sharpest(smooth.outer), 1e-4);
  EXPECT_LT(smooth.outer.segment_count(), 20u);
}

TEST(FineCorners, AboutIslandsAreCornersToTheOutside) {
  const Region outside = rounded_square(40, 3, 30);
  Region given = outside;
  given.islands = {polygon(120, 5).outer.reversed()};
  const Region smooth = without_fine_corners({given}, kTolerance)[0];
  ASSERT_EQ(smooth.islands.size(), 1u);
  EXPECT_EQ(smooth.islands[0].segment_count(), 120u);
  expect_inside_and_near(smooth, given);
}

TEST(FineCorners, AreLeftBetweenEdgesThatAreOpenAndWhereCornersAreSharp) {
  Region given = polygon(60, 10);
  std::vector<Vertex> open = given.outer.vertices();
  for (Vertex& v : open) v.open = true;
  given.outer = Curve(open, true);
  EXPECT_EQ(without_fine_corners({given}, kTolerance)[0].outer.segment_count(), 60u);
  const Region hexagon = polygon(6, 10);
  EXPECT_EQ(without_fine_corners({hexagon}, kTolerance)[0].outer.segment_count(), 6u);
}

}  // namespace
}  // namespace evenload
