// How the tool comes down, region by region.
#include "strategy/reach/entry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/shapes.h"
#include "judge/corpus.h"
#include "judge/judged.h"
#include "strategy/pocket/constant_engagement.h"
#include "toolpath/helix.h"
#include "toolpath/ramp.h"

namespace evenload {
namespace {

Region rectangular(double x0, double y0, double x1, double y1) {
  return make_region(Curve({{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true));
}

Circle widest(const Region& region) { return largest_circle(region, 1e-6); }

TEST(Entry, IsTheWishedHelixWhereThereIsRoomAndShrinksElsewhere) {
  ClearingParams params;
  const Region wide = rectangular(0, 0, 20, 20), tight = rectangular(0, 0, 20, 2);
  const auto helix = [&](const Region& region) {
    const std::optional<Entry> entry = descend_within(Area({region}), widest(region), params);
    EXPECT_EQ(entry->descent.kind, DescentKind::kHelix);
    EXPECT_NEAR(distance(entry->start.p, entry->descent.centre), entry->descent.radius, 1e-9);
    return entry->descent.radius;
  };
  EXPECT_NEAR(helix(wide), 0.5 * params.helix_diameter, 1e-9);
  EXPECT_GT(helix(tight), 0.9);
  EXPECT_LT(helix(tight), 1.0);
  params.helix_diameter = 20;
  EXPECT_LT(helix(wide), 0.5 * params.tool_diameter);
}

TEST(Entry, RampsAlongNarrowSlotsInWhateverDirectionTheyRun) {
  ClearingParams params;
  for (const double width : {1e-4, 1e-3, 0.05})
    for (double angle = 0; angle < kPi; angle += 0.137) {
      SCOPED_TRACE(angle);
      const auto at = [&](double x, double y) { return rotated(Vec2{x, y}, angle); };
      const Region slot =
          make_region(Curve({{at(0, 0)}, {at(30, 0)}, {at(30, width)}, {at(0, width)}}, true));
      const Area centres({slot});
      const std::optional<Entry> entry = descend_within(centres, widest(slot), params);
      ASSERT_TRUE(entry);
      EXPECT_EQ(entry->descent.kind, DescentKind::kRamp);
      const Vec2 from = entry->descent.at, to = entry->descent.ramp_by.front();
      EXPECT_GT(distance(from, to), 0.99 * kLongestRamp * params.tool_diameter);
      for (const double t : {0.0, 0.3, 0.7, 1.0})
        EXPECT_GT(centres.signed_distance(from + t * (to - from)), -1e-9);
    }
}

TEST(Entry, GoesRoundTheBorderOfATinyRoomUnlessAHelixIsAskedFor) {
  ClearingParams params;
  const Region tiny = rectangular(0, 0, 1.22, 0.16);
  const Area centres({tiny});
  ASSERT_GT(widest(tiny).radius, 0.02 * 0.5 * params.tool_diameter);  // a helix would fit
  const std::optional<Entry> entry = descend_within(centres, widest(tiny), params);
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->descent.kind, DescentKind::kRamp);
  EXPECT_EQ(entry->descent.ramp_by.size(), 3u);  // back to the first corner
  for (const Vec2 corner : entry->descent.ramp_by)
    EXPECT_NEAR(centres.signed_distance(corner), 0, 1e-9);
  params.entry = EntryKind::kHelix;
  EXPECT_EQ(descend_within(centres, widest(tiny), params)->descent.kind, DescentKind::kHelix);
  params.entry = EntryKind::kAutomatic;
  for (const Region& other : {rectangular(0, 0, 0.7, 0.7), rectangular(0, 0, 0.25, 2.5)})
    EXPECT_EQ(descend_within(Area({other}), widest(other), params)->descent.kind,
              DescentKind::kRamp);
  // Longer ones have passes; round ones are filled by a helix.
  for (const Region& other :
       {rectangular(0, 0, 0.25, 3.2), make_region(shapes::circle({0, 0}, 0.2)),
        make_region(shapes::circle({0, 0}, 0.45))})
    EXPECT_EQ(descend_within(Area({other}), widest(other), params)->descent.kind,
              DescentKind::kHelix);
  const Region larger = rectangular(0, 0, 1, 1);
  EXPECT_EQ(descend_within(Area({larger}), widest(larger), params)->descent.kind,
            DescentKind::kHelix);
}

// Half a micrometre of a border, on which a ramp of three degrees would hardly descend, and a small
// fillet, whose lines are longer.
TEST(Entry, HasNoLineOnARampRoundABorderThatAPostWouldWriteLevel) {
  ClearingParams params;
  const auto shortest = [](const Descent& ramp) {
    double least = 1e9;
    for (const Segment& line : ramp_round(ramp)) least = std::min(least, line.length());
    return least;
  };
  const Curve border({{{0, 0}}, {{2, 0}}, {{2, 0.3}}, {{1.9, 0.4}}, {{1.8996, 0.4003}}, {{0, 0.4}}},
                     true);
  const Descent ramp = ramp_along(border, params);
  EXPECT_EQ(ramp.ramp_by.size(), 4u);
  EXPECT_GT(shortest(ramp), 0.002);
  const Curve round({{{0, 0}}, {{2, 0}, std::tan(kPi / 8)}, {{2.05, 0.05}}, {{2.05, 0.4}}}, true);
  const Descent rounded = ramp_along(round, params);
  EXPECT_GT(rounded.ramp_by.size(), 4u);
  EXPECT_GT(shortest(rounded), 0.002);
  // A corner stays, however short its side.
  const Curve corner({{{0, 0}}, {{2, 0}}, {{2, 0.001}}, {{0, 0.4}}}, true);
  EXPECT_EQ(ramp_along(corner, params).ramp_by.size(), 3u);
}

TEST(Entry, KeepsItsHelixRoundWhereThatRemovesAsMuchAsACut) {
  ClearingParams params;
  params.levels = {-3};
  params.engagement_angle = kPi / 6;
  const Region wide = rectangular(0, 0, 40, 40);
  std::optional<Entry> entry = descend_within(Area({wide}), widest(wide), params);
  stretch_helix(*entry, Area({wide}), params);
  EXPECT_EQ(norm(entry->descent.stretch), 0);
}

// At the round ends every direction of the wall is as near.
TEST(Entry, StretchesAHelixAlongASlotFromItsMiddleAndFromEitherRoundEnd) {
  ClearingParams params;
  for (const double degrees : {60.0, 90.0, 110.0, 150.0})
    for (const double room : {0.75, 1.5, 2.0})
      for (const double angle : {0.0, 0.4, 1.2, 2.5}) {
        SCOPED_TRACE(std::to_string(degrees) + " " + std::to_string(room));
        params.engagement_angle = degrees * kPi / 180;
        const auto at = [&](double x, double y) { return rotated(Vec2{x, y}, angle); };
        const Area slot({make_region(
            Curve({{at(0, -room)}, {at(40, -room), 1}, {at(40, room)}, {at(0, room), 1}}, true))});
        for (const double x : {0.0, 20.0, 40.0}) {
          std::optional<Entry> entry = descend_within(slot, {at(x, 0), room}, params);
          ASSERT_TRUE(entry);
          stretch_helix(*entry, slot, params);
          const Descent& helix = entry->descent;
          ASSERT_GT(norm(helix.stretch), 1);
          // There is a little play between the walls.
          EXPECT_GT(std::abs(dot(normalized(helix.stretch), unit(angle))), 0.9998);
          EXPECT_GT(slot.signed_distance(helix.centre + helix.stretch), helix.radius - 1e-6);
          EXPECT_GT(slot.signed_distance(helix.centre - helix.stretch), helix.radius - 1e-6);
          EXPECT_LT(cleared_area(helix, 3), kMostCleared * kPi * 36 + 1e-6);
        }
      }
}

TEST(Entry, FillsARoomOfHundredthsOfAMillimetreWithARoundHelix) {
  ClearingParams params;
  const Region slot = rectangular(0, 0, 20, 0.2), room = rectangular(0, 0, 20, 2);
  const auto filled = [&](const Region& region) {
    std::optional<Entry> entry = descend_within(Area({region}), widest(region), params);
    fill_narrow_room(*entry, widest(region), params);
    EXPECT_NEAR(distance(entry->start.p, entry->descent.centre), entry->descent.radius, 1e-12);
    EXPECT_EQ(entry->start.p, entry->descent.at);
    EXPECT_GE(Area({region}).signed_distance(entry->descent.at), -1e-9);
    return entry->descent.radius;
  };
  EXPECT_NEAR(filled(slot), 0.1, 1e-5);
  EXPECT_LT(filled(room), 0.985);  // the first pass has room to turn outwards
  params.helix_diameter = 0.18;
  EXPECT_EQ(filled(slot), 0.09);  // as asked for
  // What is stretched keeps from the walls.
  params.helix_diameter = 4;
  Entry stretched = *descend_within(Area({slot}), widest(slot), params);
  stretched.descent.stretch = {5, 0};
  const double radius = stretched.descent.radius;
  fill_narrow_room(stretched, widest(slot), params);
  EXPECT_EQ(stretched.descent.radius, radius);
}

// mm^2 that two circles of these radii share, whose centres are `apart` mm apart.
double shared(double r, double s, double apart) {
  const double a = std::acos((apart * apart + r * r - s * s) / (2 * apart * r)),
               b = std::acos((apart * apart + s * s - r * r) / (2 * apart * s));
  return r * r * (a - std::sin(a) * std::cos(a)) + s * s * (b - std::sin(b) * std::cos(b));
}

TEST(Entry, CountsWhatOfItsGroundNothingClearedBefore) {
  Descent helix{DescentKind::kHelix, {2.7, 0}, {0, 0}, 2.7, {}, false};
  const double whole = kPi * 5.7 * 5.7;
  const Bounds box{{-20, -20}, {20, 20}};
  const ClearedGround untouched(box, 3, nullptr);
  EXPECT_DOUBLE_EQ(area_cut_by(helix, untouched), whole);
  for (const double apart : {4.0, 6.0, 8.0}) {
    ClearedGround ground(box, 3, nullptr);
    ground.add_disc({0, apart}, 5);
    EXPECT_NEAR(area_cut_by(helix, ground), whole - shared(5.7, 5, apart), 0.005 * whole);
  }
  std::vector<Region> half{rectangular(-20, -20, 0, 20)};
  std::vector<Vertex> vertices = half.front().outer.vertices();
  for (Vertex& v : vertices) v.open = true;
  half.front().outer = Curve(vertices, true);
  EXPECT_NEAR(area_cut_by(helix, ClearedGround(box, 3, &half)), whole / 2, 0.005 * whole);
  Descent ramp{DescentKind::kRamp, {-8, 0}, {}, 0, {{8, 0}}, false};
  const double swept = kPi * 9 + 16 * 6;
  EXPECT_NEAR(area_cut_by(ramp, ClearedGround(box, 3, &half)), swept / 2, 0.005 * swept);
}

TEST(Entry, IsNeverAPlunge) {
  const Region dot = rectangular(0, 0, 4e-4, 4e-4);
  EXPECT_FALSE(descend_within(Area({dot}), widest(dot), {}));
}

struct TwoPockets {
  std::vector<Region> regions{rectangular(0, 0, 20, 20), rectangular(30, 0, 60, 30)};
  ClearingParams params;
  TwoPockets() {
    params.levels = {-1, -2};
    params.entry_point = Vec2{10, 10};
    params.hole_diameter = 8;
  }
  Toolpath clear() const {
    Progress progress;
    return clear_pocket(regions, params, progress);
  }
};

TEST(Entry, OfOneRegionByItsHoleLeavesTheOtherItsHelixAndSaysSo) {
  const Toolpath path = TwoPockets().clear();
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  bool helix = false;
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::kEntry) continue;
    if (move.x < 25) {
      EXPECT_EQ(move.sweep, 0) << "straight into the hole";
      EXPECT_EQ(move.x, 10);
    } else {
      helix |= move.sweep != 0;
    }
  }
  EXPECT_TRUE(helix);
  EXPECT_TRUE(corpus::tells(path.report, FindingCode::kRegionWithOwnEntry));
}

TEST(Entry, TellsThatAHelixWiderThanTheToolWasNarrowed) {
  TwoPockets pockets;
  for (const double wish : {5.4, 5.88, 6.0, 12.0}) {
    pockets.params.helix_diameter = wish;
    EXPECT_EQ(corpus::tells(pockets.clear().report, FindingCode::kHelixNarrowed), wish > 5.88)
        << wish;
  }
}

// Feed control must not forget where a region begins.
TEST(Order, IsKeptByEveryFeedControl) {
  for (const FeedControl control : {FeedControl::kConstantFeed, FeedControl::kConstantRemovalRate})
    for (const OrderBy order : {OrderBy::kRegion, OrderBy::kDepth}) {
      TwoPockets pockets;
      pockets.params.feed_control = control;
      pockets.params.order_by = order;
      std::vector<int> places;  // 2 x region + level
      for (const Move& move : pockets.clear().moves) {
        if (move.kind != MoveKind::kCut) continue;
        const int place = (move.x < 25 ? 0 : 2) + (move.z < -1.5 ? 1 : 0);
        if (places.empty() || places.back() != place) places.push_back(place);
      }
      EXPECT_EQ(places, order == OrderBy::kRegion ? (std::vector<int>{0, 1, 2, 3})
                                                  : (std::vector<int>{0, 2, 1, 3}));
    }
}

}  // namespace
}  // namespace evenload
