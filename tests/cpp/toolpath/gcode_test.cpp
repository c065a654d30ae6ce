#include "toolpath/gcode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace evenload {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A program that stands at the origin, in mm, with a feed.
GCodeProgram from_origin(const std::string& text) {
  GCodeOptions options;
  options.start = {{0, 0, 0}};
  return read_gcode("G21 F100\n" + text, options);
}

Move last(const GCodeProgram& program) { return program.moves.back(); }

std::string error_of(const std::string& text, int line) {
  GCodeOptions options;
  options.start = {{0, 0, 0}};
  try {
    read_gcode(text, options);
  } catch (const GCodeError& error) {
    EXPECT_EQ(error.line(), line) << text;
    EXPECT_EQ(std::string(error.what()).rfind("Line " + std::to_string(line) + ": ", 0), 0u);
    return error.what();
  }
  ADD_FAILURE() << "no error in: " << text;
  return "";
}

// Each note as "LINE sentence".
std::vector<std::string> notes_of(const GCodeProgram& program) {
  std::vector<std::string> notes;
  for (const GCodeNote& note : program.notes)
    notes.push_back(std::to_string(note.line) + " " + note.text);
  return notes;
}

void expect_at(const Move& move, double x, double y, double z) {
  EXPECT_NEAR(move.x, x, 1e-9);
  EXPECT_NEAR(move.y, y, 1e-9);
  EXPECT_NEAR(move.z, z, 1e-9);
}

// ---- words ----

TEST(GCodeWords, NeedNoSpacesAndStandSpacesAnywhere) {
  for (const char* line : {"G1X1.5Y-2Z.25", "g1 x1.5 y-2 z.25", "G01 X 1.5 Y - 2. Z+0. 25",
                           "\tG1X1.5(in)Y-2(between)Z.25;end", "N10G1X1.5Y-2Z.25", "z.25y-2x1.5g1"})
    expect_at(last(from_origin(line)), 1.5, -2, 0.25);
}

TEST(GCodeWords, EndTheirLinesAsOnAnySystem) {
  for (const char* text : {"G1 X1\nY2\nZ3", "G1 X1\r\nY2\r\nZ3\r\n", "G1 X1\rY2\rZ3"}) {
    const GCodeProgram program = from_origin(text);
    EXPECT_THAT(program.lines, ElementsAre(2, 3, 4)) << text;
    expect_at(last(program), 1, 2, 3);
  }
  EXPECT_EQ(read_gcode("\xEF\xBB\xBFG0 X1 Y2 Z3").start_x, 1);
}

TEST(GCodeWords, AreRefusedWithTheirLineWhenTheyAreNone) {
  EXPECT_THAT(error_of("G0 X1\nG1 X F1", 2), HasSubstr("X has no number"));
  EXPECT_THAT(error_of("X-", 1), HasSubstr("X has no number"));
  EXPECT_THAT(error_of("X.", 1), HasSubstr("X has no number"));
  EXPECT_THAT(error_of("X--1", 1), HasSubstr("X has no number"));
  EXPECT_THAT(error_of("X1.2.3", 1), HasSubstr("two decimal points"));
  EXPECT_THAT(error_of("G0 X1e5", 1), HasSubstr("exponent"));
  EXPECT_THAT(error_of("G0 X1.E-5", 1), HasSubstr("exponent"));
  EXPECT_THAT(error_of("G0 X" + std::string(400, '9'), 1), HasSubstr("beyond"));
  EXPECT_THAT(error_of("G0 X10000000000", 1), HasSubstr("beyond"));
  EXPECT_THAT(error_of("G0 XNAN", 1), HasSubstr("X has no number"));
  EXPECT_THAT(error_of("G0 XINF", 1), HasSubstr("X has no number"));
}

TEST(GCodeWords, MayHoldSpacesInTheirNumbers) {
  expect_at(last(from_origin("G1 X1 2. 5")), 12.5, 0, 0);
}

TEST(GCodeWords, AreRefusedWhenTheLineHoldsOneTwice) {
  EXPECT_THAT(error_of("\n\nG0 X1 X2", 3), HasSubstr("two words X"));
}

TEST(GCodeWords, OfFlowParametersAndExpressionsAreRefused) {
  for (const char* line : {"o100 sub", "O100 CALL [1]", "o<drill> call", "o12 while [1 LT 2]",
                           "O 100 endif", "#1=5", "G0 X#1", "G0 X[1+2]", "G0 X #<_x>"})
    EXPECT_THAT(error_of(std::string("G0\n") + line, 2), HasSubstr("cannot be run")) << line;
  for (const char* line : {"M98 P1000", "M99", "M97 P10", "G65 P9000", "G66 P1"})
    EXPECT_THAT(error_of(line, 1), HasSubstr("cannot be run")) << line;
}

TEST(GCodeWords, MayBeProgramAndLineNumbers) {
  const GCodeProgram program =
      read_gcode("%\nO01000 (PART 1)\nN5 G21 G0 X1 Y2 Z3\nN10 (only a number)\n:7\nN15 M30\n%\n");
  EXPECT_THAT(program.notes, IsEmpty());
  EXPECT_EQ(program.start_y, 2);
}

TEST(GCodeWords, OfUnknownLettersAndCodesAreNotedWithTheirLine) {
  const GCodeProgram program = from_origin("G1 X1 A90\nG187 P1\nM31\n$H\nE5\nG1 X2 Q3\nG1.25 X5\n");
  EXPECT_THAT(
      notes_of(program),
      ElementsAre("2 'A90' is not simulated.", "3 'G187 P1' is not simulated.",
                  "4 'M31' is not simulated.",
                  "5 '$H' is a setting of the controller: not simulated.",
                  "6 'E5' is not simulated.", "7 'Q3' is not simulated.",
                  "8 'G1.25 X5' is not simulated, and the place in its axes is unknown after it."));
}

TEST(GCodeWords, OfAnUnknownCodeLeaveTheMotionBesideItAlone) {
  const GCodeProgram program = from_origin("G187 P1 G1 X5\nG3 X10 R5\nM19 R45\nG12 I3\nX0 I-5 E5");
  EXPECT_THAT(notes_of(program),
              ElementsAre("2 'G187 P1' is not simulated.", "4 'M19 R45' is not simulated.",
                          "5 'G12 I3' is not simulated.", "6 'E5' is not simulated."));
  EXPECT_THAT(program.lines, ElementsAre(2, 3, 6));
}

TEST(GCodeWords, InCommentsAreNotRead) {
  const GCodeProgram program = from_origin("G1 X1 (X2) ; X3 (\n(G1 X9)\n;G1 X8\n(MSG, X7)G1 Y1");
  EXPECT_EQ(program.moves.size(), 2u);
  EXPECT_THAT(program.notes, IsEmpty());
  expect_at(last(program), 1, 1, 0);
}

TEST(GCodeWords, BehindACommentThatDoesNotEndAreNoted) {
  const GCodeProgram program = from_origin("G1 X1 (half a comment\nY1");
  EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("2 The comment does not end")));
  expect_at(last(program), 1, 1, 0);
}

TEST(GCodeWords, OfStrangeCharactersAreRefusedByTheirCode) {
  EXPECT_THAT(error_of("G0 X1 @2", 1), HasSubstr("'@'"));
  EXPECT_THAT(error_of(std::string("G0\nX1 \x01", 7), 2), HasSubstr("0x01"));
  EXPECT_THAT(error_of("(a)) X1", 1), HasSubstr("')'"));
}

TEST(GCode, ReadsLinesWithASlashUnlessTheSwitchIsOn) {
  const std::string text = "G21 G0 X0 Y0 Z0\n/G0 X1\n/2 G0 X2\nG0 Y5\n";
  const GCodeProgram off = read_gcode(text);
  EXPECT_THAT(off.lines, ElementsAre(2, 3, 4));
  EXPECT_THAT(notes_of(off), ElementsAre(HasSubstr("2 Lines that begin with '/' are run")));
  GCodeOptions options;
  options.block_delete = true;
  const GCodeProgram on = read_gcode(text, options);
  EXPECT_THAT(on.lines, ElementsAre(4));
  EXPECT_THAT(on.notes, IsEmpty());
}

TEST(GCode, EndsWithM2M30AndTheSecondPercent) {
  for (const char* end : {"M2", "M30", "G1 X1 M30", "%"}) {
    const GCodeProgram program =
        read_gcode(std::string("%\nG21 G0 X0 Y0 Z0 F1\n") + end + "\n%\n\nX@");
    EXPECT_LE(program.moves.size(), 1u);
    EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("6 The program has ended"))) << end;
  }
}

// ---- modes ----

TEST(GCode, HoldsTheMotionUntilAnother) {
  const GCodeProgram program = from_origin("G1 X1\nX2\nG0 X3\nX4\n");
  ASSERT_EQ(program.moves.size(), 4u);
  EXPECT_EQ(program.moves[1].kind, MoveKind::kCut);
  EXPECT_EQ(program.moves[1].feed, 100);
  EXPECT_EQ(program.moves[3].kind, MoveKind::kRapid);
  EXPECT_EQ(program.moves[3].feed, 0);
}

TEST(GCode, LeavesMovesOfNoLengthOut) {
  EXPECT_THAT(from_origin("G1 X0 Y0\nG1\nG91 G0 Z0").moves, IsEmpty());
}

TEST(GCode, RefusesAxesWithoutAMotion) {
  EXPECT_THAT(error_of("G90\nX1", 2), HasSubstr("no motion code"));
  EXPECT_THAT(error_of("F1 G81 X1 Z-1 R1\nG80\nX1", 3), HasSubstr("no motion code"));
}

TEST(GCode, CountsFromThePresentPlaceInG91) {
  expect_at(last(from_origin("G91 G1 X1\nX1 Y2\nG90 Z3\nG91 X1 Z-1")), 3, 2, 2);
}

TEST(GCode, ReadsInchesInG20WithFeedsOfTheSameLine) {
  const GCodeProgram program = from_origin("G20 G1 X1 F10\nG21 Y1\nF10 Y2");
  expect_at(program.moves[0], 25.4, 0, 0);
  EXPECT_DOUBLE_EQ(program.moves[0].feed, 254);
  expect_at(program.moves[1], 25.4, 1, 0);
  EXPECT_DOUBLE_EQ(program.moves[1].feed, 254) << "the feed itself does not change with the units";
  EXPECT_DOUBLE_EQ(program.moves[2].feed, 10);
  EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("2 F counts in the units of its own line")));
}

TEST(GCode, RefusesTwoCodesOfOneGroup) {
  for (const char* line :
       {"G0 G1 X1", "G17 G18", "G90 G91", "G20 G21", "G93 G94", "G54 G55", "G4 P1 G28", "M3 M5",
        "M2 M30", "G98 G99", "G90.1 G91.1", "G40 G41", "G1 G81"})
    EXPECT_THAT(error_of(std::string("F1\n") + line, 2), HasSubstr("exclude each other")) << line;
}

TEST(GCode, AcceptsWhatChangesNoPath) {
  const GCodeProgram program = from_origin(
      "G0 G17 G21 G40 G49 G54 G80 G90 G94 G98\nG64 P0.01\nG61\nG61.1\nG64\nG43 H1 D1\nG99\nG97 "
      "S1000 M3\nM7\nM8\nM9\nM48\nM49\nM0\nM1\nG50\nG69\nG15\nG92.1\nG1 X1\nM5\nM2");
  EXPECT_THAT(program.notes, IsEmpty());
  EXPECT_EQ(program.moves.size(), 1u);
}

TEST(GCode, KnowsToolAndSpindleOfEachMove) {
  const GCodeProgram program = from_origin(
      "G0 X1\nT1\nX2\nM6\nX3 S500\nX4 M3\nT2 M6 X5\nM6 T3 S700 X6\nX7 M5\nX8 M4\nG96 S50 X9\n"
      "G97 X10\nS30 X11\n");
  EXPECT_THAT(program.tools, ElementsAre(0, 0, 1, 1, 2, 3, 3, 3, 3, 3, 3));
  EXPECT_THAT(program.spindle_speeds, ElementsAre(0, 0, 0, 500, 500, 700, 0, 700, 0, 0, 30));
  EXPECT_THAT(notes_of(program),
              ElementsAre(HasSubstr("11 M4 turns"), HasSubstr("12 G96 is not simulated")));
  EXPECT_THAT(from_origin("S900 M3\nG97\nG0 X1").spindle_speeds, ElementsAre(900));
  EXPECT_THAT(error_of("T1.5", 1), HasSubstr("no tool number"));
  EXPECT_THAT(error_of("S-1", 1), HasSubstr("below zero"));
}

TEST(GCode, AddsDwellsUp) {
  EXPECT_DOUBLE_EQ(from_origin("G4 P1.5\nG4 X2\nG0 G4 P0.25\n").dwell_s, 3.75);
  EXPECT_THAT(from_origin("G1 X1\nG4 X2").moves.size(), 1u);
  EXPECT_THAT(error_of("G4", 1), HasSubstr("needs P"));
  EXPECT_THAT(error_of("G4 P-1", 1), HasSubstr("below zero"));
}

// ---- feeds ----

TEST(GCode, RefusesFeedMovesWithoutAFeed) {
  EXPECT_THAT(error_of("G0 X1\nG1 X2", 2), HasSubstr("has no feed"));
  EXPECT_THAT(error_of("F0\nG1 X2", 2), HasSubstr("has no feed"));
  EXPECT_THAT(error_of("G2 X2 I1", 1), HasSubstr("has no feed"));
  EXPECT_THAT(error_of("F100\nG95 S10\nG1 X1", 3), HasSubstr("has no feed")) << "F was mm/rev";
  EXPECT_THAT(error_of("G1 F-5 X1", 1), HasSubstr("below zero"));
}

TEST(GCode, TakesTheFeedAsOneOverTheMinutesOfTheMoveInG93) {
  const GCodeProgram program =
      from_origin("G93\nG1 X3 Y4 F2\nG2 X13 I5 Z3 F4\nG0 Z9\nG94 F7 G1 X0");
  EXPECT_DOUBLE_EQ(program.moves[0].feed, 10);
  const double half_turn_rising = std::hypot(kPi * 5, 3 - 0);
  EXPECT_NEAR(program.moves[1].feed, 4 * half_turn_rising, 1e-9);
  EXPECT_DOUBLE_EQ(last(program).feed, 7);
  EXPECT_THAT(error_of("G93 G1 X1 F2\nX2", 2), HasSubstr("its own F"));
  EXPECT_THAT(error_of("F5 G93\nG1 X1", 2), HasSubstr("its own F"));
  EXPECT_THAT(error_of("G93 F5\nG94 G1 X1", 2), HasSubstr("has no feed"));
}

TEST(GCode, MultipliesTheFeedByTheSpindleSpeedInG95) {
  const GCodeProgram program = from_origin("G95 F0.1 S1000 M3\nG1 X1\nS2000\nX2\nG20 F0.1 X3");
  EXPECT_DOUBLE_EQ(program.moves[0].feed, 100);
  EXPECT_DOUBLE_EQ(program.moves[1].feed, 200);
  EXPECT_DOUBLE_EQ(program.moves[2].feed, 5080);
  EXPECT_THAT(error_of("G95 F0.1 G1 X1", 1), HasSubstr("spindle speed"));
}

// ---- arcs ----

TEST(GCodeArcs, TurnTheWayOfTheirCode) {
  const GCodeProgram left = from_origin("G3 X5 Y5 J5");
  ASSERT_EQ(left.moves.size(), 1u);
  EXPECT_NEAR(left.moves[0].sweep, kPi / 2, 1e-12);
  EXPECT_NEAR(left.moves[0].cx, 0, 1e-12);
  EXPECT_NEAR(left.moves[0].cy, 5, 1e-12);
  const GCodeProgram right = from_origin("G2 X5 Y5 J5");
  ASSERT_EQ(right.moves.size(), 2u) << "three quarters of a turn are split";
  EXPECT_THAT(right.lines, ElementsAre(2, 2));
  EXPECT_NEAR(right.moves[0].sweep + right.moves[1].sweep, -1.5 * kPi, 1e-12);
  expect_at(last(right), 5, 5, 0);
}

TEST(GCodeArcs, WithTheirCentreGivenAbsolutelyAreTheSame) {
  const GCodeProgram relative = from_origin("G1 X10 Y20\nG3 X20 Y30 I0 J10");
  const GCodeProgram absolute = from_origin("G1 X10 Y20\nG90.1\nG3 X20 Y30 I10 J30");
  expect_at(last(absolute), 20, 30, 0);
  EXPECT_NEAR(last(absolute).cx, last(relative).cx, 1e-12);
  EXPECT_NEAR(last(absolute).cy, last(relative).cy, 1e-12);
  EXPECT_EQ(last(from_origin("G90.1\nG91.1 G3 X5 Y5 J5")).cy, last(from_origin("G3 X5 Y5 J5")).cy);
  EXPECT_THAT(error_of("F1 G90.1 G3 X5 Y5 J5", 1), HasSubstr("both I and J"));
}

TEST(GCodeArcs, OfARadiusGoTheShortWayOrWithAMinusTheLong) {
  const Move near = last(from_origin("G3 X10 Y10 R10"));
  EXPECT_NEAR(near.sweep, kPi / 2, 1e-12);
  EXPECT_NEAR(near.cx, 0, 1e-9);
  EXPECT_NEAR(near.cy, 10, 1e-9);
  const GCodeProgram far = from_origin("G3 X10 Y10 R-10");
  ASSERT_EQ(far.moves.size(), 2u);
  EXPECT_NEAR(far.moves[0].sweep + far.moves[1].sweep, 1.5 * kPi, 1e-12);
  EXPECT_NEAR(far.moves[0].cx, 10, 1e-9);
  EXPECT_NEAR(far.moves[0].cy, 0, 1e-9);
  const Move right = last(from_origin("G2 X10 Y10 R10"));
  EXPECT_NEAR(right.sweep, -kPi / 2, 1e-12);
  EXPECT_NEAR(right.cx, 10, 1e-9);
}

TEST(GCodeArcs, OfARadiusAHairBelowHalfTheChordAreHalfTurns) {
  const Move move = last(from_origin("G2 X10.001 R5"));
  EXPECT_NEAR(std::abs(move.sweep), kPi, 1e-9);
  EXPECT_NEAR(move.cx, 5.0005, 1e-9);
  EXPECT_THAT(error_of("F1 G2 X10.02 R5", 1), HasSubstr("apart, too far for R"));
}

TEST(GCodeArcs, ThatEndWhereTheyStartAreFullTurns) {
  for (const char* line : {"G2 I5", "G2 X0 Y0 I5", "G91 G2 X0 I5"}) {
    const GCodeProgram program = from_origin(line);
    ASSERT_EQ(program.moves.size(), 2u) << line;
    for (const Move& move : program.moves) {
      EXPECT_NEAR(move.sweep, -kPi, 1e-12);
      EXPECT_NEAR(move.cx, 5, 1e-12);
      EXPECT_NEAR(move.cy, 0, 1e-12);
    }
    expect_at(program.moves[0], 10, 0, 0);
    expect_at(program.moves[1], 0, 0, 0);
  }
  EXPECT_THAT(error_of("F1 G2 X0 Y0 R5", 1), HasSubstr("no centre by R"));
}

TEST(GCodeArcs, ThatAlmostEndWhereTheyStartKeepTheirSize) {
  // The end is a last digit behind the start, and off the circle by one: the turn stays one of 10
  // mm.
  for (const char* end : {"X0.001 Y0.001", "X-0.001 Y0.001", "X0.003 Y0.001", "Y0.001"}) {
    const GCodeProgram program = from_origin(std::string("G3 I10 ") + end);
    ASSERT_EQ(program.moves.size(), 2u) << end;
    EXPECT_NEAR(program.moves[0].sweep + program.moves[1].sweep, 2 * kPi, 2e-4) << end;
    for (const Move& move : program.moves) {
      EXPECT_NEAR(std::hypot(move.x - move.cx, move.y - move.cy), 10, 0.003) << end;
      EXPECT_NEAR(move.cx, 10, 0.003) << end;
      EXPECT_NEAR(move.cy, 0, 0.003) << end;
    }
  }
  // A last digit ahead of it, they are short.
  const GCodeProgram ahead = from_origin("G3 I10 X0.001 Y-0.001");
  ASSERT_EQ(ahead.moves.size(), 1u);
  EXPECT_NEAR(ahead.moves[0].sweep, 1e-4, 1e-6);
}

TEST(GCodeArcs, MayTurnManyTimesAndRise) {
  const GCodeProgram program = from_origin("G3 X10 Y0 I5 Z-5 P3");
  ASSERT_EQ(program.moves.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(program.moves[i].sweep, kPi, 1e-12);
    expect_at(program.moves[i], i % 2 == 0 ? 10 : 0, 0, -1 - i);
  }
  EXPECT_EQ(from_origin("G3 I5 Z-5 P2").moves.size(), 4u);
  for (const char* word : {"P0", "P1.5", "P-1", "P100000"})
    EXPECT_THAT(error_of(std::string("F1 G3 I5 ") + word, 1), HasSubstr("whole number")) << word;
}

TEST(GCodeArcs, OfRoundedCentresEndExactlyAndAreArcs) {
  const GCodeProgram program = from_origin("G1 X1.234\nG2 X8.305 Y7.072 I7.0705 J0.0004");
  const Move& from = program.moves[0];
  const Move& to = program.moves[1];
  expect_at(to, 8.305, 7.072, 0);
  EXPECT_NEAR(std::hypot(from.x - to.cx, from.y - to.cy), std::hypot(to.x - to.cx, to.y - to.cy),
              1e-9);
  EXPECT_NEAR(to.cx, 8.3045, 0.002);
  EXPECT_NEAR(to.cy, 0.0004, 0.002);
}

TEST(GCodeArcs, OfInconsistentRadiiAreRefused) {
  EXPECT_THAT(error_of("F1\nG2 X10 Y0 I4.9", 2), HasSubstr("but 5.1000 mm from its end"));
  EXPECT_NO_THROW(from_origin("G2 X10.004 Y0 I5"));
  EXPECT_NO_THROW(from_origin("G2 X200.1 Y0 I100")) << "0.1 % of the radius";
  EXPECT_THAT(error_of("F1 G2 X200.3 Y0 I100", 1), HasSubstr("check I, J, K"));
  EXPECT_THAT(error_of("F1 G2 X4000.6 Y0 I2000", 1), HasSubstr("check I, J, K"))
      << "never more than half a millimetre";
}

TEST(GCodeArcs, WithoutRadiusOrWordsAreRefused) {
  EXPECT_THAT(error_of("F1 G2 X1 I0 J0", 1), HasSubstr("radius is zero"));
  EXPECT_THAT(error_of("F1 G2 X1 R0", 1), HasSubstr("radius is zero"));
  EXPECT_THAT(error_of("F1 G2 X1", 1), HasSubstr("neither I and J nor R"));
  EXPECT_THAT(error_of("F1 G2 X1 K1", 1), HasSubstr("neither I and J nor R"));
  EXPECT_THAT(error_of("F1 G18 G2 X1 J1", 1), HasSubstr("neither K and I nor R"));
  EXPECT_THAT(error_of("F1 G2", 1), HasSubstr("has no words"));
  EXPECT_THAT(error_of("F1 G2 X2 I1\nX4", 2), HasSubstr("neither I and J nor R"));
  EXPECT_THAT(error_of("F1 G2 X2 I1 R1", 1), HasSubstr("take one of them out"));
}

TEST(GCodeArcs, MayHaveAThirdCentreWordOfZero) {
  EXPECT_THAT(from_origin("G2 X10 I5 J0 K0").notes, IsEmpty());
  EXPECT_THAT(notes_of(from_origin("G2 X10 I5 J0 K1")), ElementsAre("2 'K1' is not simulated."));
}

// The moves of an arc in G18 or G19 as points, the start among them.
struct Point {
  double x, y, z;
};
std::vector<Point> points(const GCodeProgram& program) {
  std::vector<Point> result{{program.start_x, program.start_y, program.start_z}};
  for (const Move& move : program.moves) {
    EXPECT_EQ(move.sweep, 0);
    result.push_back({move.x, move.y, move.z});
  }
  return result;
}

TEST(GCodeArcs, InG18AreLinesWithinTheTolerance) {
  // Seen from the tip of Y, counter-clockwise is from Z to X: from the circle's top to its side at
  // +x.
  for (const double tolerance : {0.1, 0.001}) {
    GCodeOptions options;
    options.start = {{0, 3, 0}};
    options.arc_tolerance = tolerance;
    const std::vector<Point> path = points(read_gcode("F9 G18 G3 X10 Z-10 Y5 K-10", options));
    double deepest = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_NEAR(std::hypot(path[i].x, path[i].z + 10), 10, 1e-9);
      EXPECT_GT(path[i].x, path[i - 1].x);
      const double middle =
          std::hypot((path[i].x + path[i - 1].x) / 2, (path[i].z + path[i - 1].z) / 2 + 10);
      deepest = std::max(deepest, 10 - middle);
      const double share = std::atan2(path[i].x, path[i].z + 10) / (kPi / 2);
      EXPECT_NEAR(path[i].y, 3 + 2 * share, 1e-9) << "the third axis goes along evenly";
    }
    EXPECT_LE(deepest, tolerance * 1.0001);
    EXPECT_GT(deepest, tolerance / 4) << "no more lines than needed";
  }
}

TEST(GCodeArcs, InG19TurnFromYToZ) {
  const std::vector<Point> path = points(from_origin("G19 G3 Y10 Z10 K10"));
  for (const Point& p : path) {
    EXPECT_NEAR(std::hypot(p.y, p.z - 10), 10, 1e-9);
    EXPECT_LE(p.z, 10 + 1e-9);
    EXPECT_EQ(p.x, 0);
  }
  EXPECT_EQ(path.back().y, 10);
  const std::vector<Point> radius = points(from_origin("G19 G3 Y10 Z10 R10"));
  ASSERT_EQ(radius.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) EXPECT_NEAR(radius[i].z, path[i].z, 1e-9);
}

TEST(GCodeArcs, OfUnreasonablyManyLinesAreRefused) {
  EXPECT_THAT(error_of("F1 G18 G2 X0 Z0 I900000000 P1000", 1), HasSubstr("a million lines"));
}

// ---- places that are unknown ----

TEST(GCodePlaces, BeginWhereXYAndZAreAllKnown) {
  const GCodeProgram program = read_gcode("G21 G0 Z5\nG0 X1 Y2\nG0 X3\n");
  EXPECT_TRUE(program.has_start);
  EXPECT_EQ(program.start_x, 1);
  EXPECT_EQ(program.start_y, 2);
  EXPECT_EQ(program.start_z, 5);
  EXPECT_THAT(program.lines, ElementsAre(3));
  EXPECT_THAT(program.notes, IsEmpty());
  EXPECT_FALSE(read_gcode("G0 X1 Y1\n").has_start);
  EXPECT_FALSE(read_gcode("").has_start);
}

TEST(GCodePlaces, MayBeGivenBeforeTheProgram) {
  GCodeOptions options;
  options.start = {{1, 2, 3}};
  const GCodeProgram program = read_gcode("G91 G1 X1 F5", options);
  EXPECT_EQ(program.start_z, 3);
  expect_at(last(program), 2, 2, 3);
}

TEST(GCodePlaces, ThatAreUnknownMakeFeedMovesNotes) {
  const GCodeProgram program = read_gcode("G21 F9\nG1 X1 Y1\nG1 X2\nG1 Z1\nG1 X3\n");
  EXPECT_THAT(program.lines, ElementsAre(5));
  EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("2 Feed moves from here on are not")));
  EXPECT_EQ(read_gcode("G21 F9\nG1 X1 Y1\nG1 Z1\nG53 G0 Z0\nG1 X2\nX3\n").notes.size(), 3u)
      << "one for each stretch, and G53";
  const GCodeProgram relative = read_gcode("G21 G91 F9\nG1 X1 Y1 Z1\nX1\n");
  EXPECT_FALSE(relative.has_start);
  EXPECT_EQ(relative.notes.size(), 1u);
  EXPECT_THROW(read_gcode("F9 G0 X1\nG2 X5 Y5 I1"), GCodeError);
}

TEST(GCodePlaces, AreLostByG28AndFoundAgainOverTheGreatestHeight) {
  const GCodeProgram program = read_gcode(
      "G21 F9 G0 X0 Y0 Z20\nZ5\nG1 Z-2\nX10\nG91 G28 Z0\nG90 G0 X50 Y60\nZ4\nG1 Z-3\nG28\n");
  const std::vector<Move>& m = program.moves;
  ASSERT_EQ(m.size(), 7u);
  EXPECT_THAT(program.lines, ElementsAre(2, 3, 4, 7, 7, 7, 8));
  for (int i : {3, 4, 5}) EXPECT_EQ(m[i].kind, MoveKind::kRapid);
  expect_at(m[3], 10, 0, 20);
  expect_at(m[4], 50, 60, 20);
  expect_at(m[5], 50, 60, 4);
  EXPECT_THAT(
      notes_of(program),
      ElementsAre(HasSubstr("5 G28 goes to a place of the machine's, which the program does "
                            "not tell: Z is unknown"),
                  HasSubstr("X, Y, Z is unknown")));
}

TEST(GCodePlaces, AreReachedOverThePointThatG28Names) {
  const GCodeProgram program = from_origin("G0 X1 Y1 Z1\nG28 Z-7\n");
  ASSERT_EQ(program.moves.size(), 2u);
  expect_at(last(program), 1, 1, -7);
  EXPECT_EQ(last(program).kind, MoveKind::kRapid);
}

TEST(GCodePlaces, AreLostByG53) {
  const GCodeProgram program = from_origin("G0 Z3\nG0 G53 Z0\nX5\nG53 G0 X0 Y0\nX1 Y1 Z2\n");
  ASSERT_EQ(program.moves.size(), 3u);
  expect_at(program.moves[1], 1, 1, 3);
  expect_at(program.moves[2], 1, 1, 2);
  EXPECT_EQ(program.notes.size(), 2u);
  EXPECT_THAT(error_of("F1 G2 I5\nG53 X1", 2), HasSubstr("G53 goes with"));
}

TEST(GCodePlaces, OfAFeedMoveFromTheUnknownAreReachedByFeed) {
  const GCodeProgram program = from_origin("G0 Z9\nG0 G53 Z0\nG1 X5 Z-3\n");
  ASSERT_EQ(program.moves.size(), 3u);
  expect_at(program.moves[1], 5, 0, 9);
  EXPECT_EQ(program.moves[2].kind, MoveKind::kCut);
  EXPECT_THAT(notes_of(program).back(), HasSubstr("its start is unknown"));
}

TEST(GCodePlaces, AreInDoubtAfterShiftsAndOtherWorkCoordinates) {
  const GCodeProgram program = from_origin(
      "G54 G0 X1\nG55 X2\nG54.1 P3\nG92 X0\nG10 L2 P1 X5 Y6\nG52 X1 Y1\nG68 X0 Y0 R45\nX3\n");
  EXPECT_EQ(program.moves.size(), 3u);
  expect_at(last(program), 3, 0, 0);
  EXPECT_THAT(
      notes_of(program),
      ElementsAre(HasSubstr("3 G55 changes the work"), HasSubstr("4 G54.1 changes the work"),
                  HasSubstr("5 'G92 X0' shifts"), HasSubstr("6 'G10 L2 P1 X5 Y6' shifts"),
                  HasSubstr("7 'G52 X1 Y1' shifts"), "8 'G68 X0 Y0 R45' is not simulated."));
  EXPECT_THAT(read_gcode("G21 G55\nG0 X1 Y1 Z1\nG55\nX2").notes, IsEmpty()) << "one system only";
}

TEST(GCodePlaces, ThatWereUnknownAreToldByG92) {
  const GCodeProgram program = read_gcode("G92 X1 Y2 Z3\nG91 G0 X1");
  EXPECT_EQ(program.start_y, 2);
  expect_at(last(program), 2, 2, 3);
}

TEST(GCodePlaces, AreLostByMotionsThatAreNotSimulated) {
  const GCodeProgram program = from_origin("G0 X1\nG38.2 Z-5 F10\nZ-6\nG0 X2\nG0 Z1\n");
  EXPECT_THAT(notes_of(program),
              ElementsAre(HasSubstr("3 'G38.2 Z-5' is not simulated, and the place"),
                          HasSubstr("4 'Z-6' goes with the motion of a line before")));
  expect_at(last(program), 2, 0, 1);
}

TEST(GCode, NotesCompensationAndGoesTheProgrammedPath) {
  const GCodeProgram program = from_origin("G41 D1 G1 X1\nG40 X2");
  EXPECT_EQ(program.moves.size(), 2u);
  EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("2 G41 is not simulated")));
}

// ---- cycles ----

// kind, x, z of each move in letters: "R5,2" a rapid to x = 5 and z = 2.
std::vector<std::string> strokes(const GCodeProgram& program) {
  std::vector<std::string> result;
  for (const Move& move : program.moves) {
    char text[60];
    std::snprintf(text, sizeof text, "%c%g,%g", move.kind == MoveKind::kRapid ? 'R' : 'F', move.x,
                  move.z);
    result.emplace_back(text);
  }
  return result;
}

TEST(GCodeCycles, DrillEachPlaceAndReturnToWhereTheyBegan) {
  EXPECT_THAT(strokes(from_origin("G0 Z10\nG81 X1 Z-5 R2 F50\nX3\nG80\nG0 X4")),
              ElementsAre("R0,10", "R1,10", "R1,2", "F1,-5", "R1,10", "R3,10", "R3,2", "F3,-5",
                          "R3,10", "R4,10"));
}

TEST(GCodeCycles, ReturnToTheRetractPlaneInG99) {
  EXPECT_THAT(strokes(from_origin("G0 Z10\nG99 G81 X1 Z-5 R2\nX3\nG98 X5\n")),
              ElementsAre("R0,10", "R1,10", "R1,2", "F1,-5", "R1,2", "R3,2", "F3,-5", "R3,2",
                          "R5,2", "F5,-5", "R5,10"));
}

TEST(GCodeCycles, KeepTheirWordsAndTheHeightTheyBeganAtWhenTheCodeChanges) {
  EXPECT_THAT(strokes(from_origin("G0 Z10\nG99 G81 X1 Z-5 R2\nG98 G82 X3 P1\n")),
              ElementsAre("R0,10", "R1,10", "R1,2", "F1,-5", "R1,2", "R3,2", "F3,-5", "R3,10"));
  EXPECT_THAT(error_of("F1 G81 X1 Z-5 R2\nG80\nG81 X2", 3), HasSubstr("needs R and Z"));
}

TEST(GCodeCycles, RiseToTheRetractPlaneBeforeTheyGoAcross) {
  EXPECT_THAT(strokes(from_origin("G81 X1 Z-5 R2")), ElementsAre("R0,2", "R1,2", "F1,-5", "R1,2"));
}

TEST(GCodeCycles, CountRAndZAndRepeatsInG91) {
  EXPECT_THAT(
      strokes(from_origin("G0 Z10\nG91 G81 X2 Z-3 R-8 L2\n")),
      ElementsAre("R0,10", "R2,10", "R2,2", "F2,-1", "R2,10", "R4,10", "R4,2", "F4,-1", "R4,10"));
  EXPECT_EQ(from_origin("G0 Z10\nG81 X2 Z-3 R1 L0\n").moves.size(), 1u) << "L0 only tells";
}

TEST(GCodeCycles, PeckInG83AndBreakChipsInG73) {
  EXPECT_THAT(strokes(from_origin("G0 Z2\nG83 X1 Z-2 R1 Q1.5")),
              ElementsAre("R0,2", "R1,2", "R1,1", "F1,-0.5", "R1,1", "R1,-0.246", "F1,-2", "R1,2"));
  EXPECT_THAT(strokes(from_origin("G0 Z2\nG73 X1 Z-2 R1 Q1.5")),
              ElementsAre("R0,2", "R1,2", "R1,1", "F1,-0.5", "R1,-0.246", "F1,-2", "R1,2"));
  EXPECT_THAT(notes_of(from_origin("G83 X1 Z-2 R1")), ElementsAre(HasSubstr("without Q")));
  EXPECT_THAT(error_of("F1 G83 X1 Z-2 R1 Q0", 1), HasSubstr("no depth above zero"));
  EXPECT_THAT(error_of("F1 G83 X1 Z-2 R1 Q0.00001", 1), HasSubstr("pecks"));
}

TEST(GCodeCycles, DwellInG82AtEachHole) {
  EXPECT_DOUBLE_EQ(from_origin("G82 X1 Z-2 R1 P0.5\nX2\nX3").dwell_s, 1.5);
}

TEST(GCodeCycles, ReadInchesAndFeedsOfTheLine) {
  const GCodeProgram program = from_origin("G20\nG81 X1 Z-1 R0.1 F2");
  expect_at(program.moves[2], 25.4, 0, -25.4);
  EXPECT_DOUBLE_EQ(program.moves[2].feed, 50.8);
}

TEST(GCodeCycles, ThatCannotBeMadeAreRefused) {
  EXPECT_THAT(error_of("F1 G81 X1 Z-1", 1), HasSubstr("needs R and Z"));
  EXPECT_THAT(error_of("F1 G81 X1 R1", 1), HasSubstr("needs R and Z"));
  EXPECT_THAT(error_of("F1 G81 X1 R1 Z2", 1), HasSubstr("above its retract plane"));
  EXPECT_THAT(error_of("G81 X1 R1 Z0", 1), HasSubstr("has no feed"));
  EXPECT_THAT(error_of("F1 G18 G81 X1 R1 Z0", 1), HasSubstr("G17 only"));
  EXPECT_THAT(error_of("G93 G81 X1 R1 Z0 F1", 1), HasSubstr("G93"));
  EXPECT_THAT(error_of("F1 G81 X1 R1 Z0 L2000", 1), HasSubstr("whole number"));
}

TEST(GCodeCycles, TapAndBoreAndComeOutAtTheFeedOrByARapid) {
  for (const char* code : {"G74", "G84", "G85", "G89 P1"}) {
    const GCodeProgram program = from_origin(std::string("G0 Z9\n") + code + " X1 Z-5 R2\nG80");
    EXPECT_THAT(strokes(program), ElementsAre("R0,9", "R1,9", "R1,2", "F1,-5", "F1,2", "R1,9"))
        << code;
    EXPECT_THAT(program.notes, IsEmpty()) << code;
  }
  for (const char* code : {"G76 Q0.2", "G76 I0.2 J0", "G86 P1", "G88 P1"}) {
    const GCodeProgram program = from_origin(std::string("G0 Z9\n") + code + " X1 Z-5 R2\nG80");
    EXPECT_THAT(strokes(program), ElementsAre("R0,9", "R1,9", "R1,2", "F1,-5", "R1,9")) << code;
    EXPECT_THAT(program.notes, IsEmpty()) << code;
  }
}

TEST(GCodeCycles, HoldForTheLinesAfterThem) {
  EXPECT_THAT(strokes(from_origin("G0 Z9\nG99 G76 X1 Z-5 R2 Q0.2\nX2")),
              ElementsAre("R0,9", "R1,9", "R1,2", "F1,-5", "R1,2", "R2,2", "F2,-5", "R2,2"));
}

TEST(GCodeCycles, OfBackBoringAreNotedAndStayAbove) {
  const GCodeProgram program = from_origin("G0 Z9\nG99 G87 X1 Z-5 R-8 Q0.5\nX2\nG80");
  EXPECT_THAT(strokes(program), ElementsAre("R0,9", "R1,9", "R2,9")) << "rapids only";
  EXPECT_THAT(notes_of(program),
              ElementsAre(HasSubstr("3 G87 bores from below"), HasSubstr("4 G87 bores")));
}

TEST(GCodeCycles, AreNoThreads) {
  const GCodeProgram program = from_origin("G0 Z9\nG76 P1 Z-5 I-1 J0.2 K1\nX2");
  EXPECT_THAT(strokes(program), ElementsAre("R0,9")) << "where it is afterwards is unknown";
  EXPECT_THAT(notes_of(program), ElementsAre(HasSubstr("3 'G76"), HasSubstr("4 'X2'")));
}

// ---- units ----

TEST(GCodeUnits, ThatTheProgramDoesNotNameAreNotedOnceWhereItMoves) {
  GCodeOptions options;
  options.start = {{0, 0, 0}};
  const auto notes = [&](const std::string& text) { return notes_of(read_gcode(text, options)); };
  EXPECT_THAT(notes("G90\nG0 X1\nX2"), ElementsAre(HasSubstr("2 The program moves before")));
  EXPECT_THAT(notes("G0 X1\nG20\nX2"), ElementsAre(HasSubstr("1 The program moves before")));
  EXPECT_THAT(notes("G20 G0 X1"), IsEmpty());
  EXPECT_THAT(notes("G21\nG0 X1"), IsEmpty());
  EXPECT_THAT(notes("M3 S1000\nG4 P1"), IsEmpty()) << "it does not move";
}

}  // namespace
}  // namespace evenload
