// The way of a helix, and the feeds of its last, level turn.
#include "toolpath/level_turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/numbers.h"
#include "toolpath/helix.h"

namespace evenload {
namespace {

Descent helix_of(double radius, Vec2 stretch) {
  Descent helix;
  helix.kind = DescentKind::kHelix;
  helix.centre = {40, -7};
  helix.radius = radius;
  helix.stretch = stretch;
  const Vec2 ahead = norm(stretch) > 0 ? normalized(stretch) : Vec2{1, 0};
  helix.at = helix.centre + stretch + radius * ahead;
  return helix;
}

std::vector<Descent> helices() {
  return {helix_of(2.7, {}), helix_of(0.06, {}), helix_of(1.4, {3, 4}), helix_of(0.2, {-0.1, 9})};
}

constexpr double kDepth = 3, kSteepness = 0.0524;
const LevelTurnFeeds kFeeds{255, 488, 1.5 * 255};

TEST(WayRound, RunsWithoutGapsOrKinksToWhereTheHelixArrives) {
  for (const Descent& helix : helices()) {
    const double turn = 2 * half_turn_length(helix);
    for (const double from : {0.01 * turn, 0.4 * turn, 0.5 * turn, turn, 3.3 * turn})
      for (const double to : {0.0, 0.3 * from, 0.99 * from}) {
        const std::vector<Segment> way = way_round(helix, from, to);
        ASSERT_FALSE(way.empty());
        double length = 0;
        for (std::size_t i = 0; i < way.size(); ++i) {
          length += way[i].length();
          EXPECT_LE(way[i].sweep, kPi + 1e-9);
          if (i == 0) continue;
          EXPECT_LT(distance(way[i - 1].b, way[i].a), 1e-9);
          EXPECT_LT(distance(way[i - 1].tangent(1), way[i].tangent(0)), 1e-6);
        }
        EXPECT_NEAR(length, from - to, 1e-5);
        if (to == 0) {
          EXPECT_LT(distance(way.back().b, helix.at), 1e-9);
        }
      }
  }
}

TEST(LevelTurn, RemovesNoMoreThanACutOfTheWholeDepthUnlessItPlungesThatFast) {
  for (const Descent& helix : helices())
    for (const double steepness : {kSteepness, kDepth / (0.3 * half_turn_length(helix)), 0.01})
      for (const LevelTurnFeeds& feeds :
           {kFeeds, LevelTurnFeeds{100, 1000, 40}, LevelTurnFeeds{30, 400, 2 * 255}}) {
        const double length = 2 * half_turn_length(helix);
        double from = 0, feed = 0;
        for (const LevelPiece& piece : level_pieces(helix, kDepth, steepness, kRadius, feeds)) {
          const double layer = std::min(kDepth, steepness * (length - from));
          EXPECT_LE(piece.feed * layer * 2 * kRadius,
                    std::max(feeds.rate * kDepth, feeds.plunge * layer * 2 * kRadius) + 1e-6);
          EXPECT_GE(piece.feed, std::max(feed, feeds.plunge) - 1e-9);
          EXPECT_LE(piece.feed, feeds.highest + 1e-9);
          EXPECT_GT(piece.end - from, std::min(0.2, length) - 1e-9);
          from = piece.end;
          feed = piece.feed;
        }
        EXPECT_EQ(from, length);
      }
}

TEST(LevelTurn, RunsAtItsHighestFeedInTheEnd) {
  const std::vector<LevelPiece> pieces =
      level_pieces(helix_of(2.7, {}), kDepth, kSteepness, kRadius, kFeeds);
  EXPECT_EQ(pieces.front().feed, kFeeds.plunge);
  EXPECT_NEAR(pieces.back().feed, kFeeds.highest, 1e-9);
  for (std::size_t i = 1; i < pieces.size(); ++i)
    EXPECT_LE(pieces[i].feed, 1.2 * pieces[i - 1].feed + 1e-9);
  // The integral of the layer's thickness would be 0.69 of the turn at the plunge feed.
  const double whole = 2 * kPi * 2.7 / kFeeds.plunge;
  EXPECT_LT(duration(pieces), 0.75 * whole);
  EXPECT_GT(duration(pieces), 0.69 * whole);
}

TEST(LevelTurn, IsOnePieceAtThePlungeFeedWhereNoneIsHigher) {
  for (const double highest : {0.0, 200.0, 255.0}) {
    const std::vector<LevelPiece> pieces =
        level_pieces(helix_of(1.4, {3, 4}), kDepth, kSteepness, kRadius, {255, highest, 1.5 * 255});
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces.front().feed, 255);
  }
}

}  // namespace
}  // namespace evenload
