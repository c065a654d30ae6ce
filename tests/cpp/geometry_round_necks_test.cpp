// Openings by a disc without corners in their necks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/round_necks.h"
#include "geometry_shapes.h"
#include "strategy/stage.h"

namespace evenload {
namespace {

constexpr double kDisc = 1.25;

// Where a tool of 6 mm may be between two points of a wall, which leave its centre `width` mm, or
// between one point and a straight wall.
std::vector<Region> hourglass(double width, bool one_sided) {
  const double top = 0.5 * width + 3;
  const std::vector<Vec2> outline =
      one_sided
          ? std::vector<Vec2>{{-20, -top}, {20, -top}, {20, 15}, {0, top}, {-20, 15}}
          : std::vector<Vec2>{{-20, -15}, {0, -top}, {20, -15}, {20, 15}, {0, top}, {-20, 15}};
  return offset({make_region(shapes::polygon(outline))}, -3);
}

std::vector<Region> opened(const std::vector<Region>& regions, double radius) {
  return offset(offset(regions, -radius), radius);
}

std::vector<Region> rounded(const std::vector<Region>& opened, double narrowest = 0,
                            double radius = kDisc) {
  return with_round_necks(opened, radius, narrowest, [](const Segment&) { return true; });
}

// rad: the sharpest turn to the right.
double sharpest_right_turn(const std::vector<Region>& regions) {
  double most = 0;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves()) {
      const std::vector<Segment> pieces = curve.segments();
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec2 from = pieces[i].tangent(1), to = pieces[(i + 1) % pieces.size()].tangent(0);
        most = std::max(most, -std::atan2(cross(from, to), dot(from, to)));
      }
    }
  return most;
}

double area_of(const std::vector<Region>& regions) {
  double area = 0;
  for (const Region& region : regions) area += region.area();
  return area;
}

void expect_between(const std::vector<Region>& inner, const std::vector<Region>& rounded,
                    const Region& outer) {
  const BoundaryIndex walls(outer.curves());
  ASSERT_EQ(rounded.size(), inner.size());
  for (const Region& region : rounded) {
    EXPECT_NO_THROW(make_region(region.outer, region.islands));
    for (const Curve& curve : region.curves())
      for (const Segment& piece : curve.segments())
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
          const Vec2 p = piece.point(t);
          EXPECT_TRUE(outer.contains(p) || walls.nearest(p).distance < 1e-5);
        }
  }
  EXPECT_GE(area_of(rounded), area_of(inner) - 1e-9);
  EXPECT_LE(area_of(rounded), outer.area() + 1e-6);
}

TEST(RoundNecks, HaveNoCorners) {
  for (const bool one_sided : {false, true})
    for (const double width : {2.495, 2.49, 2.45, 2.4, 2.35}) {
      const std::vector<Region> room = hourglass(width, one_sided);
      const std::vector<Region> before = opened(room, kDisc);
      ASSERT_EQ(before.size(), 1u);
      EXPECT_GT(sharpest_right_turn(before), 4 * kPi / 180) << width;
      const std::vector<Region> round = rounded(before);
      EXPECT_LT(sharpest_right_turn(round), 2 * kNeckCorner) << width;
      expect_between(before, round, room.front());
    }
}

TEST(RoundNecks, LeaveRoomsApartAndOtherCornersAsTheyAre) {
  for (const double width : {1.0, 3.0}) {
    const std::vector<Region> before = opened(hourglass(width, false), kDisc);
    EXPECT_EQ(before.size(), width > 2 * kDisc ? 1u : 2u);
    const std::vector<Region> round = rounded(before);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(round[i].outer.segments(), before[i].outer.segments());
  }
  // Corners of walls, and arcs of another radius.
  const Region notched = make_region(shapes::polygon({{0, 0}, {9, 0}, {9, 9}, {5, 4}, {0, 9}}));
  EXPECT_EQ(rounded({notched}).front().outer.segments(), notched.outer.segments());
  const std::vector<Region> narrow = opened(hourglass(2.3, false), kDisc);
  EXPECT_EQ(rounded(narrow, 0, 0.9).front().outer.segments(), narrow.front().outer.segments());
}

TEST(RoundNecks, HoldBetweenIslandsFarAwayAndWhereverACurveBegins) {
  // Between two pins whose surfaces are 8.4 mm apart: a neck in the border of each.
  const auto pin = [](double x) { return shapes::circle({x, 0}, 2); };
  const Region pins = make_region(shapes::polygon({{-30, -20}, {30, -20}, {30, 20}, {-30, 20}}),
                                  {pin(-6.2), pin(6.2)});
  for (const double angle : {0.0, 1.0, 4.0}) {
    std::vector<Curve> islands;
    for (const Curve& island : pins.islands)
      islands.push_back(shapes::moved(island, angle, false, 1, {4e3, -7e3}));
    const Region moved =
        make_region(shapes::moved(pins.outer, angle, false, 1, {4e3, -7e3}), islands);
    const std::vector<Region> room = offset({moved}, -3);
    const std::vector<Region> before = opened(room, kDisc);
    EXPECT_GT(sharpest_right_turn(before), 0.1);
    const std::vector<Region> round = rounded(before);
    EXPECT_LT(sharpest_right_turn(round), 2 * kNeckCorner) << angle;
    expect_between(before, round, room.front());
  }
}

TEST(RoundNecks, KeepTheCornersOfNecksThatAreTooNarrow) {
  const std::vector<Region> before = opened(hourglass(2.4, false), kDisc);
  EXPECT_LT(sharpest_right_turn(rounded(before, 1.0)), 2 * kNeckCorner);
  EXPECT_EQ(sharpest_right_turn(rounded(before, 1.1)), sharpest_right_turn(before));
}

// Right turns left are those of necks in which the stage cannot turn: its disc is a quarter wider.
TEST(RoundNecks, LetNoStageHaveFlatCornersWherePassesTurnAwayFromTheWall) {
  const double flattest_kept = 2 * std::acos(1.02 / kOpeningRatio);
  int round = 0;
  for (const double width : {0.4, 0.7, 0.9, 1.5, 2.0, 2.2})
    for (const Stage& stage : make_stages(hourglass(width, false).front(), {})) {
      const double sharpest = sharpest_right_turn(stage.rooms);
      EXPECT_TRUE(sharpest < 2 * kNeckCorner || sharpest > flattest_kept) << sharpest;
      round += sharpest < 2 * kNeckCorner;
    }
  EXPECT_GT(round, 40);
}

// The tool's radius is less than that of the arc that would round the neck between four pins: the
// middle one of three in a row lies where that arc would lead.
TEST(RoundNecks, LeadIntoNoPinHoweverWideTheTurns) {
  constexpr double kPin = 0.3, kCentres = 3 + kPin, kApart = 5.5;
  for (const double turn : {7.0, 8.0, 12.0}) {
    const double disc = kOpeningRatio * turn, from_disc = disc + kCentres;
    const double aside = std::acos(kApart / (1.5 * disc)) + 0.05;
    const double y = std::sqrt(from_disc * from_disc - kApart * kApart);
    const Vec2 side = Vec2{-kApart, 0} + from_disc * unit(aside);
    std::vector<Curve> pins;
    for (const Vec2 at : {side, Vec2{-side.x, side.y}, Vec2{0, y + 0.01}, Vec2{0, -y}})
      pins.push_back(shapes::circle(at, kPin));
    const Region pocket =
        make_region(shapes::polygon({{-60, -45}, {60, -45}, {60, 45}, {-60, 45}}), pins);
    const std::vector<Region> places = offset({pocket}, -3);
    ASSERT_EQ(places.size(), 1u);
    const Area exact(places);
    StageLimits limits;
    limits.widest = turn;
    double deepest = 0;
    for (const Stage& stage : make_stages(places.front(), limits))
      for (const Curve& curve : stage.centres.curves())
        for (const Segment& piece : curve.segments())
          for (int i = 0; i < 20; ++i)
            deepest = std::max(deepest, -exact.signed_distance(piece.point(i / 20.0)));
    EXPECT_LT(deepest, 1e-5) << turn;
  }
}

}  // namespace
}  // namespace evenload
