// What a finished path meets, looked at anew.
#include "feed/load_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "feed/following_profile.h"
#include "judge/numbers.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

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

// ---- behind the path that is being made ----

const Bounds kRowField{{-25, -15}, {25, 5}};

std::vector<PlanarRun> first_of(std::vector<PlanarRun> runs, std::size_t count) {
  runs.resize(count);
  return runs;
}

// What FollowingProfile makes of `runs` after it was told `told`, one after the other, from the
// run of that number on.
struct Told {
  std::vector<PlanarRun> runs;
  std::size_t first = 0;
};
void expect_as_looked_at_anew(const std::vector<PlanarRun>& runs, const std::vector<Told>& told) {
  ClearedGround anew(kRowField, kRadius, nullptr), ground(kRowField, kRadius, nullptr);
  const std::vector<LoadSample> expected = load_profile(runs, anew, 0.3);
  FollowingProfile following(ground, 0.3, nullptr);
  for (const Told& more : told) following.follow(more.runs, more.first);
  Progress progress;
  const std::vector<LoadSample> found = following.finish(runs, progress);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].run, expected[i].run);
    EXPECT_EQ(found[i].move, expected[i].move);
    EXPECT_EQ(found[i].t, expected[i].t);
    EXPECT_EQ(found[i].length, expected[i].length);
    EXPECT_EQ(found[i].engagement, expected[i].engagement);
    EXPECT_EQ(found[i].width, expected[i].width);
  }
  ASSERT_EQ(ground.size(), anew.size());
  std::vector<AngularInterval> a, b;
  for (double x = -20; x <= 20; x += 0.7) {
    ground.uncovered({x, -4}, 0, 2 * kPi, a);
    anew.uncovered({x, -4}, 0, 2 * kPi, b);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].width(), b[i].width());
  }
}

TEST(FollowingProfile, IsThatOfThePathHoweverItWasTold) {
  const std::vector<PlanarRun> all = rows(9);
  std::vector<Told> one_by_one, move_by_move, part_by_part;
  for (std::size_t n = 1; n <= all.size(); ++n) {
    one_by_one.push_back({first_of(all, n)});
    std::vector<PlanarRun> begun = first_of(all, n);
    begun.back().moves.pop_back();
    move_by_move.push_back({begun});
    move_by_move.push_back({first_of(all, n)});
    part_by_part.push_back({{all[n - 1]}, n - 1});
  }
  expect_as_looked_at_anew(all, {});
  expect_as_looked_at_anew(all, {{all}});
  expect_as_looked_at_anew(all, {{first_of(all, 5)}});  // the rest is looked at in the end
  expect_as_looked_at_anew(all, one_by_one);
  expect_as_looked_at_anew(all, move_by_move);
  expect_as_looked_at_anew(all, part_by_part);
}

TEST(FollowingProfile, IsThatOfThePathWhateverElseWasTold) {
  const std::vector<PlanarRun> all = rows(9);
  std::vector<PlanarRun> other = all, longer = rows(10);
  other[7].moves[0].segment = Segment::line(other[7].moves[0].segment.a, {0, 0});
  expect_as_looked_at_anew(all, {{other}});
  expect_as_looked_at_anew(all, {{longer}});
  expect_as_looked_at_anew(all, {{first_of(all, 2)}});            // too little to go on from
  expect_as_looked_at_anew(all, {{first_of(all, 3)}, {all, 6}});  // with a gap
  other = all;
  other[3].descent.kind = DescentKind::kHelix;
  other[3].descent.radius = 1;
  expect_as_looked_at_anew(all, {{other}});
  expect_as_looked_at_anew(other, {{all}});
}

TEST(FollowingProfile, LooksAtNothingTwiceThatItWasTold) {
  const std::vector<PlanarRun> all = rows(9);
  std::atomic<int> looks = 0;
  const LoadShare counts = [&](const Load& load, const std::vector<AngularInterval>&) {
    ++looks;
    return load.width;
  };
  ClearedGround plain(kRowField, kRadius, nullptr), ground(kRowField, kRadius, nullptr);
  load_profile(all, plain, 0.3, counts);
  const int once = looks.exchange(0);
  Progress progress;
  FollowingProfile following(ground, 0.3, counts);
  following.follow(first_of(all, 5), 0);
  following.follow(first_of(all, 8), 0);
  following.finish(all, progress);
  EXPECT_EQ(looks, once);
}

TEST(FollowingProfile, NeedNotBeFinished) {
  ClearedGround ground(kRowField, kRadius, nullptr);
  for (int round = 0; round < 20; ++round) {
    FollowingProfile following(ground, 0.01, nullptr);
    if (round % 4) following.follow(rows(9), 0);
  }
  EXPECT_EQ(ground.size(), 0u);
}

TEST(FollowingProfile, ThrowsWhatIsThrownBehindThePath) {
  ClearedGround ground(kRowField, kRadius, nullptr);
  const LoadShare fails = [](const Load&, const std::vector<AngularInterval>&) -> double {
    throw std::runtime_error("no share");
  };
  const std::vector<PlanarRun> all = rows(9);
  Progress progress;
  FollowingProfile following(ground, 0.3, fails);
  following.follow(all, 0);
  EXPECT_THROW(following.finish(all, progress), std::runtime_error);
}

TEST(FollowingProfile, DoesNotThrowForMovesThatAreNotInThePath) {
  ClearedGround ground(kRowField, kRadius, nullptr);
  const LoadShare fails_below = [](const Load& load, const std::vector<AngularInterval>&) {
    if (load.width > 2) throw std::runtime_error("too wide");
    return load.width;
  };
  std::vector<PlanarRun> deep = rows(9);
  for (PlanarRun& run : deep)
    for (PlanarMove& move : run.moves) move.segment = Segment::line({-20, 1.5}, {20, 1.5});
  Progress progress;
  FollowingProfile following(ground, 0.3, fails_below);
  following.follow(deep, 0);
  ground.add(Segment::line({-20, 0}, {20, 0}));
  EXPECT_FALSE(following.finish(rows(1), progress).empty());
}

}  // namespace
}  // namespace evenload
