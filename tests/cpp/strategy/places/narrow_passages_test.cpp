#include "strategy/places/narrow_passages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shapes.h"
#include "judge/corpus.h"
#include "strategy/places/area.h"

namespace evenload {
namespace {

Region area_of(std::vector<Vertex> outer, std::vector<Curve> islands = {}) {
  return make_region(Curve(std::move(outer), true), std::move(islands));
}

Region rectangle(double x0, double y0, double x1, double y1) {
  return area_of({{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}});
}

// Two rooms of 10 x 10 mm, joined by a neck 6 mm long and `width` mm wide.
Region two_rooms(double width) {
  const double h = width / 2;
  return area_of({{{0, -5}},
                  {{10, -5}},
                  {{10, -h}},
                  {{16, -h}},
                  {{16, -5}},
                  {{26, -5}},
                  {{26, 5}},
                  {{16, 5}},
                  {{16, h}},
                  {{10, h}},
                  {{10, 5}},
                  {{0, 5}}});
}

double area_of(const NarrowPlaces& places) {
  double area = 0;
  for (const Region& room : places.rooms) area += room.area();
  for (const Passage& passage : places.passages) area += passage.centres.area();
  return area;
}

TEST(NarrowPlaces, LeaveAWideRegionWithItsCornersAsOneRoom) {
  const Region square = rectangle(0, 0, 20, 10);
  const NarrowPlaces places = find_narrow_places(square, 0.9);
  ASSERT_EQ(places.rooms.size(), 1u);
  EXPECT_TRUE(places.passages.empty());
  EXPECT_NEAR(places.rooms.front().area(), square.area(), 1e-4);
}

TEST(NarrowPlaces, AreTheWholeRegionWhereTheDiscDoesNotFit) {
  const Region slot = rectangle(0, 0, 20, 0.1);
  const NarrowPlaces places = find_narrow_places(slot, 0.9);
  EXPECT_TRUE(places.rooms.empty());
  ASSERT_EQ(places.passages.size(), 1u);
  EXPECT_TRUE(places.passages.front().rooms.empty());
  EXPECT_NEAR(places.passages.front().centres.area(), 2, 1e-9);
}

TEST(NarrowPlaces, FindTheNeckThatJoinsTwoRooms) {
  for (const double width : {0.01, 0.2, 1.0, 1.7}) {
    SCOPED_TRACE(width);
    const Region region = two_rooms(width);
    const NarrowPlaces places = find_narrow_places(region, 0.9);
    ASSERT_EQ(places.rooms.size(), 2u);
    ASSERT_EQ(places.passages.size(), 1u);
    const Passage& neck = places.passages.front();
    EXPECT_EQ(neck.rooms.size(), 2u);
    EXPECT_NE(neck.rooms[0], neck.rooms[1]);
    // The disc reaches a little way into it.
    EXPECT_LT(neck.centres.area(), 6 * width);
    EXPECT_GT(neck.centres.area(), 5 * width);
    EXPECT_TRUE(neck.centres.contains({13, 0}));
    EXPECT_NEAR(area_of(places), region.area(), 1e-4);
  }
  EXPECT_TRUE(find_narrow_places(two_rooms(1.9), 0.9).passages.empty());
}

// A dead end is a passage once it is deeper than a corner of 60 degrees.
TEST(NarrowPlaces, TakeShortDeadEndsForCorners) {
  const auto with_dead_end = [](double depth) {
    return area_of({{{0, 0}},
                    {{10, 0}},
                    {{10, 4}},
                    {{10 + depth, 4}},
                    {{10 + depth, 5}},
                    {{10, 5}},
                    {{10, 10}},
                    {{0, 10}}});
  };
  EXPECT_EQ(find_narrow_places(with_dead_end(0.5), 0.9).passages.size(), 0u);
  const NarrowPlaces places = find_narrow_places(with_dead_end(2), 0.9);
  ASSERT_EQ(places.passages.size(), 1u);
  EXPECT_EQ(places.passages.front().rooms, std::vector<std::size_t>{0});
  EXPECT_NEAR(area_of(places), 102, 1e-4);
}

TEST(NarrowPlaces, TakeCornersSharperThanSixtyDegreesForPassages) {
  const auto wedge = [](double degrees) {
    const double half = degrees * kPi / 360, x = 20 * std::cos(half), y = 20 * std::sin(half);
    return area_of({{{0, 0}}, {{x, -y}}, {{x + 20, -y}}, {{x + 20, y}}, {{x, y}}});
  };
  EXPECT_EQ(find_narrow_places(wedge(61), 0.9).passages.size(), 0u);
  EXPECT_EQ(find_narrow_places(wedge(55), 0.9).passages.size(), 1u);
}

TEST(NarrowPlaces, GoRoundAnIslandThatNoRoomTouches) {
  const Region ring =
      area_of({{{10, 0}, 1}, {{-10, 0}, 1}}, {Curve({{{9.8, 0}, 1}, {{-9.8, 0}, 1}}, true)});
  const NarrowPlaces places = find_narrow_places(ring, 0.9);
  ASSERT_EQ(places.passages.size(), 1u);
  EXPECT_EQ(places.passages.front().loops.size(), 2u);
  EXPECT_NEAR(places.passages.front().centres.area(), kPi * (100 - 9.8 * 9.8), 1e-6);
}

// Between wall and island: one passage with two mouths of one room.
TEST(NarrowPlaces, NameARoomTwiceThatAPassageLeavesAndComesBackTo) {
  const Region region = area_of({{{0, 0}}, {{30, 0}}, {{30, 20}}, {{0, 20}}},
                                {Curve({{{10, 1}}, {{20, 1}}, {{20, 10}}, {{10, 10}}}, true)});
  const NarrowPlaces places = find_narrow_places(region, 0.9);
  ASSERT_EQ(places.rooms.size(), 1u);
  ASSERT_EQ(places.passages.size(), 1u);
  EXPECT_EQ(places.passages.front().rooms, (std::vector<std::size_t>{0, 0}));
  EXPECT_NEAR(area_of(places), 600 - 90, 1e-4);
}

// No user's MinimumRadius is too small or fits too exactly.
TEST(NarrowPlaces, AreFoundForDiscsOfAnySize) {
  for (double radius = 1e-7; radius < 10; radius *= 3) {
    SCOPED_TRACE(radius);
    EXPECT_NEAR(area_of(find_narrow_places(two_rooms(1), radius)), 206, 1e-3);
  }
  for (double off = 1e-9; off < 1e-3; off *= 10)
    for (const double radius : {0.5 - off, 0.5, 0.5 + off}) {
      SCOPED_TRACE(off);
      EXPECT_NEAR(area_of(find_narrow_places(two_rooms(1), radius)), 206, 1e-3);
    }
  const NarrowPlaces all = find_narrow_places(two_rooms(1), kShallow);
  EXPECT_EQ(all.rooms.size(), 1u);
  EXPECT_TRUE(all.passages.empty());
}

// Whatever the region: nothing is lost, and walls stay walls.
TEST(NarrowPlaces, DivideEveryRegionOfTheCorpus) {
  for (const std::string& name : corpus::names()) {
    const corpus::Case pocket = corpus::load(name);
    for (const Region& region : offset({pocket.region}, -0.5 * pocket.tool_diameter))
      for (const double radius : {0.05, 0.3, 0.9, 2.0, 5.0}) {
        SCOPED_TRACE(name + " " + std::to_string(radius));
        const NarrowPlaces places = find_narrow_places(region, radius);
        EXPECT_NEAR(area_of(places), region.area(), 1e-4 * region.area() + 1e-4);
        const Area walls({region});
        for (const Region& room : places.rooms) {
          EXPECT_NO_THROW(make_region(room.outer, room.islands));
          for (const Vertex& v : room.outer.vertices())
            EXPECT_GT(walls.signed_distance(v.p), -1e-5);
        }
        for (const Passage& passage : places.passages)
          for (const std::vector<PassageBorder>& loop : passage.loops)
            for (std::size_t i = 0; i < loop.size(); ++i) {
              const Segment& s = loop[i].segment;
              EXPECT_LT(distance(s.b, loop[(i + 1) % loop.size()].segment.a), 1e-5);
              if (!loop[i].is_mouth) {
                EXPECT_LT(std::abs(walls.signed_distance(s.point(0.5))), 1e-6);
              }
            }
      }
  }
}

}  // namespace
}  // namespace evenload
