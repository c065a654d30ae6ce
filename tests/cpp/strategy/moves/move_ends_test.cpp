// Ways that are shortened at their ends.
#include "strategy/moves/move_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "toolpath/machinable.h"

namespace evenload {
namespace {

// A line along x, and a turn to the left.
std::vector<Segment> way_that_ends_in_a_turn(double radius, double sweep) {
  return {Segment::line({-1, 0}, {0, 0}), Segment::arc({0, radius}, radius, -kPi / 2, sweep)};
}

TEST(MoveEnds, AreShortenedOnTheirLineOrCircle) {
  std::vector<Segment> way = way_that_ends_in_a_turn(1, 1);
  drop_last(way, 0.25);
  ASSERT_EQ(way.size(), 2u);
  EXPECT_NEAR(way.back().sweep, 0.75, 1e-12);
  drop_last(way, 1);
  ASSERT_EQ(way.size(), 1u);
  EXPECT_NEAR(way.back().length(), 0.75, 1e-12);
  drop_first(way, 0.25);
  EXPECT_NEAR(way.front().length(), 0.5, 1e-12);
  drop_first(way, 1);
  EXPECT_EQ(way.size(), 1u);
}

TEST(MoveEnds, JoinUpToHalfATurn) {
  const Segment whole = Segment::arc({1, 2}, 0.1, 0.3, kPi);
  const std::vector<Segment> both = joined({whole.part(0, 0.9), whole.part(0.9, 1)});
  ASSERT_EQ(both.size(), 1u);
  EXPECT_NEAR(both.front().sweep, kPi, 1e-12);
  const Segment more = Segment::arc({1, 2}, 0.1, 0.3, 1.01 * kPi);
  EXPECT_EQ(joined({more.part(0, 0.9), more.part(0.9, 1)}).size(), 2u);
}

// Of a turn by 100 degrees at 0.08 mm a half would be posted as lines.
TEST(MoveEnds, KeepAnArcWholeOfWhichTheRestWouldBePostedAsLines) {
  const std::vector<Segment> way = way_that_ends_in_a_turn(0.08, 1.75);
  ASSERT_FALSE(is_tight(way.back()));
  ASSERT_TRUE(is_tight(way.back().part(0, 0.5)));
  std::vector<Segment> shorter = way;
  drop_last(shorter, 0.07);
  ASSERT_EQ(shorter.size(), 2u);
  EXPECT_EQ(shorter.back().sweep, way.back().sweep);
  drop_last(shorter, 0.2);
  EXPECT_EQ(shorter.size(), 1u);

  std::vector<Segment> turn{way.back()};
  drop_first(turn, 0.07);
  EXPECT_EQ(turn.front().sweep, way.back().sweep);
}

}  // namespace
}  // namespace evenload
