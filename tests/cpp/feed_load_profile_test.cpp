// What a finished path meets, looked at anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "feed/load_profile.h"

namespace evenload {
namespace {

constexpr double kRadius = 3;

TEST(LoadProfile, SeesATightTurnAwayFromMaterialAfterAJointThatIsNotQuiteTangent) {
  for (const double kink : {0.0, 0.002, 0.01, 0.3}) {
    ClearedGround ground({{-15, -15}, {15, 15}}, kRadius, nullptr);
    ground.add(Segment::line({-10, 1}, {10, 1}));
    std::vector<PlanarRun> runs(1);
    runs[0].descent.at = {-10, 0};
    PlanarMove straight, turn;
    straight.segment = Segment::line({-10, 0}, {0, 0});
    const double heading = kink, radius = 0.08;
    turn.segment = Segment::arc(radius * left_normal(unit(heading)), radius, heading - kPi / 2, 2);
    runs[0].moves = {straight, turn};
    double most = 0, covered = 0;
    for (const LoadSample& sample : load_profile(runs, ground, 0.3)) {
      if (sample.move != 1) continue;
      most = std::max(most, sample.engagement);
      covered += sample.length;
    }
    // In a straight line it met what a side step of 1 mm gives; a turn to the left takes from that.
    EXPECT_GT(most, 0.6 * (std::acos(1 - 1 / kRadius) - kink)) << kink;
    EXPECT_NEAR(covered, turn.segment.length(), 1e-9);
  }
}

}  // namespace
}  // namespace evenload
