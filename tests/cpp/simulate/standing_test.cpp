// What stands above a height, as regions, against areas and borders known in closed form.
#include "simulate/standing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/boundary_index.h"
#include "simulate/dexel_outline.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

constexpr double kFloor = -3;  // mm

// Reaches beyond all that these tests make.
const std::vector<Region> kEverywhere{rectangle(-100, -100, 100, 100)};

double area_of(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& region : regions) sum += region.area();
  return sum;
}

std::size_t pieces_of(const std::vector<Region>& regions) {
  std::size_t count = 0;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves()) count += curve.segment_count();
  return count;
}

void expect_valid(const std::vector<Region>& regions) {
  for (const Region& region : regions) {
    EXPECT_NO_THROW(make_region(region.outer, region.islands));
    for (const Curve& curve : region.curves())
      for (const Vertex& v : curve.vertices()) EXPECT_TRUE(v.open);
  }
}

void mill(DexelStock& stock, const Segment& path, double radius, double z = kFloor) {
  stock.cut(path, radius, z);
}

TEST(StandingRegions, HaveTheAreaAndTheShapeOfCirclesAndSquares) {
  for (const double turn : {0.0, 0.3, kPi / 4}) {
    const DexelStock square({{turned(rectangle(-10, -10, 10, 10), turn), 0}}, kFloor, kFine);
    const std::vector<Region> sides = standing_regions(square, kFloor, kEverywhere);
    expect_valid(sides);
    EXPECT_NEAR(area_of(sides), 400, 0.2) << turn;
    EXPECT_LE(pieces_of(sides), 20u) << turn;
  }
  const DexelStock disc({{circle(7.3, {1.01, -2.02}), 0}}, kFloor, kFine);
  const std::vector<Region> round = standing_regions(disc, kFloor, kEverywhere);
  expect_valid(round);
  EXPECT_NEAR(area_of(round), kPi * 7.3 * 7.3, 0.05);
  EXPECT_LE(pieces_of(round), 8u);
  for (const Vertex& v : round.front().outer.vertices())
    EXPECT_NEAR(distance(v.p, {1.01, -2.02}), 7.3, 2 * kOutlineTolerance);
}

TEST(StandingRegions, HaveIslandsWhereMaterialStandsInHoles) {
  const DexelStock stock({{plate_with_hole(20, 12), 0}, {circle(8), 0}}, kFloor, kFine);
  const std::vector<Region> found = standing_regions(stock, kFloor, kEverywhere);
  expect_valid(found);
  ASSERT_EQ(found.size(), 2u);
  const std::size_t ring = found[0].islands.empty() ? 1 : 0;
  ASSERT_EQ(found[ring].islands.size(), 1u);
  EXPECT_TRUE(found[1 - ring].islands.empty());
  EXPECT_NEAR(found[ring].area(), 40.137 * 40.211 - kPi * 144, 0.4);
  EXPECT_NEAR(found[1 - ring].area(), kPi * 64, 0.05);
}

TEST(StandingRegions, AreTheCornersThatALargerToolLeft) {
  // A square of 30 mm, its reach by a tool of 6 mm, cut along its walls by one of 12 mm.
  DexelStock stock({{rectangle(-10, -10, 40, 40), 0}}, kFloor, kFine);
  const Vec2 corners[] = {{6, 6}, {24, 6}, {24, 24}, {6, 24}};
  for (int i = 0; i < 4; ++i) mill(stock, Segment::line(corners[i], corners[(i + 1) % 4]), 6);
  mill(stock, Segment::line({15, 12}, {15, 18}), 6);
  const std::vector<Region> reach = offset(offset({rectangle(0, 0, 30, 30)}, -3), 3);
  const std::vector<Region> left = standing_regions(stock, kFloor, reach);
  expect_valid(left);
  ASSERT_EQ(left.size(), 4u);
  // Beside the reach's border a band of kBeyondReach belongs to them: two sides of 6 mm, and an
  // arc.
  const double band = kBeyondReach * (2 * 3 + kPi / 2 * 3);
  for (const Region& corner : left)
    EXPECT_NEAR(corner.area(), (1 - kPi / 4) * (36 - 9) + band, 0.001 * 27 + 0.5 * band);
  for (const Region& corner : left)
    for (const Segment& s : corner.outer.segments()) {
      const Vec2 p = s.point(0.5);
      const Vec2 centre{p.x < 15 ? 6.0 : 24.0, p.y < 15 ? 6.0 : 24.0};
      const double to_large = std::abs(distance(p, centre) - 6);
      const double to_reach =
          BoundaryIndex(offset(reach, kBeyondReach).front().curves()).nearest(p).distance;
      EXPECT_LE(std::min(to_reach, to_large), kBeyondReach) << p.x << ", " << p.y;
    }
}

TEST(StandingRegions, LeaveOutWhatIsThinnerThanTheToleranceOfWalls) {
  // A strip along the reach's lower side, left by a wall pass that kept away by its thickness.
  const std::vector<Region> reach{rectangle(0, 0, 20, 10)};
  for (const double thickness : {0.002, 0.006, 0.03, 0.2}) {
    DexelStock stock({{rectangle(-5, -5, 25, 15), 0}}, kFloor, kFine);
    for (double y = 2; y < 12; y += 1.5)
      mill(stock, Segment::line({-9, y + thickness}, {29, y + thickness}), 2);
    const std::vector<Region> left = standing_regions(stock, kFloor, reach);
    expect_valid(left);
    if (thickness < kRestTolerance) {
      EXPECT_TRUE(left.empty()) << thickness;
    } else {
      const double length = 20 + 2 * kBeyondReach;
      EXPECT_NEAR(area_of(left), length * (thickness + kBeyondReach), 0.002) << thickness;
      EXPECT_EQ(left.size(), 1u) << thickness;
    }
  }
}

TEST(StandingRegions, KeepSlitsOpenAndSliversWhole) {
  // Slivers that pass from node to node may come in pieces: their area stays.
  for (const double turn : {0.0, 0.02, 0.7}) {
    // Two blocks with 0.03 mm of air between, and a sliver of 0.03 mm beside.
    const DexelStock stock({{turned(rectangle(-8, 0, 8, 3), turn), 0},
                            {turned(rectangle(-8, 3.03, 8, 6), turn), 0},
                            {turned(rectangle(-8, 7, 8, 7.03), turn), 0}},
                           kFloor, kFine);
    const std::vector<Region> found = standing_regions(stock, kFloor, kEverywhere);
    expect_valid(found);
    if (turn < 0.1) {
      EXPECT_EQ(found.size(), 3u) << turn;
    }
    EXPECT_NEAR(area_of(found), 16 * (3 + 2.97 + 0.03), 0.05) << turn;
  }
}

TEST(StandingRegions, AreThoseAboveTheHeightAskedFor) {
  DexelStock stock({{rectangle(0, 0, 30, 20), 0}}, kFloor, kFine);
  mill(stock, Segment::line({-5, 5}, {35, 5}), 3, -1);
  mill(stock, Segment::line({-5, 15}, {35, 15}), 3, -2);
  EXPECT_NEAR(area_of(standing_regions(stock, -0.5, kEverywhere)), 600 - 360, 0.2);
  EXPECT_NEAR(area_of(standing_regions(stock, -1, kEverywhere)), 600 - 360, 0.2);
  EXPECT_NEAR(area_of(standing_regions(stock, -1.5, kEverywhere)), 600 - 180, 0.2);
  EXPECT_NEAR(area_of(standing_regions(stock, -2, kEverywhere)), 600 - 180, 0.2);
  EXPECT_NEAR(area_of(standing_regions(stock, -2.5, kEverywhere)), 600, 0.2);
  // A floor that stands higher than it should by less than the tolerance is cut.
  EXPECT_NEAR(area_of(standing_regions(stock, -2.005, kEverywhere)), 600 - 180, 0.2);
}

TEST(StandingRegions, AreNoneWhereNothingIsLeftOrReached) {
  DexelStock stock({{rectangle(0, 0, 10, 10), 0}}, kFloor, kFine);
  EXPECT_TRUE(standing_regions(stock, 0, kEverywhere).empty());
  EXPECT_TRUE(standing_regions(stock, kFloor, {}).empty());
  EXPECT_TRUE(standing_regions(stock, kFloor, {rectangle(12, 0, 20, 10)}).empty());
  mill(stock, Segment::line({-5, 5}, {15, 5}), 8);
  EXPECT_TRUE(standing_regions(stock, kFloor, kEverywhere).empty());
}

TEST(StandingRegions, AgreeWithTheSweptDiscsAtEveryPointOffTheBorder) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-2, 22), size(0.3, 4), turn(-3, 3);
  for (int round = 0; round < 12; ++round) {
    // Sides and nodes on whole coordinates every other time, where rows and columns may disagree.
    const double side = round % 2 ? 20.0 : 20.025;
    DexelStock stock({{rectangle(0, 0, side, side), 0}}, kFloor, kFine);
    struct Cut {
      Segment path;
      double radius;
    };
    std::vector<Cut> cuts;
    for (int i = 0; i < 9; ++i) {
      const Vec2 a{place(random), place(random)};
      const Segment path = i % 2 ? Segment::line(a, {place(random), a.y})
                                 : Segment::arc(a, size(random), turn(random), turn(random));
      cuts.push_back({path, i % 3 ? size(random) : 1.0});
      mill(stock, path, cuts.back().radius);
    }
    const std::vector<Region> found = standing_regions(stock, kFloor, kEverywhere);
    expect_valid(found);
    for (int i = 0; i < 4000; ++i) {
      const Vec2 p{place(random), place(random)};
      double clear = std::max({-p.x, -p.y, p.x - side, p.y - side});  // mm outside of all material
      for (const Cut& c : cuts) clear = std::max(clear, c.radius - c.path.distance_to(p));
      if (std::abs(clear) < 0.1) continue;
      bool stands = false;
      for (const Region& region : found) stands = stands || region.contains(p);
      EXPECT_EQ(stands, clear < 0) << p.x << ", " << p.y << " in round " << round;
    }
  }
}

TEST(OutlinesAbove, RunThroughEndsOfDexelsWithTheMaterialToTheLeft) {
  const DexelStock stock({{circle(5, {0.013, 0.02}), 0}}, kFloor, 0.2);
  const std::vector<std::vector<Vec2>> found = outlines_above(stock, kFloor, {});
  ASSERT_EQ(found.size(), 1u);
  double area = 0;
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    EXPECT_NEAR(distance(found[0][i], {0.013, 0.02}), 5, 1e-9);
    area += 0.5 * cross(found[0][i], found[0][(i + 1) % found[0].size()]);
  }
  EXPECT_NEAR(area, kPi * 25, 0.05);
}

}  // namespace
}  // namespace evenload
