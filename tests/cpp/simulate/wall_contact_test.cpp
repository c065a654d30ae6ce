// Which places of a tool leave a wall, on stocks that were cut in known ways.
#include "simulate/wall_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

constexpr double kRadius = 3, kFloor = -3;  // mm

// A square of 20 mm about the origin, cut out of a block with corners as round as the tool.
DexelStock with_pocket(double turn) {
  DexelStock stock({{turned(rectangle(-30, -30, 30, 30), turn), 0}}, kFloor, kFine);
  for (double y = -7; y <= 7; y += 3.5)
    stock.cut(Segment::line(rotated({-7, y}, turn), rotated({7, y}, turn)), kRadius, kFloor);
  for (const double x : {-7.0, 7.0})
    stock.cut(Segment::line(rotated({x, -7}, turn), rotated({x, 7}, turn)), kRadius, kFloor);
  return stock;
}

bool stands(const DexelStock& stock, Vec2 p, double feed_angle, double z = kFloor) {
  return stands_beside(stock, {{p, kRadius, z, feed_angle}}).front() != 0;
}

TEST(WallContact, IsAlongTheWallsOfAPocketOnEitherSide) {
  for (const double turn : {0.0, 0.3, kPi / 4, 2.0}) {
    const DexelStock stock = with_pocket(turn);
    for (double x = -6.9; x < 7; x += 0.37)
      for (const double feed : {0.0, kPi}) {
        EXPECT_TRUE(stands(stock, rotated({x, -7}, turn), turn + feed)) << turn << ", " << x;
        EXPECT_TRUE(stands(stock, rotated({7, x}, turn), turn + kPi / 2 + feed)) << turn;
        EXPECT_FALSE(stands(stock, rotated({x, -3.5}, turn), turn + feed)) << turn << ", " << x;
      }
    EXPECT_FALSE(stands(stock, rotated({0, -6.7}, turn), turn)) << turn;
  }
}

TEST(WallContact, IsNotAheadOfATool) {
  const DexelStock stock = with_pocket(0);
  EXPECT_FALSE(stands(stock, {7, 0}, 0));
  EXPECT_FALSE(stands(stock, {7, 0}, kPi));
}

TEST(WallContact, GoesRoundTheCornersOfAnIsland) {
  for (const double turn : {0.0, 0.3, kPi / 4, 2.0}) {
    const DexelStock stock({{turned(rectangle(-5.013, -5.029, 5.007, 5.031), turn), 0}}, kFloor,
                           kFine);
    for (double angle = 0.05; angle < kPi / 2; angle += 0.1) {
      const Vec2 p = Vec2{5.007, 5.031} + kRadius * unit(angle);
      EXPECT_TRUE(stands(stock, rotated(p, turn), turn + angle + kPi / 2)) << turn << " " << angle;
    }
  }
}

TEST(WallContact, IsWithWhatIsHigherThanTheFloorAndBelowTheLevel) {
  DexelStock stock({{rectangle(-30, -30, 30, 30), 0}}, kFloor, kFine);
  stock.cut(Segment::line({-40, 0}, {40, 0}), kRadius, kFloor);
  stock.cut(Segment::line({-40, 4}, {40, 4}), kRadius, -1);
  // The step beside the groove is a wall at its floor, and none for a tool on top of it.
  EXPECT_TRUE(stands_beside(stock, {{{0, 0}, kRadius, kFloor, 0}}).front());
  EXPECT_FALSE(stands_beside(stock, {{{0, 1}, kRadius, -1, 0}}).front());
  // Nor is what a floor is uneven by.
  EXPECT_FALSE(stands_beside(stock, {{{0, 1}, kRadius, -1 - 0.5 * kLeastWall, 0}}).front());
}

}  // namespace
}  // namespace evenload
