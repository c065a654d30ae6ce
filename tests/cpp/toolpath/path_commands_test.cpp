#include "toolpath/path_commands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "geometry/vec2.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

constexpr Position kStart{0, 0, -3};

Move cut_to(double x, double y, double z = -3) { return {MoveKind::kCut, x, y, z, 0, 0, 0, 300}; }
Move rapid_to(double x, double y, double z) { return {MoveKind::kRapid, x, y, z, 0, 0, 0, 0}; }

// What printing and reading again gives: the nearest decimal, exactly.
double printed(double value, int decimals) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return std::strtod(text, nullptr);
}

TEST(PathCommands, RoundingGivesTheNearestDecimalEvenBesideTies) {
  std::mt19937 source(5);
  std::uniform_int_distribution<int> number(-2'000'000, 2'000'000);
  for (int i = 0; i < 100'000; ++i) {
    const double tie = (number(source) + 0.5) / 1e4;
    for (const double value : {tie, std::nextafter(tie, 1e9), std::nextafter(tie, -1e9), tie / 3})
      EXPECT_EQ(rounded(value, 4), printed(value, 4)) << value;
  }
  for (const double value : {1e15 + 0.5, -3e200, 0.0, 5e-324})
    EXPECT_EQ(rounded(value, 6), printed(value, 6)) << value;
}

TEST(PathCommands, RapidsAtTheEndCanBeLeftOut) {
  const std::vector<Move> moves{rapid_to(0, 0, 10), rapid_to(0, 0, -3), cut_to(5, 0),
                                rapid_to(5, 0, 5), rapid_to(5, 0, 10)};
  EXPECT_EQ(path_commands(moves, {}).size(), 6u);
  const auto shorter = path_commands(moves, {}, 10);
  ASSERT_EQ(shorter.size(), 5u);
  EXPECT_EQ(shorter.back().z, 5);
  EXPECT_TRUE(path_commands({moves[0]}, {}, 10).empty());
}

TEST(PathCommands, AFullTurnIsTwoHalvesWithOneCentre) {
  const Move turn{MoveKind::kCut, 0, 0, -3, -2 * kPi, 4, 0, 300};
  const auto made = path_commands({turn}, kStart);
  ASSERT_EQ(made.size(), 2u);
  for (const PathCommand& half : made) EXPECT_EQ(half.code, 2);
  EXPECT_EQ(made[0].x, 8);
  EXPECT_EQ(made[0].i, 4);
  EXPECT_EQ(made[1].i, -4);
}

// An arc of any radius, sweep and place, from a start on the grid.
struct RandomArc {
  explicit RandomArc(std::mt19937& source) {
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(source);
    };
    radius = std::exp(uniform(std::log(0.002), std::log(100)));
    const double turn =
        uniform(0, 1) < 0.7 ? std::exp(uniform(std::log(0.002), std::log(2))) : uniform(0, 4 * kPi);
    sweep = uniform(0, 1) < 0.5 ? turn : -turn;
    start = {rounded(uniform(-100, 100), 4), rounded(uniform(-100, 100), 4), -3};
    const double angle = uniform(-kPi, kPi);
    centre = Vec2{start.x, start.y} - radius * unit(angle);
    const Vec2 end = centre + radius * unit(angle + sweep);
    move = {MoveKind::kCut, end.x, end.y, -3, sweep, centre.x, centre.y, 300};
  }

  double radius, sweep;
  Position start;
  Vec2 centre;
  Move move;
};

TEST(PathCommands, AnArcThatDoesNotBecomeCornersStaysArcs) {
  std::mt19937 source(31);
  int tight = 0;
  for (int round = 0; round < 50'000; ++round) {
    const RandomArc arc(source);
    if (std::abs(arc.sweep) < kUnseenTurn || becomes_corners(arc.radius, arc.sweep)) continue;
    if (arc.radius < 0.1) ++tight;
    const auto made = path_commands({arc.move}, arc.start);
    EXPECT_EQ(made.size(), static_cast<std::size_t>(pieces_of_arc(arc.sweep)));
    for (const PathCommand& command : made)
      EXPECT_EQ(command.code, arc.sweep > 0 ? 3 : 2) << arc.radius << " mm, " << arc.sweep;
  }
  EXPECT_GT(tight, 1000);
}

TEST(PathCommands, LinesLeaveTheArcThatTheyReplaceByNoMoreThanTheSagitta) {
  constexpr double kSagitta = 0.004, kGrid = 1e-4;
  std::mt19937 source(32);
  int lines = 0;
  for (int round = 0; round < 50'000; ++round) {
    const RandomArc arc(source);
    Vec2 at{arc.start.x, arc.start.y};
    for (const PathCommand& command : path_commands({arc.move}, arc.start)) {
      const Vec2 to{*command.x, *command.y};
      // Nearer to the centre than so the middle of a line of the tightest arcs cannot be.
      const double most = arc.radius < kLeastArcRadius ? 2 * arc.radius : kSagitta;
      for (int i = 0; command.code == 1 && i <= 10; ++i) {
        const double off = distance(at + 0.1 * i * (to - at), arc.centre) - arc.radius;
        EXPECT_LE(std::abs(off), most + kGrid) << arc.radius << " mm, " << arc.sweep;
      }
      lines += command.code == 1;
      at = to;
    }
  }
  EXPECT_GT(lines, 1000);
}

// A move along a circle about `centre`, from `angle` on.
Move turn_about(Vec2 centre, double radius, double angle, double sweep) {
  const Vec2 end = centre + radius * unit(angle + sweep);
  return {MoveKind::kCut, end.x, end.y, -3, sweep, centre.x, centre.y, 300};
}

TEST(PathCommands, ATinyMoveInASmoothWayIsAPartOfTheNext) {
  for (const double length : {0.0006, 0.001, 0.0029, 0.0059}) {
    const double radius = 1.5, tiny = length / radius;
    const std::vector<Move> moves{cut_to(-1, 0), cut_to(0, 0),
                                  turn_about({0, radius}, radius, -kPi / 2, tiny),
                                  turn_about({0, radius}, radius, -kPi / 2 + tiny, 0.2)};
    const auto made = path_commands(moves, Position{-2, 0, -3});
    ASSERT_EQ(made.size(), 3u) << length;
    EXPECT_EQ(made[1].x, 0);
    EXPECT_EQ(made[2].code, 3);
    EXPECT_EQ(made[2].x, rounded(moves[3].x, 4));
    EXPECT_EQ(made[2].y, rounded(moves[3].y, 4));
    // It begins where the tiny move began, in its direction, to half a degree.
    EXPECT_LT(std::abs(std::atan2(*made[2].i, *made[2].j)), 0.0087);
    // The next may be a line.
    const double heading = tiny / 2;
    const std::vector<Move> line{
        cut_to(-1, 0), cut_to(0, 0), cut_to(length * std::cos(heading), length * std::sin(heading)),
        cut_to((length + 0.03) * std::cos(heading), (length + 0.03) * std::sin(heading))};
    const auto straight = path_commands(line, Position{-2, 0, -3});
    ASSERT_EQ(straight.size(), 3u) << length;
    EXPECT_EQ(straight[2].x, rounded(line[3].x, 4));
    EXPECT_EQ(straight[2].y, rounded(line[3].y, 4));
  }
}

TEST(PathCommands, ATinyMoveStaysAtACornerAndBeforeATightTurn) {
  const double tiny = 0.002;
  const Move around = turn_about({1 + tiny, -1}, 1, kPi / 2, -0.2);
  const std::vector<Move> corner{cut_to(0, 0), cut_to(0, 1), cut_to(tiny, 1), around};
  EXPECT_EQ(path_commands(corner, Position{0, -1, -3}).size(), 4u);
  // A step aside between two ways in the same direction.
  const std::vector<Move> aside{cut_to(-1, 0), cut_to(0, 0), cut_to(0, tiny),
                                turn_about({0, 1.5 + tiny}, 1.5, -kPi / 2, 0.2)};
  EXPECT_EQ(path_commands(aside, Position{-2, 0, -3}).size(), 4u);
  // As a part of a line hardly longer it would turn that.
  const std::vector<Move> both{cut_to(-1, 0), cut_to(0, 0), cut_to(0.005, 0), cut_to(0.013, 0)};
  EXPECT_EQ(path_commands(both, Position{-2, 0, -3}).size(), 4u);
  const Move tight = turn_about({tiny, 0.1}, 0.1, -kPi / 2, 1.5);
  const std::vector<Move> before_turn{cut_to(-1, 0), cut_to(0, 0), cut_to(tiny, 0), tight};
  EXPECT_EQ(path_commands(before_turn, Position{-2, 0, -3}).size(), 4u);
}

// The lifted link comes down by 0.3 micrometres less than cuts lie deep, or by a line too short to
// be written.
TEST(PathCommands, ADescentTooShortToBeWrittenIsNotMissingFromTheCutsBelow) {
  Move link{MoveKind::kLink, 4, 0, -2.9997, 0, 0, 0, 1500}, end = link;
  end.x = 4.0003;
  end.z = -3;
  for (const auto& links : {std::vector<Move>{link}, std::vector<Move>{link, end}}) {
    std::vector<Move> moves{rapid_to(0, 0, 5), cut_to(0, 0)};
    moves.insert(moves.end(), links.begin(), links.end());
    moves.push_back(cut_to(8, 0));
    moves.push_back({MoveKind::kCut, 8, 4, -3, kPi, 8, 2, 300});
    const auto made = path_commands(moves, {});
    ASSERT_GE(made.size(), 4u);
    for (std::size_t i = made.size() - 3; i < made.size(); ++i) EXPECT_EQ(made[i].z, -3);
  }
}

// Descents at a feed stay so, and many short ones are not one.
TEST(PathCommands, NoRapidAndNoSingleMoveTakesShortDescents) {
  std::vector<Move> moves{rapid_to(0, 0, -1)};
  for (int i = 1; i <= 10; ++i) moves.push_back(cut_to(0, 0, -1 - 0.0004 * i));
  moves.push_back(cut_to(5, 0, -1.004));
  const auto made = path_commands(moves, Position{0, 0, 5});
  double z = 5, at_feed = 0;
  for (const PathCommand& command : made) {
    if (command.code == 0) {
      EXPECT_GE(command.z.value_or(z), -1);
    } else {
      EXPECT_LT(z - *command.z, 0.0015);
      at_feed += z - *command.z;
    }
    z = command.z.value_or(z);
  }
  EXPECT_NEAR(z, -1.004, 1e-9);
  EXPECT_NEAR(at_feed, 0.004, 1e-9);
}

// Or it would be level, in the middle of material.
TEST(PathCommands, EveryLineOfARampDescends) {
  std::vector<Move> moves{rapid_to(0, 0, 0)};
  for (int i = 1; i <= 40; ++i)
    moves.push_back({MoveKind::kEntry, 0.005 * i, 0, -0.0003 * i, 0, 0, 0, 255});
  const auto made = path_commands(moves, Position{0, 0, 5});
  ASSERT_EQ(made.size(), 41u);
  for (std::size_t i = 1; i < made.size(); ++i) EXPECT_NEAR(*made[i].z, -0.0003 * i, 1e-9);
}

TEST(PathCommands, ACutBeforeThePlaceIsKnownIsRefused) {
  EXPECT_THROW(path_commands({cut_to(1, 2)}, {}), std::invalid_argument);
  EXPECT_NO_THROW(path_commands({cut_to(1, 2)}, kStart));
}

}  // namespace
}  // namespace evenload
