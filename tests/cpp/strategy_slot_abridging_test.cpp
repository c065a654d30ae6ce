// Long slots that are computed as short ones.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "geometry_shapes.h"
#include "strategy/pattern_cache.h"
#include "strategy/slot_abridging.h"
#include "strategy/slot_around.h"
#include "strategy/slot_clearing.h"
#include "strategy/slot_unabridging.h"

namespace evenload {
namespace {

constexpr double kDegree = kPi / 180;
constexpr TrochoidKind kOurs = TrochoidKind::kConstantEngagement;

ClearingParams usual_params() {
  ClearingParams params;
  params.engagement_angle = 60 * kDegree;
  params.feed_control = FeedControl::kConstantRemovalRate;
  params.maximum_feed = 1000;
  params.roll_radius = 1;
  return params;
}

Curve line(double length) { return Curve({{{0, 0}}, {{length, 0}}}, false); }

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

std::vector<SlotCut> cuts_in(const std::vector<Region>& regions, const ClearingParams& params,
                             std::optional<Vec2> hole = std::nullopt) {
  const double radius = 0.5 * params.tool_diameter;
  PatternCache patterns(kOurs, params);
  const Area centres(offset(regions, -(radius + params.stock_to_leave + kWallGap)));
  return cuts_of(
      regions, find_slots(centres, (kWidestSlot - 1) * radius), {}, params,
      [&](const SlotStretch& stretch) { return patterns.pattern_of(stretch); }, hole);
}

double length_of_ground(const std::vector<Region>& ground) {
  const Bounds box = bounds_of(ground);
  return box.high.x - box.low.x;
}

TEST(SlotAbridging, LeavesAsMuchOfASlotHoweverLongItIs) {
  const ClearingParams params = usual_params();
  for (const double width : {7.5, 9.0, 12.0, 18.0}) {
    SCOPED_TRACE(width);
    double least = 1e9, most = 0, step = 0;
    for (const double length : {150.0, 300.0, 1000.0, 9876.5}) {
      const std::vector<SlotCut> cuts =
          cuts_in({slot_around(line(length), width, SlotEnds::kRound)}, params);
      ASSERT_EQ(cuts.size(), 1u) << length;
      step = cuts[0].step();
      const double left = length_of_ground(cuts[0].ground);
      EXPECT_NEAR(left + cuts[0].out, length + width, 1e-9);
      least = std::min(least, left);
      most = std::max(most, left);
    }
    EXPECT_LT(most - least, step);
    EXPECT_LT(most, 100);
  }
}

TEST(SlotAbridging, TakesWholePeriodsOfThePatternOutBetweenTheEnds) {
  const ClearingParams params = usual_params();
  for (const double turn : {0.0, 0.4, 2.5}) {
    const Region slot =
        shapes::moved(slot_around(line(300), 9, SlotEnds::kSquare), turn, false, 1, {17, -230});
    const std::vector<SlotCut> cuts = cuts_in({slot}, params);
    ASSERT_EQ(cuts.size(), 1u);
    const double step = PatternCache(kOurs, params).pattern_of(cuts[0].stretch)->pattern.step;
    EXPECT_NEAR(cuts[0].out, cuts[0].periods * step, 1e-6);
    EXPECT_NEAR(cuts[0].ground[0].area(), slot.area() - 9 * cuts[0].out, 1e-6);
  }
}

TEST(SlotAbridging, BendsWhatIsLeftOfAnArcAsTheWhole) {
  const Region slot = slot_around(half_circle(150), 10, SlotEnds::kRound);
  const std::vector<SlotCut> cuts = cuts_in({slot}, usual_params());
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_GT(cuts[0].out, 300);
  EXPECT_NEAR(cuts[0].stretch.middle.radius, 150, 1e-9);
  EXPECT_NEAR(cuts[0].ground[0].area(), slot.area() - 10 * cuts[0].out, 1e-6);
}

TEST(SlotAbridging, KnowsWhereEveryPlaceWasInTheWhole) {
  const double quarter = std::tan(kPi / 8);
  const Curve bent({{{0, 0}}, {{200, 0}, quarter}, {{230, 30}}, {{230, 300}}}, false);
  for (const Region& slot :
       {slot_around(line(300), 9, SlotEnds::kSquare), slot_around(bent, 9, SlotEnds::kRound),
        tee(300, 200), slot_around(half_circle(150), 10, SlotEnds::kRound)}) {
    const std::vector<SlotCut> cuts = cuts_in({slot}, usual_params());
    ASSERT_FALSE(cuts.empty());
    const WholePlaces whole(cuts);
    for (const Vertex& left : cuts.back().ground[0].outer.vertices()) {
      double nearest = 1e9;
      for (const Vertex& v : slot.outer.vertices())
        nearest = std::min(nearest, distance(whole(left.p), v.p));
      EXPECT_LT(nearest, 1e-7);
    }
  }
}

TEST(SlotAbridging, LeavesShortSlotsAndWhatIsNoSlotAsTheyAre) {
  const ClearingParams params = usual_params();
  const Region taper = make_region(shapes::polygon({{0, 0}, {300, 0}, {300, 9.004}, {0, 9}}));
  const Region ring =
      slot_around(Curve({{{100, 0}, std::tan(kPi / 4)}, {{-100, 0}, std::tan(kPi / 4)}}, true), 10,
                  SlotEnds::kRound);
  for (const Region& region : {slot_around(line(20), 9, SlotEnds::kRound), taper, ring,
                               make_region(shapes::rectangle(0, 0, 300, 40))})
    EXPECT_TRUE(cuts_in({region}, params).empty());
}

TEST(SlotAbridging, LeavesRoomAboutAHoleToBothSides) {
  const Region slot = slot_around(line(400), 12, SlotEnds::kRound);
  ClearingParams params = usual_params();
  params.entry = EntryKind::kPredrilledHole;
  params.hole_diameter = 8;
  std::optional<Vec2> hole = Vec2{200, 0};
  const double radius = 0.5 * params.tool_diameter;
  PatternCache patterns(kOurs, params);
  const std::vector<SlotCut> cuts = cuts_of(
      {slot}, find_slots(Area(offset({slot}, -(radius + kWallGap))), 3 * radius), {}, params,
      [&](const SlotStretch& stretch) { return patterns.pattern_of(stretch); }, hole);
  ASSERT_EQ(cuts.size(), 2u);
  EXPECT_NEAR(WholePlaces(cuts)(*hole).x, 200, 1e-9);
  EXPECT_GT(hole->x, 20);
  EXPECT_GT(length_of_ground(cuts.back().ground) - hole->x, 20);
}

TEST(SlotAbridging, LeavesRegionsAloneThatWouldMeet) {
  const Region fork = slot_around(Curve({{{0, -70}}, {{0, 0}}, {{300, 0}}, {{300, -70}}}, false), 9,
                                  SlotEnds::kSquare);
  const std::vector<SlotCut> cuts = cuts_in({fork}, usual_params());
  ASSERT_FALSE(cuts.empty());
  // Where either prong may come to lie.
  const double x = cuts[0].out;
  EXPECT_TRUE(cuts_in({fork, make_region(shapes::rectangle(x - 20, -50, x + 20, -20)),
                       make_region(shapes::rectangle(280 - x, -50, 320 - x, -20))},
                      usual_params())
                  .empty());
  EXPECT_EQ(
      cuts_in({fork, make_region(shapes::rectangle(140, -50, 160, -20))}, usual_params()).size(),
      cuts.size());
}

// Every period removes the same.
RemovedByPeriod even(const RepeatedPeriods& periods) {
  RemovedByPeriod removed;
  for (int i = 0; i < periods.count; ++i) removed[periods.first + i] = 1;
  return removed;
}

TEST(SlotUnabridging, SparesSlotsThatALinkPassesAslant) {
  const Region slot = slot_around(line(300), 10, SlotEnds::kSquare);
  const ClearingParams params = usual_params();
  const std::vector<SlotCut> cuts = cuts_in({slot}, params);
  ASSERT_EQ(cuts.size(), 1u);
  const SlotPattern pattern = *PatternCache(kOurs, params).pattern_of(cuts[0].stretch);
  const double length = cuts[0].stretch.middle.length();
  const double half_width = cuts[0].stretch.half_room - pattern.beside;
  RepeatedPeriods periods{cuts[0].stretch, pattern.reach, half_width, cuts[0].step(), 0, 0, 0};
  PlanarRun run;
  for (; (periods.count + 1) * periods.step < length; ++periods.count)
    for (const bool cut : {false, true}) {
      PlanarMove move;
      move.kind = cut ? MoveKind::kCut : MoveKind::kLink;
      move.period = periods.count;
      const double at = periods.count * periods.step;
      const Vec2 a = pose_on(cuts[0].stretch, at - (cut ? 0 : periods.step)).p,
                 b = pose_on(cuts[0].stretch, at).p;
      move.segment = cut ? Segment::line(b - Vec2{0, 1}, b + Vec2{0, 1})
                         : Segment::line(a + Vec2{0, 1}, b - Vec2{0, 1});
      run.moves.push_back(move);
    }
  const Bounds left = bounds_of(cuts[0].ground);
  PlanarMove back;
  for (const double aslant : {0.0, 0.5}) {
    back.segment = Segment::line({left.high.x - 4, 6}, {left.low.x + 4, 6 - aslant});
    std::vector<PlanarRun> runs{run};
    runs[0].moves.push_back(back);
    std::vector<SlotPiece> spared;
    const std::optional<Unabridged> added =
        unabridge(runs, even(periods), cuts, {periods}, params, spared);
    EXPECT_EQ(added.has_value(), aslant == 0);
    EXPECT_EQ(spared.size(), aslant == 0 ? 0u : 1u);
    if (!added) continue;
    EXPECT_EQ(added->passes, cuts[0].periods);
    EXPECT_NEAR(added->area, 10 * cuts[0].out, 0.01 * cuts[0].out);
    EXPECT_EQ(runs[0].moves.size(), run.moves.size() + 1 + 2 * cuts[0].periods);
    EXPECT_NEAR(runs[0].moves.back().segment.length(), back.segment.length() + cuts[0].out, 1e-9);
    for (std::size_t i = 1; i + 1 < runs[0].moves.size(); ++i)
      EXPECT_LT(distance(runs[0].moves[i - 1].segment.b, runs[0].moves[i].segment.a), 1e-9);
  }
}

TEST(SlotUnabridging, BendsALinkThatLeadsBackAcrossTheSlot) {
  const Region slot = slot_around(line(300), 10, SlotEnds::kSquare);
  ClearingParams params = usual_params();
  params.rapid_feed = params.link_feed;  // no retract is quicker
  const std::vector<SlotCut> cuts = cuts_in({slot}, params);
  ASSERT_EQ(cuts.size(), 1u);
  const SlotPattern pattern = *PatternCache(kOurs, params).pattern_of(cuts[0].stretch);
  RepeatedPeriods periods{cuts[0].stretch, pattern.reach, 2, cuts[0].step(), 0, 0, 0};
  PlanarRun run;
  for (; (periods.count + 1) * periods.step < cuts[0].stretch.middle.length(); ++periods.count) {
    PlanarMove move;
    move.period = periods.count;
    const Vec2 at = pose_on(cuts[0].stretch, periods.count * periods.step).p;
    move.segment = Segment::line(at, at + Vec2{0, 1});
    run.moves.push_back(move);
  }
  const Bounds left = bounds_of(cuts[0].ground);
  const Vec2 middle = 0.5 * (left.low + left.high);
  PlanarMove link;
  link.kind = MoveKind::kLink;
  for (const bool forward : {false, true}) {
    const Vec2 one{left.high.x - 4, middle.y + 1.9}, other{left.low.x + 4, middle.y - 1.9};
    link.segment = forward ? Segment::line(other, one) : Segment::line(one, other);
    std::vector<PlanarRun> runs{run};
    runs[0].moves.push_back(link);
    std::vector<SlotPiece> spared;
    ASSERT_TRUE(unabridge(runs, even(periods), cuts, {periods}, params, spared));
    const std::vector<PlanarMove>& moves = runs[0].moves;
    ASSERT_EQ(moves.size(), run.moves.size() + cuts[0].periods + 5);
    const Segment &first = moves[moves.size() - 5].segment, &last = moves.back().segment;
    EXPECT_NEAR(std::abs(last.b.x - first.a.x), one.x - other.x + cuts[0].out, 1e-9);
    EXPECT_NEAR(std::abs(last.b.y - first.a.y), one.y - other.y, 1e-9);
    for (std::size_t i = moves.size() - 4; i < moves.size(); ++i) {
      const Segment &a = moves[i - 1].segment, &b = moves[i].segment;
      EXPECT_EQ(moves[i].kind, MoveKind::kLink);
      EXPECT_LT(distance(a.b, b.a), 1e-9);
      EXPECT_LT(norm(a.tangent(1) - b.tangent(0)), 1e-9);
    }
    // Where something else has cleared a part, a period is not like those that were taken out.
    RemovedByPeriod less = even(periods);
    for (auto& [number, area] : less)
      if (number > periods.count / 4) area = 0.9;
    std::vector<PlanarRun> beside{run};
    EXPECT_FALSE(unabridge(beside, less, cuts, {periods}, params, spared));
    // Before the pattern is done nobody knows what a link would meet.
    std::vector<PlanarRun> early{run};
    early[0].moves.insert(early[0].moves.begin(), link);
    EXPECT_FALSE(unabridge(early, even(periods), cuts, {periods}, params, spared));
  }
}

}  // namespace
}  // namespace evenload
