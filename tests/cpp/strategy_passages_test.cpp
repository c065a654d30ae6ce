// Narrow passages that are cut at a reduced feed, or skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "corpus.h"
#include "feed/feed_control.h"
#include "feed/feed_limit.h"
#include "feed/load_profile.h"
#include "judged.h"
#include "strategy/constant_engagement.h"
#include "strategy/passage_clearing.h"
#include "strategy/passage_report.h"
#include "support/errors.h"

namespace evenload {
namespace {

using corpus::Case;
using corpus::judge;
using corpus::nominal_rate;
using path_check::Findings;

constexpr double kDegree = kPi / 180;

// A pocket for a tool of 6 mm at 60 degrees.
Case pocket_of(std::vector<Vertex> outer, std::vector<Curve> islands = {}) {
  Case pocket = corpus::load("slot62");
  pocket.region = make_region(Curve(std::move(outer), true), std::move(islands));
  return pocket;
}

Case slot(double width, double angle = 0) {
  const double h = width / 2;
  return corpus::moved(pocket_of({{{-20, -h}}, {{20, -h}}, {{20, h}}, {{-20, h}}}), angle, false,
                       {});
}

// Two rooms of 18 x 20 mm, 12 mm apart.
Case two_rooms(double width) {
  const double h = width / 2;
  return pocket_of({{{0, -9}},
                    {{20, -9}},
                    {{20, -h}},
                    {{32, -h}},
                    {{32, -9}},
                    {{52, -9}},
                    {{52, 9}},
                    {{32, 9}},
                    {{32, h}},
                    {{20, h}},
                    {{20, 9}},
                    {{0, 9}}});
}

Case ring(double width) {
  const double inner = 20 - width / 2, outer = 20 + width / 2;
  return pocket_of({{{outer, 0}, 1}, {{-outer, 0}, 1}},
                   {Curve({{{inner, 0}, 1}, {{-inner, 0}, 1}}, true)});
}

Case dead_end(double width) {
  return pocket_of({{{0, 0}},
                    {{25, 0}},
                    {{25, 10}},
                    {{45, 10}},
                    {{45, 10 + width}},
                    {{25, 10 + width}},
                    {{25, 25}},
                    {{0, 25}}});
}

Toolpath clear(const Case& pocket, NarrowPassages choice,
               FeedControl control = FeedControl::kConstantFeed) {
  ClearingParams params = pocket.params();
  params.narrow_passages = choice;
  params.feed_control = control;
  return corpus::clear(pocket, params);
}

void expect_cleared(const Case& pocket, const Toolpath& path) {
  const Findings found = judge(pocket, path);
  EXPECT_EQ(path.report.termination, Termination::kComplete)
      << (path.report.notes.empty() ? "" : path.report.notes.back());
  EXPECT_LE(found.gouge, 0.005);
  EXPECT_LE(found.left_share, 0.0005);
  EXPECT_LE(found.link_engagement, 1 * kDegree);
  EXPECT_EQ(found.bad_plunges, 0);
}

int entries(const Toolpath& path) {
  int count = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    count += path.moves[i].kind == MoveKind::kEntry && path.moves[i - 1].kind != MoveKind::kEntry;
  return count;
}

int notes_with(const Toolpath& path, const std::string& words) {
  const auto has = [&](const std::string& note) { return note.find(words) != std::string::npos; };
  return static_cast<int>(std::count_if(path.report.notes.begin(), path.report.notes.end(), has));
}

TEST(ReducedFeed, CutsSlotsHardlyWiderThanTheToolFullyAndInFewMoves) {
  for (const double width : {6.01, 6.02, 6.05, 6.1, 6.2, 7.0})
    for (const double angle : {0.0, 0.3}) {
      SCOPED_TRACE(width);
      const Case pocket = slot(width, angle);
      for (const FeedControl control :
           {FeedControl::kConstantFeed, FeedControl::kConstantRemovalRate}) {
        const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed, control);
        expect_cleared(pocket, path);
        EXPECT_LE(judge(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
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
  ASSERT_EQ(path.report.notes.size(), 1u);
  double x = 0, y = 0, width = 0, degrees = 0, feed = 0;
  ASSERT_EQ(std::sscanf(path.report.notes.front().c_str(),
                        "Cut at reduced feed: the passage near (%lf, %lf), %lf mm wide at its "
                        "narrowest, with up to %lf° engaged, down to %lf mm/min.",
                        &x, &y, &width, &degrees, &feed),
            5)
      << path.report.notes.front();
  EXPECT_TRUE(pocket.region.contains({x, y}));
  EXPECT_NEAR(width, 6.1, 0.006);
  EXPECT_NEAR(degrees, 180, 1);
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
    EXPECT_EQ(notes_with(path, "Cut at reduced feed"), 1);
  }
}

TEST(ReducedFeed, CutsDeadEndsAndRings) {
  for (const double width : {6.02, 6.5}) {
    SCOPED_TRACE(width);
    for (const Case& pocket : {dead_end(width), ring(width)}) {
      const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
      expect_cleared(pocket, path);
      EXPECT_EQ(entries(path), 1);
      EXPECT_EQ(notes_with(path, "Cut at reduced feed"), 1);
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

// Two slots that cross.
Case cross(double width) {
  const double h = width / 2;
  return pocket_of({{{-20, -h}},
                    {{-h, -h}},
                    {{-h, -15}},
                    {{h, -15}},
                    {{h, -h}},
                    {{20, -h}},
                    {{20, h}},
                    {{h, h}},
                    {{h, 15}},
                    {{-h, 15}},
                    {{-h, h}},
                    {{-20, h}}});
}

Case open_slot(double width) {
  return pocket_of({{{0, 0}}, {{40, 0}, 0, true}, {{40, width}}, {{0, width}}});
}

double direction_at(const Move& from, const Move& move, bool at_end) {
  if (move.sweep == 0) return std::atan2(move.y - from.y, move.x - from.x);
  const double x = (at_end ? move.x : from.x) - move.cx, y = (at_end ? move.y : from.y) - move.cy;
  return std::atan2(y, x) + std::copysign(kPi / 2, move.sweep);
}

// Law: the tool never turns on the spot where a link begins or ends.
TEST(ReducedFeed, JoinsWaysByLinksThatAreTangentToThem) {
  int joints = 0;
  for (const double width : {6.01, 6.05, 6.3, 7.0})
    for (const Case& pocket : {slot(width), slot(width, 0.3), two_rooms(width), dead_end(width),
                               ring(width), cross(width), open_slot(width)}) {
      const Toolpath path = clear(pocket, NarrowPassages::kReducedFeed);
      const std::vector<Move>& m = path.moves;
      for (std::size_t i = 2; i < m.size(); ++i) {
        const bool cuts = m[i - 1].kind == MoveKind::kCut || m[i].kind == MoveKind::kCut;
        const bool links = m[i - 1].kind == MoveKind::kLink || m[i].kind == MoveKind::kLink;
        if (!cuts || !links || m[i].kind == MoveKind::kRapid || m[i - 1].kind == MoveKind::kRapid ||
            m[i].kind == MoveKind::kEntry || m[i - 1].kind == MoveKind::kEntry)
          continue;
        const double turn = wrap_signed(direction_at(m[i - 1], m[i], false) -
                                        direction_at(m[i - 2], m[i - 1], true));
        EXPECT_LT(std::abs(turn), 1 * kDegree)
            << width << " mm, at " << m[i - 1].x << ", " << m[i - 1].y;
        ++joints;
      }
    }
  EXPECT_GT(joints, 100);
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
    expect_cleared(pocket, path);
    EXPECT_LE(judge(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
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
    const RegionTask task{centres, {pocket.region}, false, false, hole, false, {}, {}};
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

TEST(ReducedFeed, ClearsEveryPocketOfTheCorpus) {
  for (const std::string& name : corpus::names()) {
    if (name == "too_small") continue;
    SCOPED_TRACE(name);
    const Case pocket = corpus::load(name);
    const Toolpath path =
        clear(pocket, NarrowPassages::kReducedFeed, FeedControl::kConstantRemovalRate);
    expect_cleared(pocket, path);
    EXPECT_LE(judge(pocket, path).removal_rate, corpus::most_rate(pocket));
  }
}

TEST(Skipping, LeavesThePassagesAndReportsTheirPlaceWidthAndArea) {
  const Case pocket = two_rooms(6.5);
  const Toolpath path = clear(pocket, NarrowPassages::kSkip);
  EXPECT_EQ(path.report.termination, Termination::kIncomplete);
  double x = 0, y = 0, width = 0, area = 0;
  ASSERT_EQ(notes_with(path, "Skipped: "), 1);
  ASSERT_EQ(std::sscanf(path.report.notes.back().c_str(),
                        "Skipped: the passage near (%lf, %lf), %lf mm wide at its narrowest; "
                        "%lf mm² stay uncut there.",
                        &x, &y, &width, &area),
            4)
      << path.report.notes.back();
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
  EXPECT_EQ(notes_with(path, "Skipped: "), 1);
}

// Law: counts are those of all levels.
TEST(Clearing, CountsPassesLinksAndRetractsOverAllLevels) {
  for (const NarrowPassages choice : {NarrowPassages::kTrochoid, NarrowPassages::kReducedFeed}) {
    const Case pocket = two_rooms(6.5);
    ClearingParams params = pocket.params();
    params.narrow_passages = choice;
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
  const Toolpath path = clear(pocket, NarrowPassages::kSkip);
  EXPECT_EQ(notes_with(path, "Turned more tightly"), 1);
  EXPECT_EQ(notes_with(path, "of 2 rooms, down to"), 1);
}

TEST(Skipping, SaysThatAPredrilledHoleLiesInASkippedPassage) {
  Case pocket = two_rooms(6.5);
  pocket.hole = corpus::Hole{{26, 0}, 6.3};
  try {
    clear(pocket, NarrowPassages::kSkip);
    FAIL() << "no error";
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.code(), GeometryErrorCode::kEntryOutside);
    EXPECT_NE(std::string(error.what()).find("narrow passage that is skipped"), std::string::npos)
        << error.what();
  }
  ClearingParams params = pocket.params();
  params.narrow_passages = NarrowPassages::kSkip;
  params.entry = EntryKind::kAutomatic;
  const Toolpath path = corpus::clear(pocket, params);
  EXPECT_EQ(notes_with(path,
                       "near (26.00, 0.00) lies in a narrow passage that is skipped: it was "
                       "not used."),
            1);
  EXPECT_EQ(entries(path), 2);
}

TEST(Skipping, SkipsNothingThatIsTwiceTheMinimumRadiusWide) {
  Case pocket = slot(6 + 2 * 0.9);
  EXPECT_EQ(notes_with(clear(pocket, NarrowPassages::kSkip), "Skipped"), 0);
  pocket = slot(6 + 2 * 0.9 - 0.01);
  EXPECT_EQ(notes_with(clear(pocket, NarrowPassages::kSkip), "Skipped"), 1);
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
  for (const double width : {6.01, 6.05, 6.15}) {
    SCOPED_TRACE(width);
    const double h = width / 2;
    const Case short_slot = pocket_of({{{-4, -h}}, {{4, -h}}, {{4, h}}, {{-4, h}}});
    for (const Case& pocket : {slot(width), slot(width, 0.3), short_slot, two_rooms(width)}) {
      const Toolpath path =
          clear(pocket, NarrowPassages::kTrochoid, FeedControl::kConstantRemovalRate);
      expect_cleared(pocket, path);
      EXPECT_LE(judge(pocket, path).removal_rate, 1.05 * nominal_rate(pocket));
      EXPECT_LT(path.moves.size(), 1000u);
      EXPECT_EQ(notes_with(path, "Cut at reduced feed, too narrow for trochoids: the passage"), 1);
    }
  }
}

TEST(NarrowChoice, CutsByTrochoidsWithinTheLimitWhereTheyHaveRoom) {
  for (const Case& pocket :
       {slot(6.2), two_rooms(6.17), two_rooms(6.2), corpus::load("acute_wedge")}) {
    const Toolpath path = clear(pocket, NarrowPassages::kTrochoid);
    EXPECT_EQ(notes_with(path, "Cut at reduced feed"), 0) << pocket.name;
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
  set_constant_feed(runs, {200, 400, 1000});
  apply_feed_limits(runs);
  EXPECT_EQ(runs[0].moves[0].feed, 200);
  EXPECT_NEAR(runs[0].moves[1].feed, 50, 1e-9);
  EXPECT_EQ(runs[0].moves[2].feed, 200);
}

}  // namespace
}  // namespace evenload
