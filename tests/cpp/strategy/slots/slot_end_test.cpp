// Ends of slots that are cleared before their patterns, as these will leave them.
#include "strategy/slots/slot_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/shapes.h"
#include "judge/numbers.h"
#include "strategy/trochoid/pattern_cache.h"

namespace evenload {
namespace {

ClearingParams params_of_slots() {
  ClearingParams params;
  params.feed_control = FeedControl::kConstantRemovalRate;
  params.maximum_feed = 1000;
  params.roll_radius = 1;
  return params;
}

// A slot with square ends, and the way along it.
struct SlotWithWay {
  SlotWithWay(double length, double width)
      : area({make_region(shapes::rectangle(0, 0, length, width))}) {
    task.centres = offset({make_region(shapes::rectangle(0, 0, length, width))}, -kRadius).front();
    area = Area({task.centres});
    const SlotStretch stretch = find_slots(area, 3 * kRadius).front();
    way =
        Way{*PatternCache(TrochoidKind::kConstantEngagement, params).pattern_of(stretch), stretch};
  }

  ClearedGround ground() const {
    return {grown(bounds_of({task.centres}), kRadius), kRadius, nullptr};
  }

  // All periods from the `first` on, at their places along the way.
  Plan periods_from(int first, Progress& progress) const {
    Plan made(task, params, progress);
    for (int period = first; period >= 0; --period) {
      const std::vector<Segment> cut = cut_at(way, place_of(way, period));
      if (period == first)
        made.plunge({cut.front().a, 0}, true);
      else
        made.add(MoveKind::kLink,
                 placed(way.pattern.link, pose_on(way.stretch, place_of(way, period + 1))));
      made.add(MoveKind::kCut, cut);
    }
    return made;
  }

  ClearingParams params = params_of_slots();
  RegionTask task;
  Area area;
  Way way;
};

TEST(EarlyEnd, IsClearedAsAfterAllPeriods) {
  const SlotWithWay slot(120, 9);
  const auto early = EarlyEnd::of(slot.task, slot.area, slot.way, 10, slot.params);
  ASSERT_TRUE(early);
  const int first = 80;
  ASSERT_GT(place_of(slot.way, first), 0);
  ASSERT_TRUE(early->fits(slot.way, first));
  Progress progress;
  const std::optional<RegionResult> end = early->cleared(progress);
  ASSERT_TRUE(end);
  EXPECT_GT(end->passes, 4);

  const Plan all = slot.periods_from(first, progress);
  const std::optional<Region> room = end_room(slot.task.centres, slot.area, slot.way, 0);
  ASSERT_TRUE(room);
  const std::optional<RegionResult> later =
      clear_part(all, slot.task, *room, slot.params, progress);
  ASSERT_TRUE(later);
  ASSERT_EQ(later->runs.size(), end->runs.size());
  const std::vector<PlanarMove>& moves = later->runs.front().moves;
  const std::size_t made = all.runs().front().moves.size();
  ASSERT_EQ(moves.size() - made, end->runs.front().moves.size());
  for (std::size_t i = made; i < moves.size(); ++i) {
    const PlanarMove& move = end->runs.front().moves[i - made];
    EXPECT_EQ(moves[i].kind, move.kind);
    EXPECT_NEAR(distance(moves[i].segment.b, move.segment.b), 0, 1e-6);
  }
}

TEST(EarlyEnd, FitsItsOwnWayWithEnoughPeriodsOnly) {
  const SlotWithWay slot(120, 9), other(120, 9);
  const auto early = EarlyEnd::of(slot.task, slot.area, slot.way, 10, slot.params);
  ASSERT_TRUE(early);
  // Periods that reach no further than a tool's diameter behind the last one.
  const int few = static_cast<int>(2 * kRadius / slot.way.pattern.step);
  EXPECT_FALSE(early->fits(slot.way, few));
  EXPECT_TRUE(early->fits(slot.way, 80));
  EXPECT_FALSE(early->fits(other.way, 80));
}

TEST(EarlyEnd, IsNoneWhereTheSlotIsShortOrLeadsOn) {
  const SlotWithWay brief(22, 9);
  EXPECT_TRUE(EarlyEnd::of(brief.task, brief.area, brief.way, 0, brief.params));
  EXPECT_FALSE(EarlyEnd::of(brief.task, brief.area, brief.way, 8, brief.params));
  // A slot into a room: no mere end.
  SlotWithWay slot(120, 9);
  const Region key = make_region(Curve({{{0, 0}},
                                        {{100, 0}},
                                        {{100, -30}},
                                        {{170, -30}},
                                        {{170, 39}},
                                        {{100, 39}},
                                        {{100, 9}},
                                        {{0, 9}}},
                                       true));
  slot.task.centres = offset({key}, -kRadius).front();
  slot.area = Area({slot.task.centres});
  for (const SlotStretch& stretch : find_slots(slot.area, 3 * kRadius)) {
    slot.way.stretch = stretch.middle.b.x > stretch.middle.a.x ? stretch : stretch.reversed();
    EXPECT_FALSE(EarlyEnd::of(slot.task, slot.area, slot.way, 10, slot.params));
  }
}

std::vector<std::unique_ptr<EarlyEnd>> ends_of(const std::vector<SlotWithWay>& slots) {
  std::vector<std::unique_ptr<EarlyEnd>> ends;
  for (const SlotWithWay& slot : slots)
    ends.push_back(EarlyEnd::of(slot.task, slot.area, slot.way, 10, slot.params));
  return ends;
}

TEST(EarlyEnds, AreTheSameWhoeverClearsThem) {
  const std::vector<SlotWithWay> slots{{120, 9}, {80, 8.75}, {120, 9}, {100, 9.5}};
  const int first = 80;
  Progress progress;
  std::vector<std::optional<RegionResult>> alone;
  for (const std::unique_ptr<EarlyEnd>& end : ends_of(slots))
    alone.push_back(end->cleared(progress));
  // The last one first, which the other core has not come to.
  const EarlyEnds ends(ends_of(slots));
  for (std::size_t i = slots.size(); i-- > 0;) {
    EarlyEnd* const end = ends.of(slots[i].way, first);
    ASSERT_TRUE(end);
    const std::optional<RegionResult> cleared = end->cleared(progress);
    ASSERT_TRUE(cleared && alone[i]);
    ASSERT_EQ(cleared->runs.size(), alone[i]->runs.size());
    for (std::size_t k = 0; k < cleared->runs.size(); ++k)
      EXPECT_EQ(cleared->runs[k].moves, alone[i]->runs[k].moves);
  }
  EXPECT_FALSE(ends.of(SlotWithWay(120, 9).way, first));
  EXPECT_FALSE(ends.of(slots[0].way, 0));
}

TEST(EarlyEnd, IsLeftWhenTheJobIsCancelledAndNotBegunOnceItIsDropped) {
  const std::vector<SlotWithWay> slots{{120, 9}};
  Progress patient;
  const std::optional<RegionResult> whole = ends_of(slots)[0]->cleared(patient);
  ASSERT_TRUE(whole);
  int reports = 0;
  Progress hasty([&](double) { return ++reports < 2; });
  const std::optional<RegionResult> part = ends_of(slots)[0]->cleared(hasty);
  EXPECT_TRUE(hasty.cancelled());
  EXPECT_TRUE(!part || part->passes < whole->passes);
  const std::vector<std::unique_ptr<EarlyEnd>> dropped = ends_of(slots);
  dropped[0]->drop();
  EXPECT_FALSE(dropped[0]->cleared(patient));
}

// For the sanitizers: what still runs must not outlive what it reads.
TEST(EarlyEnds, AreWaitedForWhereNobodyWantsThem) {
  const std::vector<SlotWithWay> slots{{120, 9}, {80, 8.75}};
  for (int i = 0; i < 20; ++i) const EarlyEnds ends(ends_of(slots));
  const EarlyEnds none({});
  EXPECT_FALSE(none.of(slots[0].way, 80));
}

TEST(Periods, AreCountedBackFromTheLastPlace) {
  const SlotWithWay slot(120, 9);
  EXPECT_EQ(place_of(slot.way, 0), slot.way.last());
  EXPECT_NEAR(place_of(slot.way, 10), slot.way.last() - 10 * slot.way.pattern.step, 1e-12);
  // After periods up to some place, the next one takes no more than a step.
  ClearedGround ground = slot.ground();
  ground.add(Segment::line(slot.way.stretch.middle.a, slot.way.stretch.middle.a));
  EXPECT_FALSE(first_to_cut(slot.way, ground));  // no room for a period
  ground.remove_last();
  Progress progress;
  const Plan all = slot.periods_from(200, progress);
  for (const PlanarMove& move : all.runs().front().moves) {
    if (slot.way.stretch.middle.nearest(move.segment.b) * slot.way.stretch.middle.length() > 50)
      break;
    ground.add(move.segment);
  }
  const std::optional<int> first = first_to_cut(slot.way, ground);
  ASSERT_TRUE(first);
  EXPECT_TRUE(has_work(slot.way, ground, place_of(slot.way, *first)));
  EXPECT_FALSE(has_work(slot.way, ground, place_of(slot.way, *first + 1)));
}

}  // namespace
}  // namespace evenload
