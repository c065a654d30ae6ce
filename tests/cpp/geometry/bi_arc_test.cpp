#include "geometry/bi_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "judge/numbers.h"

namespace evenload {
namespace {

TEST(BiArc, LeadsFromPlaceToPlaceWithoutACorner) {
  std::mt19937 random(1);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const auto place = [&] {
      return PlanePoint{{uniform(random, -5, 5), uniform(random, -5, 5)},
                        unit(uniform(random, -kPi, kPi))};
    };
    const PlanePoint from = place(), to = place();
    const std::optional<BiArc> pair = bi_arc(from, to, kPi);
    if (!pair) continue;
    ++found;
    EXPECT_LE(distance(pair->first.a, from.p), 1e-9);
    EXPECT_LE(distance(pair->second.b, to.p), 1e-9);
    EXPECT_LE(distance(pair->first.b, pair->second.a), 1e-9);
    EXPECT_LE(norm(pair->first.tangent(0) - from.direction), 1e-5);
    EXPECT_LE(norm(pair->first.tangent(1) - pair->second.tangent(0)), 1e-5);
    EXPECT_LE(norm(pair->second.tangent(1) - to.direction), 1e-5);
    EXPECT_LE(std::abs(pair->first.sweep), kPi + 1e-9);
    EXPECT_LE(std::abs(pair->second.sweep), kPi + 1e-9);
  }
  EXPECT_GT(found, 200);
}

TEST(BiArc, OfAStraightWayIsTwoLines) {
  const std::optional<BiArc> pair = bi_arc({{0, 0}, {1, 0}}, {{4, 0}, {1, 0}}, kPi);
  ASSERT_TRUE(pair);
  EXPECT_FALSE(pair->first.is_arc());
  EXPECT_FALSE(pair->second.is_arc());
  EXPECT_NEAR(pair->first.b.x, 2, 1e-12);
}

TEST(BiArc, HasItsJointSoManyTimesAsFarAlongTheFirstTangentAsAlongTheLast) {
  const PlanePoint from{{0, 0}, unit(0.3)}, to{{4, 1}, unit(1.4)};
  const auto reach = [](const Segment& arc) {
    return arc.is_arc() ? arc.radius * std::tan(0.5 * std::abs(arc.sweep)) : 0.5 * arc.length();
  };
  for (const double ratio : {0.2, 0.7, 1.0, 1.5, 4.0}) {
    const std::optional<BiArc> pair = bi_arc(from, to, kPi, ratio);
    ASSERT_TRUE(pair);
    EXPECT_NEAR(reach(pair->first) / reach(pair->second), ratio, 1e-6 * ratio);
    EXPECT_LE(distance(pair->second.b, to.p), 1e-9);
    EXPECT_LE(norm(pair->first.tangent(1) - pair->second.tangent(0)), 1e-6);
    EXPECT_LE(norm(pair->second.tangent(1) - to.direction), 1e-6);
  }
}

TEST(BiArc, DoesNotExistWhereItWouldTurnTooFar) {
  EXPECT_FALSE(bi_arc({{0, 0}, {-1, 0}}, {{4, 0}, {-1, 0}}, kPi));
  EXPECT_FALSE(bi_arc({{0, 0}, {0, 1}}, {{4, 0}, {0, -1}}, 0.4 * kPi));
  EXPECT_TRUE(bi_arc({{0, 0}, {0, 1}}, {{4, 0}, {0, -1}}, 0.6 * kPi));
}

}  // namespace
}  // namespace evenload
