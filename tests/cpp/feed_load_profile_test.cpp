// What a finished path meets, looked at anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "feed/load_profile.h"
#include "toolpath/small_arc.h"

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

// What a left turn is taken to remove, over what it removes. The pass before turned the same,
// `apart` mm behind.
double allowed_for_turn(double radius, double sweep, double apart) {
  ClearedGround ground({{-15, -15}, {15, 15}}, kRadius, nullptr);
  const Vec2 centre{0, radius};
  ground.add(Segment::arc(centre - Vec2{apart, 0}, radius, -kPi / 2, sweep));
  std::vector<PlanarRun> runs(1);
  runs[0].moves.resize(1);
  runs[0].moves[0].segment = Segment::arc(centre, radius, -kPi / 2, sweep);
  const LoadShare width = [](const Load& load, const std::vector<AngularInterval>&) {
    return load.width;
  };
  double taken = 0, removed = 0;
  for (const LoadSample& sample : load_profile(runs, ground, 0.3, width)) {
    taken += sample.share * sample.length;
    removed += sample.width * sample.length;
  }
  return taken / removed;
}

TEST(LoadProfile, AllowsForRoundingWherePassesLieMicrometresApart) {
  // Just below 0.06 of the tool's radius, and above, where rounding turns the path by less.
  const auto more_below = [](double apart) {
    return allowed_for_turn(0.179, 2, apart) - allowed_for_turn(0.181, 2, apart);
  };
  EXPECT_GT(more_below(0.002), 0.02);
  EXPECT_GT(more_below(0.004), 0.01);
  EXPECT_NEAR(more_below(0.1), 0, 0.005);
}

TEST(LoadProfile, AllowsForTheLinesThatArePostedForTightArcs) {
  ASSERT_TRUE(becomes_corners(0.09, 0.72));
  ASSERT_FALSE(becomes_corners(0.09, 0.75));
  EXPECT_GT(allowed_for_turn(0.09, 0.72, 0.01), 0.005 + allowed_for_turn(0.09, 0.75, 0.01));
}

// Lines to and fro, each a side step further; a look at two of them at a time is too little for two
// cores.
std::vector<PlanarRun> rows(int count) {
  std::vector<PlanarRun> runs(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double y = -0.7 * i, side = i % 2 == 0 ? 1 : -1;
    PlanarMove cut, back;
    cut.segment = Segment::line({-20 * side, y}, {20 * side, y});
    back.kind = MoveKind::kLink;
    back.segment = Segment::line(cut.segment.b, cut.segment.b - Vec2{0, 0.7});
    runs[static_cast<std::size_t>(i)].descent.at = cut.segment.a;
    runs[static_cast<std::size_t>(i)].moves = {cut, back};
  }
  return runs;
}

TEST(LoadProfile, IsTheSameOnTwoCores) {
  const std::vector<PlanarRun> all = rows(9);
  const Bounds bounds{{-25, -15}, {25, 5}};
  ClearedGround ground(bounds, kRadius, nullptr), row_by_row(bounds, kRadius, nullptr);
  const std::vector<LoadSample> whole = load_profile(all, ground, 0.3);
  std::size_t i = 0;
  double met = 0;
  for (std::size_t run = 0; run < all.size(); ++run)
    for (const LoadSample& sample : load_profile({all[run]}, row_by_row, 0.3)) {
      ASSERT_LT(i, whole.size());
      EXPECT_EQ(whole[i].run, run);
      EXPECT_EQ(whole[i].move, sample.move);
      EXPECT_EQ(whole[i].t, sample.t);
      EXPECT_EQ(whole[i].engagement, sample.engagement);
      EXPECT_EQ(whole[i].width, sample.width);
      met += sample.engagement * sample.length;
      ++i;
    }
  EXPECT_EQ(i, whole.size());
  EXPECT_GT(met, 100);
  EXPECT_EQ(ground.size(), row_by_row.size());
}

}  // namespace
}  // namespace evenload
