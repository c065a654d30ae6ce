// Slots cleared by trochoids, judged by the tests' own judge.
#include "strategy/pocket/trochoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cutting/engagement.h"
#include "geometry/shapes.h"
#include "geometry/slot_around.h"
#include "judge/judged.h"
#include "judge/narrow_pockets.h"
#include "judge/path_check.h"
#include "strategy/trochoid/trochoid_pattern.h"
#include "support/errors.h"
#include "toolpath/helix.h"

namespace evenload {
namespace {

using narrow_pockets::line;
using shapes::rectangle;

ClearingParams params_at(double degrees = 60) {
  ClearingParams params;
  params.engagement_angle = degrees * kDegree;
  params.feed_control = FeedControl::kConstantRemovalRate;
  params.maximum_feed = 1000;
  params.roll_radius = 1;
  return params;
}

TrochoidalPath clear(const Region& region, const ClearingParams& params,
                     TrochoidKind kind = TrochoidKind::kConstantEngagement) {
  Progress progress;
  return clear_slot({region}, kind, params, progress);
}

path_check::Findings judge(const Region& region, const ClearingParams& params,
                           const TrochoidalPath& result) {
  path_check::Stock stock;
  stock.regions = {region};
  if (params.entry_point) {
    stock.hole = params.entry_point;
    stock.hole_radius = 0.5 * params.hole_diameter;
  }
  return path_check::check_path(stock, 0.5 * params.tool_diameter, result.path.moves);
}

bool tells(const TrochoidalPath& result, FindingCode code) {
  return corpus::tells(result.path.report, code);
}

// Why no pattern is repeated; nothing where one is.
std::optional<Finding> fallback_of(const TrochoidalPath& result) {
  for (const Finding& finding : result.path.report.findings)
    if (finding.code >= FindingCode::kNoPatternAfterCuts &&
        finding.code <= FindingCode::kNoPatternWithoutStart)
      return finding;
  return std::nullopt;
}

// What every path must keep, whatever its pattern.
void expect_good(const Region& region, const ClearingParams& params, const TrochoidalPath& result) {
  const path_check::Findings found = judge(region, params, result);
  EXPECT_LT(found.cut_engagement, params.engagement_angle + 1 * kDegree);
  EXPECT_LT(found.link_engagement, 1 * kDegree);
  EXPECT_LT(found.gouge, 0.005);
  EXPECT_LT(found.left_share, 5e-4);
  EXPECT_EQ(found.bad_plunges, 0);
  const double nominal = side_step(params.engagement_angle, 3) * params.feed;
  EXPECT_LT(found.removal_rate, 1.05 * nominal);
  const double wrong =
      params.cut_mode == CutMode::kClimb ? found.conventional_length : found.climb_length;
  EXPECT_LT(wrong, 0.005 * (found.climb_length + found.conventional_length));
  EXPECT_EQ(result.path.report.termination, Termination::kComplete);
  EXPECT_FALSE(tells(result, FindingCode::kLeftUncut));
  EXPECT_EQ(fallback_of(result).has_value(), result.report.step == 0);
}

TEST(ClearSlot, KeepsTheLimitInStraightSlotsOfEveryWidth) {
  for (const double width : {6.2, 6.4, 6.6, 7.5, 9.0, 12.0, 18.0})
    for (const double degrees : {30.0, 60.0, 90.0}) {
      if (degrees < 60 && width < 9) continue;  // thousands of periods
      SCOPED_TRACE(std::to_string(width) + " mm, " + std::to_string(degrees));
      const Region region = slot_around(line(45), width, SlotEnds::kRound);
      const ClearingParams params = params_at(degrees);
      const TrochoidalPath result = clear(region, params);
      expect_good(region, params, result);
      EXPECT_GT(result.report.length, 15);
      EXPECT_GT(result.report.step, 0);
      const bool has_circles = tells(result, FindingCode::kCirclesForPattern);
      EXPECT_EQ(has_circles, width < 6.3 && degrees < 90);
      EXPECT_EQ(result.report.iterations > 1, !has_circles);
      EXPECT_GT(result.report.removal_rate, 0);
      EXPECT_EQ(tells(result, FindingCode::kAdvanceUnsettled),
                result.report.residual >= kSettled * 3);
    }
}

TEST(ClearSlot, MakesWholePathsOfCirclesAndCycloids) {
  const Region region = slot_around(line(40), 10, SlotEnds::kSquare);
  const ClearingParams params = params_at();
  double least = 0;
  for (const TrochoidKind kind :
       {TrochoidKind::kConstantEngagement, TrochoidKind::kCircular, TrochoidKind::kCycloid}) {
    SCOPED_TRACE(static_cast<int>(kind));
    const TrochoidalPath result = clear(region, params, kind);
    expect_good(region, params, result);
    EXPECT_GT(result.report.length, 15);
    if (least == 0) least = result.path.report.cutting_time;
    EXPECT_GE(result.path.report.cutting_time, least);
    EXPECT_EQ(result.report.iterations > 0, kind == TrochoidKind::kConstantEngagement);
  }
}

TEST(ClearSlot, FollowsBentSlotsAndClearsJunctions) {
  const double quarter = std::tan(kPi / 8);
  const std::vector<Region> regions = {
      slot_around(Curve({{{30, 0}, std::tan(kPi / 4)}, {{-30, 0}}}, false), 10, SlotEnds::kRound),
      slot_around(Curve({{{0, 0}}, {{25, 0}, quarter}, {{45, 20}, -quarter}, {{65, 40}}}, false),
                  10, SlotEnds::kRound),
      make_region(shapes::polygon(
          {{0, 0}, {70, 0}, {70, 10}, {40, 10}, {40, 45}, {30, 45}, {30, 10}, {0, 10}})),
      make_region(shapes::polygon({{0, -4}, {50, -7}, {50, 7}, {0, 4}}))};
  for (std::size_t i = 0; i < regions.size(); ++i) {
    SCOPED_TRACE(i);
    const ClearingParams params = params_at();
    const TrochoidalPath result = clear(regions[i], params);
    expect_good(regions[i], params, result);
    // The last one's width changes: it is cleared pass by pass.
    EXPECT_EQ(result.report.length > 10, i < 3);
  }
}

TEST(ClearSlot, GoesOnBeyondTheCornerOfAnAngleAndIntoTheStemOfATee) {
  for (const double width : {7.5, 12.0}) {
    SCOPED_TRACE(width);
    const Region angle = make_region(
        shapes::polygon({{0, 0}, {60, 0}, {60, width}, {width, width}, {width, 60}, {0, 60}}));
    const Region tee = make_region(shapes::polygon({{0, 0},
                                                    {70, 0},
                                                    {70, width},
                                                    {35 + width / 2, width},
                                                    {35 + width / 2, 50},
                                                    {35 - width / 2, 50},
                                                    {35 - width / 2, width},
                                                    {0, width}}));
    const ClearingParams params = params_at();
    for (const Region& region : {angle, tee}) {
      const TrochoidalPath result = clear(region, params);
      expect_good(region, params, result);
      EXPECT_GT(result.report.length, 70);  // more than either arm
    }
  }
}

TEST(ClearSlot, StartsInAShortSlotWhereTheLongestEndsInOthers) {
  const Region comb = make_region(shapes::polygon(
      {{0, 0}, {50, 0}, {50, 40}, {40, 40}, {40, 10}, {10, 10}, {10, 40}, {0, 40}}));
  const ClearingParams params = params_at();
  const TrochoidalPath result = clear(comb, params);
  expect_good(comb, params, result);
  EXPECT_GT(result.report.length, 20);
}

// No side of a frame has an end: the first one begins past its corner.
TEST(ClearSlot, RepeatsItsPatternAlongTheSidesOfAFrame) {
  for (const double width : {8.0, 10.0}) {
    SCOPED_TRACE(width);
    const double h = width / 2;
    const Region frame =
        make_region(rectangle(-h, -h, 70 + h, 40 + h), {rectangle(h, h, 70 - h, 40 - h)});
    const ClearingParams params = params_at();
    const TrochoidalPath result = clear(frame, params);
    expect_good(frame, params, result);
    EXPECT_GT(result.report.length, 110);  // half of all round
  }
}

TEST(ClearSlot, CutsConventionallyInTheMirrorImage) {
  const Region region = slot_around(line(40), 10, SlotEnds::kRound);
  ClearingParams params = params_at();
  params.cut_mode = CutMode::kConventional;
  const TrochoidalPath result = clear(region, params);
  expect_good(region, params, result);
  EXPECT_GT(result.report.length, 15);
}

TEST(ClearSlot, StartsInAHoleAtAnEndAndInTheMiddle) {
  for (const double at : {0.0, 25.0}) {
    const Region region = slot_around(line(50), 12, SlotEnds::kRound);
    ClearingParams params = params_at();
    params.entry = EntryKind::kPredrilledHole;
    params.entry_point = Vec2{at, 0};
    params.hole_diameter = 8;
    const TrochoidalPath result = clear(region, params);
    expect_good(region, params, result);
    EXPECT_GT(result.report.length, 20);
    EXPECT_NEAR(result.path.moves.front().x, at, 1e-9);
  }
}

TEST(ClearSlot, StartsOutsideAnOpenEnd) {
  const Region region = slot_around(line(50), 10, SlotEnds::kOpen);
  const ClearingParams params = params_at();
  const TrochoidalPath result = clear(region, params);
  const Report& report = result.path.report;
  EXPECT_LT(report.max_engagement, params.engagement_angle + 1 * kDegree);
  EXPECT_EQ(report.termination, Termination::kComplete);
  EXPECT_NEAR(report.removed_volume, region.area() * 3, 0.01 * region.area() * 3);
  EXPECT_GT(result.report.length, 40);
  const double x = result.path.moves.front().x;
  EXPECT_TRUE(x < -3 || x > 53) << x;
  for (const Move& move : result.path.moves)
    if (move.kind == MoveKind::kEntry) {
      EXPECT_TRUE(move.x < -3 || move.x > 53) << move.x;
    }
}

TEST(ClearSlot, TakesAsLongWhereverTheSlotLies) {
  const Region region = slot_around(line(50), 9, SlotEnds::kRound);
  const ClearingParams params = params_at();
  const double time = clear(region, params).path.report.cutting_time;
  for (const double turn : {0.3, 1.5, 4.0}) {
    const Region moved = shapes::moved(region, turn, false, 1, {17, -230});
    const TrochoidalPath result = clear(moved, params);
    expect_good(moved, params, result);
    // Which end comes first, and where in it the helix, may differ.
    EXPECT_NEAR(result.path.report.cutting_time, time, 0.08 * time) << turn;
  }
}

void expect_fallback(const Region& region, TrochoidKind kind, FindingCode why,
                     CutMode mode = CutMode::kClimb) {
  ClearingParams params = params_at();
  params.cut_mode = mode;
  const TrochoidalPath result = clear(region, params, kind);
  EXPECT_EQ(result.report.step, 0);
  const std::optional<Finding> told = fallback_of(result);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->code, why);
  EXPECT_EQ(told->numbers, std::vector{static_cast<double>(kind)});
}

TEST(ClearSlot, KeepsTheLimitWhereTheFirstPeriodBeginsWhateverTheTolerance) {
  for (const double width : {6.2, 6.3, 7.5}) {
    SCOPED_TRACE(width);
    const Region region = slot_around(line(36), width, SlotEnds::kRound);
    ClearingParams params = params_at();
    params.tolerance = 0.1;
    const TrochoidalPath result = clear(region, params);
    EXPECT_LT(result.path.report.max_engagement, params.engagement_angle + 1 * kDegree);
    EXPECT_LT(judge(region, params, result).cut_engagement, params.engagement_angle + 1 * kDegree);
    EXPECT_GT(result.report.length, 15);
  }
}

TEST(ClearSlot, RepeatsCirclesWherePostsWouldMakeCornersOfTheTurns) {
  const ClearingParams params = params_at();
  const Region narrow = slot_around(line(40), 6.2, SlotEnds::kSquare);
  const TrochoidalPath path = clear(narrow, params);
  expect_good(narrow, params, path);
  EXPECT_TRUE(tells(path, FindingCode::kCirclesForPattern));
  EXPECT_EQ(path.report.iterations, 0);
  EXPECT_FALSE(
      tells(clear(narrow, params, TrochoidKind::kCircular), FindingCode::kCirclesForPattern));
  const TrochoidalPath wider = clear(slot_around(line(40), 7, SlotEnds::kSquare), params);
  EXPECT_FALSE(tells(wider, FindingCode::kCirclesForPattern));
  EXPECT_GT(wider.report.iterations, 0);
}

TEST(ClearSlot, TellsOfTurnsMoreTightThanWishedOncePerRegion) {
  const Region slot = slot_around(line(60), 9, SlotEnds::kSquare);
  const std::vector<Finding> told =
      corpus::findings_of(clear(slot, params_at()).path.report, FindingCode::kTightTurns);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].numbers[2], 1) << "rooms";
}

TEST(ClearSlot, TellsWhereAndWhyNoPatternIsRepeated) {
  const TrochoidKind ours = TrochoidKind::kConstantEngagement, circles = TrochoidKind::kCircular,
                     cycloid = TrochoidKind::kCycloid;
  const Region taper = make_region(shapes::polygon({{0, -4}, {50, -7}, {50, 7}, {0, 4}}));
  expect_fallback(taper, ours, FindingCode::kNoPatternBetweenWalls);
  expect_fallback(make_region(shapes::rectangle(0, 0, 60, 32)), circles,
                  FindingCode::kNoPatternSoWide);
  const Region brief = slot_around(line(4), 9, SlotEnds::kRound);
  expect_fallback(brief, cycloid, FindingCode::kNoPatternSoShort);
  expect_fallback(brief, cycloid, FindingCode::kNoPatternSoShort, CutMode::kConventional);
}

TEST(ClearSlot, TellsOnceWhatIsLeftUncutWhenAllIsDone) {
  ClearingParams params = params_at();
  params.wall_pass = false;
  const TrochoidalPath result = clear(slot_around(line(50), 9, SlotEnds::kSquare), params);
  EXPECT_GT(result.report.length, 15);
  EXPECT_GT(result.path.report.uncut_area, 0);
  EXPECT_EQ(corpus::findings_of(result.path.report, FindingCode::kLeftWithoutWallPass).size(), 1U);
}

TEST(ClearSlot, TellsOfEachRegionByItself) {
  Progress progress;
  const Region slot = slot_around(line(50), 9, SlotEnds::kRound);
  const Region brief =
      shapes::moved(slot_around(line(4), 9, SlotEnds::kRound), 0, false, 1, {80, 0});
  const TrochoidalPath alone = clear(slot, params_at());
  const TrochoidalPath both =
      clear_slot({slot, brief}, TrochoidKind::kConstantEngagement, params_at(), progress);
  ASSERT_TRUE(fallback_of(both));
  EXPECT_LT(distance(*fallback_of(both)->where, {82, 0}), 0.005);
  EXPECT_FALSE(fallback_of(alone));
  // Figures are of the longest way, whichever region comes last.
  const Region half =
      shapes::moved(slot_around(line(30), 12, SlotEnds::kRound), 0, false, 1, {0, 40});
  const TrochoidalPath two =
      clear_slot({slot, half}, TrochoidKind::kConstantEngagement, params_at(), progress);
  EXPECT_EQ(two.report.step, alone.report.step);
  EXPECT_EQ(two.report.longest, alone.report.longest);
  EXPECT_GT(two.report.length, alone.report.length);
}

TEST(ClearSlot, RepeatsItsPatternBetweenWallsThatAreNotQuiteParallel) {
  for (const double width : {7.5, 10.0})
    for (const double off : {0.0005, 0.004, -0.004}) {
      SCOPED_TRACE(std::to_string(width) + " mm, " + std::to_string(off));
      const Region taper =
          make_region(shapes::polygon({{0, 0}, {60, 0}, {60, width + off}, {0, width}}));
      const ClearingParams params = params_at();
      const TrochoidalPath result = clear(taper, params);
      expect_good(taper, params, result);
      EXPECT_GT(result.report.length, 30);
    }
}

TEST(ClearSlot, RefusesASlotNarrowerThanTheToolAsEveryStrategyDoes) {
  EXPECT_THROW(clear(slot_around(line(50), 5.9, SlotEnds::kRound), params_at()), GeometryError);
}

TEST(ClearSlot, StretchesItsHelixAlongTheSlot) {
  const Region region = slot_around(line(50), 9, SlotEnds::kRound);
  const TrochoidalPath result = clear(region, params_at());
  double low = 1e9, high = -1e9, across = 0;
  for (const Move& move : result.path.moves)
    if (move.kind == MoveKind::kEntry) {
      low = std::min(low, move.x);
      high = std::max(high, move.x);
      across = std::max(across, std::abs(move.y));
    }
  EXPECT_GT(high - low, 6);
  EXPECT_LT(across, 1.5);
}

TEST(Helix, GoesRoundInTwoHalvesThatAreTangent) {
  Descent helix;
  helix.centre = {5, 3};
  helix.radius = 2;
  for (const Vec2 stretch : {Vec2{}, Vec2{3, 4}}) {
    helix.stretch = stretch;
    const Vec2 ahead = norm(stretch) > 0 ? normalized(stretch) : Vec2{1, 0};
    helix.at = helix.centre + stretch + helix.radius * ahead;
    std::vector<Segment> round = half_turn(helix, false);
    for (const Segment& segment : half_turn(helix, true)) round.push_back(segment);
    double length = 0;
    for (std::size_t i = 0; i < round.size(); ++i) {
      const Segment& next = round[(i + 1) % round.size()];
      EXPECT_LT(distance(round[i].b, next.a), 1e-12);
      EXPECT_LT(norm(round[i].tangent(1) - next.tangent(0)), 1e-12);
      length += round[i].length();
    }
    EXPECT_LT(distance(round.front().a, helix.at), 1e-12);
    EXPECT_NEAR(length, 2 * half_turn_length(helix), 1e-12);
    EXPECT_NEAR(cleared_area(helix, 3), kPi * 25 + 20 * norm(stretch), 1e-9);
  }
}

}  // namespace
}  // namespace evenload
