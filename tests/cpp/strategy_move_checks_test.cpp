#include <gtest/gtest.h>

#include "geometry_shapes.h"
#include "strategy/move_checks.h"

namespace evenload {
namespace {

const Area& square() {
  static const Area area({make_region(shapes::rectangle(0, 0, 10, 10))});
  return area;
}

TEST(MoveChecks, MovesAreTangentWhereTheOneGoesOnAsTheOtherEnds) {
  const Segment line = Segment::line({0, 0}, {5, 0});
  const Segment arc = Segment::arc({5, 2}, 2, -kPi / 2, 1);
  EXPECT_TRUE(is_tangent(line, arc, 1e-6));
  EXPECT_FALSE(is_tangent(arc, line, 1e-6));
  const Segment bent = Segment::line({5, 0}, {10, 5e-5});  // by 1e-5
  EXPECT_TRUE(is_tangent(line, bent, 2e-5));
  EXPECT_FALSE(is_tangent(line, bent, 5e-6));
}

TEST(MoveChecks, AMoveFollowsTheBorderWhereAllOfItLiesThere) {
  EXPECT_TRUE(follows_border(Segment::line({1, 0}, {9, 0}), square()));
  EXPECT_FALSE(follows_border(Segment::line({1, 1e-5}, {9, 1e-5}), square()));
  EXPECT_FALSE(follows_border(Segment::line({0, 0}, {10, 10}), square()));  // its ends only
}

TEST(MoveChecks, AMoveIsInsideUpToTheTolerance) {
  EXPECT_TRUE(is_inside(Segment::line({0, 0}, {10, 10}), square(), 1e-6));
  const Segment beside = Segment::line({1, -1e-5}, {9, -1e-5});
  EXPECT_FALSE(is_inside(beside, square(), 1e-6));
  EXPECT_TRUE(is_inside(beside, square(), 2e-5));
  EXPECT_FALSE(is_inside(Segment::line({5, 5}, {10.1, 5}), square(), 1e-6));
}

}  // namespace
}  // namespace evenload
