// Narrow passages that are cut at a reduced feed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "feed/feed_control.h"
#include "feed/feed_limit.h"
#include "feed/load_profile.h"
#include "judge/narrow_pockets.h"
#include "strategy/passage/passage_clearing.h"
#include "strategy/passage/passage_report.h"

namespace evenload {
namespace {

using corpus::judge;
using corpus::nominal_rate;
using narrow_pockets::Case;
using narrow_pockets::clear;
using narrow_pockets::cross;
using narrow_pockets::dead_end;
using narrow_pockets::entries;
using narrow_pockets::expect_cleared;
using narrow_pockets::open_slot;
using narrow_pockets::reduced;
using narrow_pockets::ring;
using narrow_pockets::slot;
using narrow_pockets::two_rooms;

TEST(ReducedFeed, CutsSlotsHardlyWiderThanTheToolFullyAndInFewMoves) {
  for (const double width : {6.01, 6.02, 6.05, 6.1, 6.2, 7.0})
    for (const double angle : {0.0, 0.3}) {
      SCOPED_TRACE(width);
      const Case pocket = slot(width, angle);
      for (const FeedControl control :
           {FeedControl::kConstantFeed, FeedControl::kConstantRemovalRate}) {
        const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed, control);
        EXPECT_LE(expect_cleared(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
        EXPECT_LT(path.moves.size(), 100u);
      }
    }
}

// The whole tool is engaged: (1 - cos theta) / 2 of the feed.
TEST(ReducedFeed, LowersTheFeedToTheNominalRemovalRateAndSaysSo) {
  const Case pocket = slot(6.1);
  const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
  double lowest = 1e9, highest = 0;
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kCut) {
      lowest = std::min(lowest, move.feed);
      highest = std::max(highest, move.feed);
    }
  EXPECT_NEAR(lowest, pocket.feed / 4, 0.01 * pocket.feed);
  EXPECT_LE(highest, pocket.feed);
  EXPECT_NEAR(path.report.max_engagement, kPi, 1 * kDegree);
  ASSERT_EQ(path.report.findings.size(), 1U);
  const Finding& told = path.report.findings.front();
  ASSERT_EQ(told.code, FindingCode::kPassageReduced);
  const double width = told.numbers[0], left = told.numbers[1], engaged = told.numbers[2],
               feed = told.numbers[3];
  EXPECT_TRUE(pocket.region.contains(*told.where));
  EXPECT_EQ(left, 0);
  EXPECT_NEAR(width, 6.1, 0.006);
  EXPECT_NEAR(engaged, kPi, 1 * kDegree);
  EXPECT_NEAR(feed, lowest, 0.06);
}

// A ramp along the slot, and never a blind plunge.
TEST(ReducedFeed, ComesDownAlongTheSlotByARamp) {
  for (const double angle : {0.0, 0.3, 1.1}) {
    const Case pocket = slot(6.05, angle);
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    EXPECT_EQ(entries(path), 1);
    double longest = 0;
    for (std::size_t i = 1; i < path.moves.size(); ++i) {
      const Move &from = path.moves[i - 1], &to = path.moves[i];
      if (to.kind != MoveKind::kEntry || to.z > 0) continue;  // above the material straight down
      EXPECT_EQ(to.sweep, 0);
      const double flat = std::hypot(to.x - from.x, to.y - from.y);
      longest = std::max(longest, flat);
      EXPECT_LE(from.z - to.z, std::tan(pocket.params().helix_angle) * flat + 1e-9);
    }
    EXPECT_NEAR(longest, 9, 0.1);
  }
}

TEST(ReducedFeed, JoinsRoomsByTheirNeckAndClearsBothWithinTheLimit) {
  for (const double width : {6.01, 6.05, 6.5, 7.5}) {
    SCOPED_TRACE(width);
    const Case pocket = two_rooms(width);
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    expect_cleared(pocket, path);
    EXPECT_EQ(entries(path), 2);
    EXPECT_EQ(reduced(path), 1);
  }
}

TEST(ReducedFeed, CutsDeadEndsAndRings) {
  for (const double width : {6.02, 6.5}) {
    SCOPED_TRACE(width);
    for (const Case& pocket : {dead_end(width), ring(width)}) {
      const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
      expect_cleared(pocket, path);
      EXPECT_EQ(entries(path), 1);
      EXPECT_EQ(reduced(path), 1);
    }
  }
}

TEST(ReducedFeed, NeedsNoDescentButThatIntoAPredrilledHole) {
  for (const Vec2 at : {Vec2{8, 0}, Vec2{26, 0}}) {
    Case pocket = two_rooms(6.5);
    pocket.hole = corpus::Hole{at, 6.3};
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    expect_cleared(pocket, path);
    for (const Move& move : path.moves)
      if (move.kind == MoveKind::kEntry) {
        EXPECT_EQ(distance({move.x, move.y}, at), 0);
      }
  }
}

double direction_at(const Move& from, const Move& move, bool at_end) {
  if (move.sweep == 0) return std::atan2(move.y - from.y, move.x - from.x);
  const double x = (at_end ? move.x : from.x) - move.cx, y = (at_end ? move.y : from.y) - move.cy;
  return std::atan2(y, x) + std::copysign(kPi / 2, move.sweep);
}

// Law: the tool never turns on the spot where a link begins or ends, but goes back on its cut.
TEST(ReducedFeed, JoinsWaysByLinksThatAreTangentToThemOrGoBackOnThem) {
  int joints = 0, ways_back = 0;
  for (const double width : {6.01, 6.05, 6.3, 7.0})
    for (const Case& pocket : {slot(width), slot(width, 0.3), two_rooms(width), dead_end(width),
                               ring(width), cross(width), open_slot(width)}) {
      const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
      const std::vector<Move>& m = path.moves;
      for (std::size_t i = 2; i < m.size(); ++i) {
        const bool cuts = m[i - 1].kind == MoveKind::kCut || m[i].kind == MoveKind::kCut;
        const bool links = m[i - 1].kind == MoveKind::kLink || m[i].kind == MoveKind::kLink;
        if (!cuts || !links || m[i].kind == MoveKind::kRapid || m[i - 1].kind == MoveKind::kRapid ||
            m[i].kind == MoveKind::kEntry || m[i - 1].kind == MoveKind::kEntry ||
            m[i - 1].z != m[i - 2].z)  // straight down to where the next one begins
          continue;
        const double turn = wrap_signed(direction_at(m[i - 1], m[i], false) -
                                        direction_at(m[i - 2], m[i - 1], true));
        // At the end of a gap the tool goes back on the cut it made, or a little beside it.
        const bool is_back = kPi - std::abs(turn) < 7 * kDegree;
        EXPECT_TRUE(is_back || std::abs(turn) < 1 * kDegree)
            << width << " mm, at " << m[i - 1].x << ", " << m[i - 1].y;
        ++joints;
        ways_back += is_back;
      }
    }
  EXPECT_GT(joints, 100);
  EXPECT_LT(ways_back, 0.3 * joints);
}

// Law: an open end is passed by little more than the tool's radius, and ways in the air are short.
TEST(ReducedFeed, GoesNoFurtherOutOfAnOpenEndThanBesideTheMaterial) {
  for (const double width : {6.05, 6.3, 7.0}) {
    const Case pocket = open_slot(width);
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    EXPECT_EQ(path.report.termination, Termination::kComplete);
    EXPECT_LE(judge(pocket, path).left_share, 0.0005);
    for (const Move& move : path.moves)
      if (move.z < 0 && move.kind != MoveKind::kRapid) {
        EXPECT_LT(move.x, 40 + 1.6 * pocket.tool_diameter / 2) << width;
      }
  }
}

TEST(ReducedFeed, CutsSlotsThatCross) {
  for (const double width : {6.05, 6.5, 7.5}) {
    SCOPED_TRACE(width);
    const Case pocket = cross(width);
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    EXPECT_LE(expect_cleared(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
  }
}

// Above the engagement limit in passages, and nowhere else.
TEST(ReducedFeed, KeepsTheEngagementLimitOutsideOfPassages) {
  for (const Case& pocket : {two_rooms(6.05), dead_end(7), corpus::load("acute_wedge"),
                             corpus::load("room_behind_neck")}) {
    SCOPED_TRACE(pocket.name);
    ClearingParams params = pocket.params();
    params.narrow_passages = NarrowPassages::kReducedFeed;
    const double radius = 0.5 * params.tool_diameter;
    const Region centres = offset({pocket.region}, -(radius + kWallGap)).front();
    const DividedRegion narrow = divide(centres, params);
    ASSERT_FALSE(narrow.places.passages.empty());
    std::optional<Vec2> hole;
    if (pocket.hole) hole = pocket.hole->centre;
    RegionTask task;
    task.centres = centres;
    task.material = {pocket.region};
    task.hole = hole;
    Progress progress;
    const RegionResult result =
        clear_with_passages(task, narrow.places, narrow.axes, 0, params, progress);
    ClearedGround ground(bounds_of({pocket.region}), radius, nullptr);
    if (hole) ground.add_disc(*hole, 0.5 * params.hole_diameter);
    std::vector<PlanarRun> outside = result.runs;
    const std::vector<LoadSample> profile = load_profile(outside, ground, 1.0);
    double most = 0;
    for (const LoadSample& sample : profile)
      if (outside[sample.run].moves[sample.move].passage >= 0)
        most = std::max(most, sample.engagement);
    EXPECT_GT(most, params.engagement_angle);
    // The rest of the path by the windowed mean that limits hold for.
    for (PlanarRun& run : outside)
      for (PlanarMove& move : run.moves)
        if (move.passage >= 0) move.kind = MoveKind::kLink;
    EXPECT_LE(worst_engagement(outside, profile, 0.1), params.engagement_angle + 2 * kDegree);
  }
}

TEST(FeedLimits, HoldTheNominalRateInPassagesAndLeaveOtherMovesAlone) {
  PlanarMove wide, narrow, thin;
  wide.segment = narrow.segment = thin.segment = Segment::line({0, 0}, {10, 0});
  narrow.passage = thin.passage = 0;
  std::vector<PlanarRun> runs{{{}, {wide, narrow, thin}, true}};
  std::vector<LoadSample> profile(4);
  for (std::size_t i = 0; i < 4; ++i) profile[i].move = std::min<std::size_t>(i, 2);
  profile[0].width = 6;
  profile[1].width = 6;
  profile[2].width = 1;
  profile[3].width = 1.4;
  find_feed_limits(runs, profile, 200, 1.5);
  set_constant_feed(runs, {200, 400, 1000, {}, 0});
  apply_feed_limits(runs);
  EXPECT_EQ(runs[0].moves[0].feed, 200);
  EXPECT_NEAR(runs[0].moves[1].feed, 50, 1e-9);
  EXPECT_EQ(runs[0].moves[2].feed, 200);
}

}  // namespace
}  // namespace evenload
