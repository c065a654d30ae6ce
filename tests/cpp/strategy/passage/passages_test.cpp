// Narrow passages that are skipped, and the choice of what is done with them.
#include <gtest/gtest.h>

#include <cstdio>

#include "geometry/shapes.h"
#include "judge/narrow_pockets.h"
#include "strategy/task/clearing_params.h"
#include "support/errors.h"

namespace evenload {
namespace {

using corpus::judge;
using corpus::nominal_rate;
using narrow_pockets::Case;
using narrow_pockets::clear;
using narrow_pockets::entries;
using narrow_pockets::expect_cleared;
using narrow_pockets::pocket_of;
using narrow_pockets::reduced;
using narrow_pockets::skipped;
using narrow_pockets::slot;
using narrow_pockets::two_rooms;
using path_check::Findings;

TEST(Skipping, LeavesThePassagesAndReportsTheirPlaceWidthAndArea) {
  const Case pocket = two_rooms(6.5);
  const Toolpath path = clear(pocket, NarrowPassages::kSkip);
  EXPECT_EQ(path.report.termination, Termination::kIncomplete);
  ASSERT_EQ(skipped(path), 1);
  const Finding& told = path.report.findings.back();
  ASSERT_EQ(told.code, FindingCode::kPassageSkipped);
  const auto [x, y] = *told.where;
  const double width = told.numbers[0], area = told.numbers[1];
  EXPECT_NEAR(x, 26, 1);
  EXPECT_NEAR(y, 0, 0.1);
  EXPECT_NEAR(width, 6.5, 0.006);
  EXPECT_NEAR(area, path.report.uncut_area, 0.01);
  const Findings found = judge(pocket, path);
  EXPECT_NEAR(area, found.left_area, 0.05 * found.left_area);
  EXPECT_LE(found.cut_engagement, pocket.engagement_angle + 2 * kDegree);
  EXPECT_EQ(found.bad_plunges, 0);
  EXPECT_EQ(entries(path), 2) << "each room has its own entry";
}

TEST(Skipping, SkipsAPocketThatIsNarrowThroughout) {
  const Toolpath path = clear(slot(6.2), NarrowPassages::kSkip);
  EXPECT_TRUE(path.moves.empty());
  EXPECT_NEAR(path.report.uncut_area, 40 * 6.2 - (4 - kPi) * 9, 3);
  EXPECT_EQ(path.report.termination, Termination::kIncomplete);
  EXPECT_EQ(skipped(path), 1);
}

// Law: counts are those of all levels.
TEST(Clearing, CountsPassesLinksAndRetractsOverAllLevels) {
  for (const NarrowPassages choice : {NarrowPassages::kTrochoid, NarrowPassages::kReducedFeed}) {
    const Case pocket = two_rooms(6.5);
    ClearingParams params = pocket.params();
    params.narrow_passages = choice;
    params.levels = {-1};
    const Report one = corpus::clear(pocket, params).report;
    params.levels = {-1, -2, -3};
    const Report three = corpus::clear(pocket, params).report;
    EXPECT_GT(one.passes, 10);
    EXPECT_GT(one.links, 10);
    EXPECT_EQ(three.passes, 3 * one.passes);
    EXPECT_EQ(three.links, 3 * one.links);
    EXPECT_EQ(three.retracts + 1, 3 * (one.retracts + 1));
  }
}

// One sentence, however many rooms turn tightly.
TEST(Clearing, NamesTheTightestTurnOfAllRoomsOnce) {
  const Case pocket = two_rooms(6.5);
  ClearingParams params = pocket.params();
  params.narrow_passages = NarrowPassages::kSkip;
  params.roll_radius = 7;  // the tool's centre has a room of 12 x 14 mm
  const Toolpath path = corpus::clear(pocket, params);
  const std::vector<Finding> told = corpus::findings_of(path.report, FindingCode::kTightTurns);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].numbers[2], 2) << "rooms";
}

TEST(Skipping, SaysThatAPredrilledHoleLiesInASkippedPassage) {
  Case pocket = two_rooms(6.5);
  pocket.hole = corpus::Hole{{26, 0}, 6.3};
  try {
    clear(pocket, NarrowPassages::kSkip);
    FAIL() << "no error";
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.code(), GeometryErrorCode::kEntryOutside);
    EXPECT_EQ(error.refusal(), Refusal::kHoleInSkippedPassage);
  }
  ClearingParams params = pocket.params();
  params.narrow_passages = NarrowPassages::kSkip;
  params.entry = EntryKind::kAutomatic;
  const Toolpath path = corpus::clear(pocket, params);
  const std::vector<Finding> told =
      corpus::findings_of(path.report, FindingCode::kHoleInSkippedPassage);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_LT(distance(*told[0].where, {26, 0}), 1e-9);
  EXPECT_EQ(entries(path), 2);
}

TEST(Skipping, SkipsNothingThatIsTwiceTheMinimumRadiusWide) {
  Case pocket = slot(6 + 2 * 0.9);
  EXPECT_EQ(skipped(clear(pocket, NarrowPassages::kSkip)), 0);
  pocket = slot(6 + 2 * 0.9 - 0.01);
  EXPECT_EQ(skipped(clear(pocket, NarrowPassages::kSkip)), 1);
}

TEST(Skipping, LeavesCornersToTheWallPass) {
  for (const char* name : {"square60", "lshape", "two_rooms_closed", "square_island"}) {
    const Case pocket = corpus::load(name);
    const Toolpath path = clear(pocket, NarrowPassages::kSkip);
    EXPECT_EQ(path.report.termination, Termination::kComplete) << name;
    EXPECT_LE(judge(pocket, path).left_share, 0.0005) << name;
  }
}

// Law of the choice: what is no narrower than allowed is cut as it always was.
TEST(NarrowChoice, ChangesNothingWhereThereIsNoPassage) {
  for (const char* name : {"square60", "circle12", "slot9"}) {
    const Case pocket = corpus::load(name);
    const Toolpath usual = clear(pocket, NarrowPassages::kTrochoid);
    const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
    ASSERT_EQ(path.moves.size(), usual.moves.size()) << name;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      ASSERT_EQ(path.moves[i].x, usual.moves[i].x) << name;
      ASSERT_EQ(path.moves[i].y, usual.moves[i].y) << name;
    }
  }
}

TEST(NarrowChoice, IsTheUsersWhereTheNeckIsWiderThanTheTool) {
  const Case pocket = two_rooms(6.5);
  const Toolpath path = clear(pocket, NarrowPassages::kTrochoid);
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_LE(judge(pocket, path).cut_engagement, pocket.engagement_angle + 2 * kDegree);
}

// Law: the work of a choice is bounded. Where no turn of trochoids has room, the slot is cut at a
// reduced feed, and the report says why.
TEST(NarrowChoice, CutsAtReducedFeedWhereTrochoidsHaveNoRoomToTurn) {
  for (const double width : {6.01, 6.05, 6.07}) {
    SCOPED_TRACE(width);
    for (const Case& pocket : {slot(width), slot(width, 0.3), two_rooms(width)}) {
      const Toolpath path =
          clear(pocket, NarrowPassages::kTrochoid, FeedControl::kConstantRemovalRate);
      EXPECT_LE(expect_cleared(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
      EXPECT_LT(path.moves.size(), 1000u);
      EXPECT_EQ(corpus::findings_of(path.report, FindingCode::kPassageReducedTooNarrow).size(), 1U);
    }
  }
}

// Along the walls of such a room half the tool would be engaged at once, in less than there is to
// cut at a reduced feed.
TEST(NarrowChoice, ClearsShortRoomsHardlyWiderThanTheToolByTheirDescentAlone) {
  const Region triangle =
      make_region(Curve({{{-0.04, -0.02}}, {{0.05, -0.02}}, {{0.01, 0.06}}}, true));
  const std::vector<Region> about = offset({triangle}, 3 + kWallGap);
  std::vector<Case> pockets{pocket_of(about.front().outer.vertices())};
  for (const double width : {6.01, 6.05, 6.1})
    for (const double length : {6.1, 6.4, 8.0}) {
      const double h = width / 2, l = length / 2;
      pockets.push_back(pocket_of({{{-l, -h}}, {{l, -h}}, {{l, h}}, {{-l, h}}}));
    }
  for (const Case& pocket : pockets) {
    const Toolpath path = clear(pocket, NarrowPassages::kTrochoid);
    SCOPED_TRACE(path.moves.size());
    expect_cleared(pocket, path);
    EXPECT_EQ(path.report.max_engagement, 0);
    EXPECT_EQ(entries(path), 1);
    EXPECT_EQ(reduced(path), 0);
    for (const Move& move : path.moves) EXPECT_NE(move.kind, MoveKind::kCut);
  }
}

// A ring whose width changes, as strokes of letters are drawn: the tool fits on one side only, and
// has little more than its width there.
TEST(NarrowChoice, CutsAStrokeAboutAsWideAsTheToolByOneWayAlongItsMiddle) {
  const Case pocket = pocket_of({{{20, 0}, 1}, {{-20, 0}, 1}}, {shapes::circle({0.3, 0}, 13.9)});
  const Toolpath path = clear(pocket, NarrowPassages::kTrochoid, FeedControl::kConstantRemovalRate);
  EXPECT_LE(expect_cleared(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
  EXPECT_LT(path.moves.size(), 300u);
  EXPECT_LT(path.report.cutting_time, 1.7 * path.report.ideal_time);
  EXPECT_LE(entries(path), 2);
}

TEST(NarrowChoice, CutsByTrochoidsWithinTheLimitWhereTheyHaveRoom) {
  for (const Case& pocket :
       {slot(6.2), two_rooms(6.1), two_rooms(6.2), corpus::load("acute_wedge")}) {
    const Toolpath path = clear(pocket, NarrowPassages::kTrochoid);
    EXPECT_EQ(reduced(path), 0) << pocket.name;
    EXPECT_LE(judge(pocket, path).cut_engagement, pocket.engagement_angle + 2 * kDegree);
  }
}

// A neck that the tool does not fit into parts two regions, whatever the choice.
TEST(NarrowChoice, LeavesANeckNarrowerThanTheToolAndEntersBothRooms) {
  for (const NarrowPassages choice :
       {NarrowPassages::kTrochoid, NarrowPassages::kReducedFeed, NarrowPassages::kSkip})
    for (const double width : {5.9, 5.0, 2.0}) {
      SCOPED_TRACE(width);
      const Case pocket = two_rooms(width);
      const Toolpath path = clear(pocket, choice);
      EXPECT_EQ(entries(path), 2);
      const Findings found = judge(pocket, path);
      EXPECT_LE(found.gouge, 0.005);
      EXPECT_EQ(found.bad_plunges, 0);
      if (choice != NarrowPassages::kSkip) {
        EXPECT_LE(found.left_share, 0.0005);
      }
    }
}

}  // namespace
}  // namespace evenload
