#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "geometry/vec2.h"
#include "toolpath/path_commands.h"

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

TEST(PathCommands, ACutBeforeThePlaceIsKnownIsRefused) {
  EXPECT_THROW(path_commands({cut_to(1, 2)}, {}), std::invalid_argument);
  EXPECT_NO_THROW(path_commands({cut_to(1, 2)}, kStart));
}

}  // namespace
}  // namespace evenload
