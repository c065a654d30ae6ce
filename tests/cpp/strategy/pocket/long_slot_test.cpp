// Long slots: of every kind, beside open ends, holes and rooms, judged.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "cutting/engagement.h"
#include "geometry/shapes.h"
#include "geometry/slot_around.h"
#include "judge/narrow_pockets.h"
#include "judge/path_check.h"
#include "strategy/places/allowed_ground.h"
#include "strategy/pocket/trochoid.h"

namespace evenload {
namespace {

using narrow_pockets::line;

constexpr double kLeastRepeated = 15;  // mm of slot along which a pattern is repeated
constexpr TrochoidKind kOurs = TrochoidKind::kConstantEngagement;

ClearingParams usual_params() {
  ClearingParams params;
  params.engagement_angle = 60 * kDegree;
  params.feed_control = FeedControl::kConstantRemovalRate;
  params.maximum_feed = 1000;
  params.roll_radius = 1;
  return params;
}

Curve half_circle(double radius) {
  return Curve({{{radius, 0}, std::tan(kPi / 4)}, {{-radius, 0}}}, false);
}

// A bar with an arm on its far side, as wide as the bar.
Region tee(double bar, double arm) {
  const double at = 0.5 * bar;
  return make_region(shapes::polygon({{0, 0},
                                      {bar, 0},
                                      {bar, 10},
                                      {at + 5, 10},
                                      {at + 5, arm},
                                      {at - 5, arm},
                                      {at - 5, 10},
                                      {0, 10}}));
}

// Two rooms off a slot, one of them round an island.
Region slot_with_rooms(double length) {
  Region region = make_region(shapes::polygon({{0, 0},
                                               {length, 0},
                                               {length, 9},
                                               {length - 20, 9},
                                               {length - 20, 39},
                                               {length - 50, 39},
                                               {length - 50, 9},
                                               {20, 9},
                                               {20, 15},
                                               {0, 15}}));
  region.islands.push_back(shapes::rectangle(length - 38, 20, length - 32, 26).reversed());
  return region;
}

struct LongSlot {
  const char* name;
  Region region;
  TrochoidKind kind = kOurs;
  FeedControl control = FeedControl::kConstantRemovalRate;
  CutMode mode = CutMode::kClimb;
  int levels = 1;
  double degrees = 60;
  std::optional<Vec2> hole = {};
};

// The slot's path by the judge, beside what its report says.
void expect_cleared_within_the_limits(const LongSlot& c) {
  ClearingParams params = usual_params();
  params.engagement_angle = c.degrees * kDegree;
  params.feed_control = c.control;
  params.cut_mode = c.mode;
  params.force_coefficients = {1800, 600, 20, 10};
  params.spindle_speed = 6000;
  if (c.levels == 2) params.levels = {-3, -6};
  if (c.hole) {
    params.entry = EntryKind::kPredrilledHole;
    params.entry_point = c.hole;
    params.hole_diameter = 7;
  }
  Progress progress;
  const TrochoidalPath made = clear_slot({c.region}, c.kind, params, progress);
  const Report& report = made.path.report;
  EXPECT_EQ(report.termination, Termination::kComplete);
  EXPECT_GT(made.report.length, kLeastRepeated);
  EXPECT_LT(report.max_engagement, params.engagement_angle + kDegree);
  EXPECT_EQ(report.uncut_area, 0);
  if (has_open_edges({c.region})) return;  // walls beside open ends are beyond the judge
  path_check::Stock stock;
  stock.regions = {c.region};
  stock.hole = c.hole;
  if (c.hole) stock.hole_radius = 0.5 * params.hole_diameter;
  const path_check::Findings found = path_check::check_path(stock, 3, made.path.moves);
  EXPECT_LT(found.cut_engagement, params.engagement_angle + kDegree);
  EXPECT_NEAR(found.cut_engagement, report.max_engagement, kDegree);
  EXPECT_LT(found.link_engagement, kDegree);
  EXPECT_LT(found.gouge, 0.005);
  EXPECT_LT(found.left_share, 5e-4);
  EXPECT_EQ(found.bad_plunges, 0);
  EXPECT_LT(found.arc_mismatch, 2e-6);
  EXPECT_LE(found.kinks, 8);  // at sharp corners, and a few that rounding makes
  if (c.control == FeedControl::kConstantRemovalRate) {
    EXPECT_LT(found.removal_rate, 1.05 * side_step(params.engagement_angle, 3) * params.feed);
  }
}

TEST(ClearSlot, ClearsLongSlotsOfEveryKind) {
  const std::vector<LongSlot> cases = {
      {"narrow", slot_around(line(90), 7.5, SlotEnds::kRound)},
      {"walls by themselves", slot_around(line(100), 10, SlotEnds::kSquare)},
      {"wide", slot_around(line(110), 18, SlotEnds::kRound)},
      {"arc", slot_around(half_circle(40), 10, SlotEnds::kRound)},
      {"arc, the other way", slot_around(half_circle(40), 9, SlotEnds::kSquare)},
      {"circles", slot_around(line(100), 10, SlotEnds::kSquare), TrochoidKind::kCircular},
      {"cycloid", slot_around(line(100), 10, SlotEnds::kSquare), TrochoidKind::kCycloid},
      {"tee", tee(160, 60)},
      {"constant feed", slot_around(line(100), 10, SlotEnds::kSquare), kOurs,
       FeedControl::kConstantFeed},
      {"conventional, two levels", slot_around(line(100), 10, SlotEnds::kRound), kOurs,
       FeedControl::kConstantRemovalRate, CutMode::kConventional, 2},
      {"small angle", slot_around(line(30), 7.5, SlotEnds::kSquare), kOurs,
       FeedControl::kConstantRemovalRate, CutMode::kClimb, 1, 30},
      {"large angle", slot_around(line(90), 7, SlotEnds::kRound), kOurs,
       FeedControl::kConstantRemovalRate, CutMode::kClimb, 1, 75}};
  for (const LongSlot& c : cases) {
    SCOPED_TRACE(c.name);
    expect_cleared_within_the_limits(c);
  }
}

TEST(ClearSlot, ClearsLongSlotsBesideOpenEndsHolesAndRooms) {
  const std::vector<LongSlot> cases = {
      {"open ends", slot_around(line(120), 9, SlotEnds::kOpen)},
      {"open ends, wide", slot_around(line(120), 14, SlotEnds::kOpen)},
      {"hole at an end", slot_around(line(100), 9, SlotEnds::kRound), kOurs,
       FeedControl::kConstantRemovalRate, CutMode::kClimb, 1, 60, Vec2{0, 0}},
      {"hole beside the middle", slot_around(line(180), 10, SlotEnds::kSquare), kOurs,
       FeedControl::kConstantRemovalRate, CutMode::kClimb, 1, 60, Vec2{80, 0}},
      {"rooms and an island", slot_with_rooms(180)}};
  for (const LongSlot& c : cases) {
    SCOPED_TRACE(c.name);
    expect_cleared_within_the_limits(c);
  }
}

TEST(ClearSlot, ClearsLongSlotsUnderEveryFeedControl) {
  for (const FeedControl control :
       {FeedControl::kConstantChipThickness, FeedControl::kConstantForce})
    for (const double width : {9.0, 12.0}) {
      SCOPED_TRACE(width);
      expect_cleared_within_the_limits(
          {"", slot_around(line(110), width, SlotEnds::kSquare), kOurs, control});
    }
}

TEST(ClearSlot, ClearsLongSlotsBesideDeepScallops) {
  // The feed changes along the walls within a period.
  for (const double length : {110.0, 200.0}) {
    SCOPED_TRACE(length);
    LongSlot slot{"", slot_around(line(length), 12, SlotEnds::kSquare)};
    slot.degrees = 90;
    expect_cleared_within_the_limits(slot);
  }
}

TEST(ClearSlot, MakesTheSamePathOfALongSlotEveryTime) {
  const Region region = slot_around(line(400), 9, SlotEnds::kRound);
  Progress progress;
  const Toolpath one = clear_slot({region}, kOurs, usual_params(), progress).path;
  const Toolpath two = clear_slot({region}, kOurs, usual_params(), progress).path;
  ASSERT_EQ(one.moves.size(), two.moves.size());
  for (std::size_t i = 0; i < one.moves.size(); ++i) {
    EXPECT_EQ(one.moves[i].x, two.moves[i].x);
    EXPECT_EQ(one.moves[i].y, two.moves[i].y);
    EXPECT_EQ(one.moves[i].feed, two.moves[i].feed);
  }
}

TEST(ClearSlot, RepeatsEveryPeriodOfALongSlotOneStepOn) {
  const Region region = slot_around(line(400), 9, SlotEnds::kRound);
  Progress progress;
  const TrochoidalPath result = clear_slot({region}, kOurs, usual_params(), progress);
  // Where cuts begin after a link.
  std::vector<double> begins;
  const std::vector<Move>& moves = result.path.moves;
  for (std::size_t i = 2; i < moves.size(); ++i)
    if (moves[i].kind == MoveKind::kCut && moves[i - 1].kind == MoveKind::kLink &&
        moves[i - 1].x > 30 && moves[i - 1].x < 370)
      begins.push_back(moves[i - 1].x);
  ASSERT_GT(begins.size(), 500u);
  int others = 0;
  for (std::size_t i = 1; i < begins.size(); ++i)
    others += std::abs(std::abs(begins[i] - begins[i - 1]) - result.report.step) > 1e-9;
  EXPECT_LE(others, 2);
}

}  // namespace
}  // namespace evenload
