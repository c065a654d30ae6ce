// Slots: made about a middle, and found in regions of tool centres.
#include "strategy/trochoid/slot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "geometry/shapes.h"
#include "geometry/slot_around.h"
#include "strategy/slots/slot_rooms.h"
#include "support/errors.h"

namespace evenload {
namespace {

const double kQuarter = std::tan(kPi / 8);

Curve ess() {
  return Curve({{{0, 0}}, {{30, 0}, kQuarter}, {{50, 20}, -kQuarter}, {{70, 40}}, {{90, 40}}},
               false);
}

TEST(SlotAround, HasSidesHalfTheWidthFromItsMiddle) {
  const Curve middle = ess();
  for (const SlotEnds ends : {SlotEnds::kRound, SlotEnds::kSquare, SlotEnds::kOpen}) {
    const Region slot = slot_around(middle, 10, ends);
    const double cap = ends == SlotEnds::kRound ? 25 * kPi : 0;
    EXPECT_NEAR(slot.area(), 10 * middle.length() + cap, 1e-6);
    int open = 0;
    for (const Segment& piece : slot.outer.segments()) {
      open += piece.open;
      double nearest = 1e9;
      for (const Segment& part : middle.segments())
        nearest = std::min(nearest, part.distance_to(piece.point(0.37)));
      if (ends == SlotEnds::kRound) {
        EXPECT_NEAR(nearest, 5, 1e-9);
      }
    }
    EXPECT_EQ(open, ends == SlotEnds::kOpen ? 2 : 0);
  }
}

TEST(SlotAround, RoundsCornersOutsideAndKeepsThemInside) {
  const Region slot =
      slot_around(Curve({{{0, 0}}, {{40, 0}}, {{40, 30}}}, false), 8, SlotEnds::kSquare);
  // Two rectangles that share a square of half the width, a quarter of a disc for the corner.
  EXPECT_NEAR(slot.area(), 8 * 40 + 8 * 30 - 16 + 4 * kPi, 1e-9);
  EXPECT_TRUE(slot.contains({36.1, 3.9}));
  EXPECT_FALSE(slot.contains({35.9, 4.1}));
  EXPECT_FALSE(slot.contains({43.9, -3.9}));
}

TEST(SlotAround, IsARingAboutAClosedMiddle) {
  const Region ring = slot_around(shapes::circle({3, 4}, 30), 10, SlotEnds::kRound);
  ASSERT_EQ(ring.islands.size(), 1u);
  EXPECT_NEAR(ring.area(), kPi * (35 * 35 - 25 * 25), 1e-6);
}

std::optional<Refusal> refusal(const Curve& middle, double width) {
  try {
    slot_around(middle, width, SlotEnds::kRound);
  } catch (const GeometryError& error) {
    return error.refusal();
  }
  return {};
}

TEST(SlotAround, IsRefusedForWhatIsWrongWithItsMiddleOrItsWidth) {
  using enum Refusal;
  const Curve line({{{0, 0}}, {{40, 0}}}, false);
  EXPECT_THROW(refusal(line, 0), std::invalid_argument);
  EXPECT_THROW(refusal(line, std::nan("")), std::invalid_argument);
  EXPECT_EQ(refusal(Curve({{{0, 0}}, {{40, std::nan("")}}}, false), 9), kMiddleNotFinite);
  EXPECT_EQ(refusal(Curve({{{1, 1}}, {{1, 1}}}, false), 9), kMiddleWithoutLength);
  EXPECT_EQ(refusal(Curve({{{1, 1}}}, false), 9), kMiddleWithoutLength);
  EXPECT_EQ(refusal(Curve({{{0, 0}}, {{40, 0}}, {{40, 20}}, {{20, -20}}}, false), 4),
            kMiddleCrossesItself);
  EXPECT_EQ(refusal(Curve({{{0, 0}}, {{20, 0}, 1}, {{20, 6}}, {{0, 6}}}, false), 7),
            kMiddleBendsTooTightly);
  EXPECT_EQ(refusal(Curve({{{0, 0}}, {{40, 0}}, {{40, 9}}, {{0, 9}}}, false), 10),
            kMiddleBendsTooTightly);
  const Curve hook({{{0, 0}}, {{40, 0}}, {{40, 20}}, {{20, 20}}, {{20, 9}}}, false);
  EXPECT_EQ(refusal(hook, 10), kSlotSidesMeet);
  EXPECT_EQ(refusal(line, 9), std::nullopt);
}

Area centres_of(const Region& slot) { return Area(offset({slot}, -3)); }

TEST(FindSlots, FindsStraightAndBentStretchesOfOneWidth) {
  const Area centres = centres_of(slot_around(ess(), 10, SlotEnds::kRound));
  const std::vector<SlotStretch> found = find_slots(centres, 9);
  ASSERT_EQ(found.size(), 4u);
  double length = 0;
  int bent = 0;
  for (const SlotStretch& stretch : found) {
    EXPECT_NEAR(stretch.half_room, 2, 1e-6);
    length += stretch.middle.length();
    bent += stretch.middle.is_arc();
    for (const double t : {0.0, 0.3, 0.7, 1.0})
      EXPECT_NEAR(centres.signed_distance(stretch.middle.point(t)), 2, 2e-4);
  }
  EXPECT_EQ(bent, 2);
  EXPECT_NEAR(length, ess().length(), 0.5);  // the disc fits a little beyond
  EXPECT_GE(found[0].middle.length(), found[1].middle.length() - 1e-3);
}

TEST(FindSlots, GoesStraightOnThroughJunctions) {
  const Region tee = make_region(shapes::polygon(
      {{0, 0}, {100, 0}, {100, 10}, {55, 10}, {55, 60}, {45, 60}, {45, 10}, {0, 10}}));
  const std::vector<SlotStretch> found = find_slots(centres_of(tee), 9);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].middle.length(), 100 - 10, 1e-3);  // to where the disc touches the ends
  EXPECT_NEAR(found[1].middle.length(), 60 - 10, 1e-3);   // into the other one
}

TEST(FindSlots, TakesWallsAFewMicrometresOutOfParallelAtTheNarrowestPlace) {
  const Area taper =
      centres_of(make_region(shapes::polygon({{0, 0}, {80, 0}, {80, 10.004}, {0, 10}})));
  const std::vector<SlotStretch> found = find_slots(taper, 9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].middle.length(), 69);
  const Area bent(
      offset({make_region(shapes::circle({0, 0}, 40), {shapes::circle({0.002, 0}, 30)})}, -3));
  const std::vector<SlotStretch> ring = find_slots(bent, 9);
  ASSERT_FALSE(ring.empty());
  for (const double t : {0.0, 0.3, 0.7, 1.0}) {
    EXPECT_GE(taper.signed_distance(found[0].middle.point(t)), found[0].half_room - 2e-4);
    EXPECT_GE(bent.signed_distance(ring[0].middle.point(t)), ring[0].half_room - 2e-4);
  }
}

TEST(FindSlots, FindsNoneWhereTheWidthChangesOrIsTooLarge) {
  const Region taper = make_region(shapes::polygon({{0, -4}, {80, -7}, {80, 7}, {0, 4}}));
  EXPECT_TRUE(find_slots(centres_of(taper), 9).empty());
  const Region wide = make_region(shapes::rectangle(0, 0, 90, 40));
  EXPECT_TRUE(find_slots(centres_of(wide), 9).empty());
}

TEST(SlotRooms, AreTheEndBehindAFrontAndTheStretchBetweenTwo) {
  const Region centres = offset({make_region(shapes::rectangle(0, 0, 60, 12))}, -3).front();
  const Area area({centres});
  const SlotStretch stretch{Segment::line({6, 6}, {54, 6}), 3};
  const double cap = 0.5 * kPi * 9;
  const auto end = room_behind(centres, area, round_front(stretch, 10));
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->area(), 13 * 6 + cap, 1e-6);
  const auto between = room_between(centres, area, stretch, 10, round_front(stretch, 30));
  ASSERT_TRUE(between);
  EXPECT_NEAR(between->area(), 20 * 6 + 2 * cap, 1e-6);
}

// In a slot hardly wider than the tool passes at large angles bulge by several times its room.
TEST(SlotRooms, BehindAFrontThatBulgesAreTheEndAllTheSame) {
  const Region centres = make_region(shapes::rectangle(0, 0, 60, 0.5));
  const Area area({centres});
  const SlotStretch stretch{Segment::line({0.25, 0.25}, {59.75, 0.25}), 0.25};
  const std::vector<Segment> front{Segment::line({18, 0}, {19.7, 0.02}),
                                   Segment::line({19.7, 0.02}, {19.8, 0.45}),
                                   Segment::line({19.8, 0.45}, {18.3, 0.5})};
  const auto end = start_room(centres, area, stretch, 18, front);
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->is_end);
  EXPECT_GT(end->room.area(), 18 * 0.5);
}

// The stretch ends where one wall turns away; what is beyond is bounded by a wall of its own, which
// comes nearer than the slot is wide.
TEST(SlotRooms, BegunNearTheStretchesStartStayWithinTheWalls) {
  const Region centres =
      make_region(shapes::polygon({{0, 5}, {60, 5}, {60, 11}, {2, 11}, {2, 60}, {0, 60}}));
  const Area area({centres});
  const std::vector<SlotStretch> found = find_slots(area, 9);
  ASSERT_FALSE(found.empty());
  const SlotStretch stretch = found[0].middle.a.x < 30 ? found[0] : found[0].reversed();
  ASSERT_NEAR(stretch.middle.a.x, 3, 1e-3);
  for (const double s : {2.0, 2.9, 10.0}) {
    const auto room = start_room(centres, area, stretch, s, round_front(stretch, s));
    ASSERT_TRUE(room) << s;
    EXPECT_FALSE(room->is_end);
    for (const Segment& piece : room->room.outer.segments())
      for (const double t : {0.0, 0.5, 1.0})
        EXPECT_GT(area.signed_distance(piece.point(t)), -2e-4) << s;
  }
  EXPECT_FALSE(room_between(centres, area, stretch, -0.5, round_front(stretch, 30)));
  const double beyond = stretch.middle.length() + 0.5;
  EXPECT_FALSE(room_between(centres, area, stretch, beyond, round_front(stretch, 30)));
}

}  // namespace
}  // namespace evenload
