#include "cutting/probe.h"

#include <gmock/gmock.h>

namespace evenload {
namespace {

constexpr double kToolRadius = 3;

ClearedGround slot_along_x() {
  ClearedGround ground({{-40, -40}, {40, 40}}, kToolRadius, nullptr);
  ground.add(Segment::line({-30, 0}, {30, 0}));
  return ground;
}

TEST(Probe, MeetsWhatASideStepGivesAlongAStraightWall) {
  const ClearedGround ground = slot_along_x();
  Probe probe(ground);
  for (const double side_step : {0.1, 1.5, 3.0, 4.5}) {
    const Segment move = Segment::line({-10, -side_step}, {10, -side_step});
    const double expected = std::acos(1 - side_step / kToolRadius);
    EXPECT_NEAR(probe.engagement(move, 0.5, kThin), expected, 1e-4) << side_step;
    EXPECT_TRUE(probe.touches(move, 0.5, kThin));
    const std::vector<AngularInterval>& arcs = probe.arcs({0, -side_step}, 0, kThin);
    ASSERT_EQ(arcs.size(), 1u);
    EXPECT_NEAR(arcs.front().low, -kPi / 2, 1e-12);  // to the right of the feed
  }
}

TEST(Probe, SeesNothingThinnerThanIsAskedForAndMoreForALargerTool) {
  const ClearedGround ground = slot_along_x();
  Probe probe(ground);
  const Segment beside = Segment::line({-10, -0.001}, {10, -0.001});
  EXPECT_TRUE(probe.touches(beside, 0.5, kThin));
  EXPECT_FALSE(probe.touches(beside, 0.5, 0.0011));
  EXPECT_FALSE(probe.touches(Segment::line({-10, 0}, {10, 0}), 0.5, kThin));
  EXPECT_TRUE(probe.touches(Segment::line({-10, 0}, {10, 0}), 0.5, -0.001));
}

TEST(Probe, LooksAtTheGroundAsItWasAndAsItBecomes) {
  ClearedGround ground = slot_along_x();
  Probe probe(ground);
  const Segment move = Segment::line({-10, -2}, {10, -2});
  const double before = probe.engagement(move, 0.5, kThin);
  ground.add(move);
  EXPECT_EQ(probe.engagement(move, 0.5, kThin), 0);
  EXPECT_EQ(probe.engagement(move, 0.5, kThin, ground.size() - 1), before);
}

TEST(Probe, LooksNoFurtherApartThanWished) {
  EXPECT_EQ(looks_along(0, 0.3), 1);
  EXPECT_EQ(looks_along(0.3, 0.3), 1);
  EXPECT_EQ(looks_along(0.301, 0.3), 2);
  EXPECT_EQ(looks_along(30, 0.5), 60);
}

}  // namespace
}  // namespace evenload
