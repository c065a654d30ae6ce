// The G-code reader on whole programs: of posts, of chance, and of no sense.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "toolpath/gcode.h"

namespace evenload {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Move start_of(const GCodeProgram& program) {
  Move start;
  start.x = program.start_x;
  start.y = program.start_y;
  start.z = program.start_z;
  return start;
}

// The laws of gcode.h.
void expect_lawful(const GCodeProgram& program) {
  const std::size_t n = program.moves.size();
  ASSERT_EQ(program.lines.size(), n);
  ASSERT_EQ(program.tools.size(), n);
  ASSERT_EQ(program.spindle_speeds.size(), n);
  ASSERT_TRUE(program.has_start || n == 0);
  Move from = start_of(program);
  for (std::size_t i = 0; i < n; ++i) {
    const Move& to = program.moves[i];
    for (const double value : {to.x, to.y, to.z, to.sweep, to.cx, to.cy, to.feed})
      ASSERT_TRUE(std::isfinite(value));
    ASSERT_TRUE(to.x != from.x || to.y != from.y || to.z != from.z || to.sweep != 0);
    if (to.kind == MoveKind::kRapid) {
      ASSERT_EQ(to.feed, 0);
    } else {
      ASSERT_EQ(to.kind, MoveKind::kCut);
      ASSERT_GT(to.feed, 0);
    }
    ASSERT_LE(program.lines[i > 0 ? i - 1 : 0], program.lines[i]);
    if (to.sweep != 0) {
      ASSERT_LE(std::abs(to.sweep), kPi * (1 + 1e-8));
      const Vec2 centre{to.cx, to.cy}, a = Vec2{from.x, from.y} - centre,
                                       b = Vec2{to.x, to.y} - centre;
      // Doubles of the size of the centre's numbers cannot tell more.
      const double slack =
          std::max(1e-9, 4e-16 * (norm(a) + norm(centre)) + 1e-15 * norm(Vec2{to.x, to.y}));
      ASSERT_NEAR(norm(a), norm(b), slack);
      ASSERT_LE(distance(rotated(a, to.sweep), b), 4 * slack);
    }
    from = to;
  }
}

std::string number(double value, int decimals) {
  char text[60];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

// ---- programs of chance ----

struct Step {
  bool rapid = false;
  Vec2 by;           // mm
  double rise = 0;   // mm
  double sweep = 0;  // rad, 0: a line
  Vec2 centre;       // from the start
  double feed = 0;   // mm/min
};

std::vector<Step> random_steps(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> unit_range(0, 1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * unit_range(random);
  };
  std::vector<Step> steps;
  for (int i = 0; i < n; ++i) {
    Step step;
    step.feed = between(50, 2000);
    step.rise = unit_range(random) < 0.5 ? 0 : between(-3, 3);
    const double choice = unit_range(random);
    if (choice < 0.5) {
      step.rapid = choice < 0.2;
      step.by = {between(-30, 30), between(-30, 30)};
    } else {
      // R tells short and long arcs apart: not half turns.
      const double size = choice < 0.75 ? between(0.1, 2.9) : between(3.4, 6.1);
      step.sweep = unit_range(random) < 0.5 ? -size : size;
      step.centre = between(0.5, 40) * unit(between(0, 2 * kPi));
      step.by = step.centre + rotated(-step.centre, step.sweep);
    }
    steps.push_back(step);
  }
  return steps;
}

struct Manner {
  bool relative = false, inch = false, radius = false, absolute_centre = false, inverse = false;
  bool terse = false;  // without spaces, in small letters, modal words left out
};

std::string program_of(const std::vector<Step>& steps, const Manner& manner) {
  const double unit_mm = manner.inch ? 25.4 : 1;
  std::string text = std::string(manner.inch ? "G20" : "G21") +
                     (manner.absolute_centre ? " G90.1" : " G91.1") + "\nG90 G0 X0 Y0 Z0\n" +
                     (manner.relative ? "G91 " : "G90 ") + (manner.inverse ? "G93\n" : "G94\n");
  const auto word = [&](char letter, double mm) {
    return std::string(" ") + letter + number(mm / unit_mm, 11);
  };
  Vec2 at;
  double z = 0;
  int motion = -1;
  for (const Step& step : steps) {
    const int code = step.rapid ? 0 : step.sweep == 0 ? 1 : step.sweep < 0 ? 2 : 3;
    const Vec2 from = at;
    at += step.by;
    z += step.rise;
    if (!manner.terse || code != motion) text += "G" + std::to_string(code);
    motion = code;
    text += manner.relative ? word('X', step.by.x) + word('Y', step.by.y)
                            : word('X', at.x) + word('Y', at.y);
    if (!manner.terse || step.rise != 0) text += word('Z', manner.relative ? step.rise : z);
    double length = std::hypot(norm(step.by), step.rise);
    if (step.sweep != 0) {
      const double r = norm(step.centre);
      length = std::hypot(r * step.sweep, step.rise);
      const Vec2 centre = manner.absolute_centre ? from + step.centre : step.centre;
      text += manner.radius ? word('R', std::abs(step.sweep) < kPi ? r : -r)
                            : word('I', centre.x) + word('J', centre.y);
    }
    if (!step.rapid)
      text += manner.inverse ? " F" + number(step.feed / length, 12) : word('F', step.feed);
    text += "\n";
  }
  if (manner.terse) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  }
  return text;
}

TEST(GCodeLaws, ProgramsInAnyMannerGiveTheSameMoves) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    const std::vector<Step> steps = random_steps(random, 40);
    const GCodeProgram plain = read_gcode(program_of(steps, {}));
    EXPECT_THAT(plain.notes, IsEmpty());
    expect_lawful(plain);
    for (int bits = 1; bits < 64; ++bits) {
      const Manner manner{(bits & 1) != 0, (bits & 2) != 0,  (bits & 4) != 0,
                          (bits & 8) != 0, (bits & 16) != 0, (bits & 32) != 0};
      const GCodeProgram other = read_gcode(program_of(steps, manner));
      EXPECT_THAT(other.notes, IsEmpty());
      ASSERT_EQ(other.moves.size(), plain.moves.size());
      ASSERT_EQ(other.lines, plain.lines);
      for (std::size_t i = 0; i < plain.moves.size(); ++i) {
        const Move &a = plain.moves[i], &b = other.moves[i];
        ASSERT_EQ(a.kind, b.kind);
        ASSERT_NEAR(a.x, b.x, 1e-7);
        ASSERT_NEAR(a.y, b.y, 1e-7);
        ASSERT_NEAR(a.z, b.z, 1e-7);
        ASSERT_NEAR(a.sweep, b.sweep, 1e-6);
        ASSERT_NEAR(a.cx, b.cx, 1e-6);
        ASSERT_NEAR(a.cy, b.cy, 1e-6);
        ASSERT_NEAR(a.feed, b.feed, 1e-5 * (1 + a.feed));
      }
    }
  }
}

TEST(GCodeLaws, MovesFollowTheStepsTheyWereWrittenFrom) {
  std::mt19937 random(11);
  const std::vector<Step> steps = random_steps(random, 300);
  const GCodeProgram program = read_gcode(program_of(steps, {}));
  Vec2 at;
  double z = 0;
  std::size_t i = 0;
  for (const Step& step : steps) {
    const Vec2 centre = at + step.centre;
    const int line = program.lines[i];
    double sweep = 0;
    for (; i < program.moves.size() && program.lines[i] == line; ++i) {
      sweep += program.moves[i].sweep;
      if (step.sweep != 0) {
        EXPECT_NEAR(distance({program.moves[i].cx, program.moves[i].cy}, centre), 0, 1e-7);
      }
    }
    at += step.by;
    z += step.rise;
    EXPECT_NEAR(sweep, step.sweep, 1e-7);
    EXPECT_NEAR(program.moves[i - 1].x, at.x, 1e-9);
    EXPECT_NEAR(program.moves[i - 1].y, at.y, 1e-9);
    EXPECT_NEAR(program.moves[i - 1].z, z, 1e-9);
  }
  EXPECT_EQ(i, program.moves.size());
}

TEST(GCodeLaws, RoundedArcsBecomeTrueArcsBesideTheOnesMeant) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double r = 0.05 * std::pow(4000.0, share(random));  // to 200 mm
    const Vec2 centre{100 * share(random), 100 * share(random)};
    const double from = 2 * kPi * share(random), sweep = 2 * kPi * (2 * share(random) - 1);
    const Vec2 a = centre + r * unit(from), b = centre + r * unit(from + sweep);
    // Ends that round to the same place, or to the wrong order, mean another arc.
    if (distance(a, b) < 0.004) continue;
    const auto rounded = [](double v) { return std::round(v * 1000) / 1000; };
    const Vec2 start{rounded(a.x), rounded(a.y)};
    const GCodeProgram program =
        read_gcode("F1 G0 Z0 X" + number(start.x, 3) + " Y" + number(start.y, 3) + "\n" +
                   (sweep > 0 ? "G3 X" : "G2 X") + number(b.x, 3) + " Y" + number(b.y, 3) + " I" +
                   number(centre.x - start.x, 3) + " J" + number(centre.y - start.y, 3));
    expect_lawful(program);
    double turned = 0;
    Move last = start_of(program);
    for (const Move& move : program.moves) {
      const Vec2 c{move.cx, move.cy};
      const Vec2 arm = Vec2{last.x, last.y} - c;
      for (const double t : {0.25, 0.5, 0.75})
        ASSERT_NEAR(distance(c + rotated(arm, t * move.sweep), centre), r, 0.003);
      turned += move.sweep;
      last = move;
    }
    ASSERT_NEAR(turned, sweep, 0.005 / r);
  }
}

// ---- programs of posts ----

TEST(GCodePosts, OfLinuxCncAreReadWithoutANote) {
  const GCodeProgram program = read_gcode(R"((made for LinuxCNC)
G17 G54 G40 G49 G80 G90
G21
(Begin toolchange: T3)
M5
M6 T3
G43 H3
M3 S6366
G0 Z10.000
G0 X12.700 Y10.000
G0 Z1.500
G3 X7.300 Y10.000 Z1.000 I-2.700 J0.000 K0.000 F255.000
G3 X12.700 Y10.000 Z0.500 I2.700 J0.000
G1 X20 F500
G64 P0.01
G0 Z10.000
M5
M2
)");
  EXPECT_THAT(program.notes, IsEmpty());
  expect_lawful(program);
  EXPECT_EQ(program.start_z, 10);
  ASSERT_EQ(program.moves.size(), 5u);
  EXPECT_EQ(program.tools[0], 3);
  EXPECT_EQ(program.spindle_speeds[4], 6366);
  EXPECT_NEAR(program.moves[1].cx, 10, 1e-9);
}

TEST(GCodePosts, OfGrblAreReadAndTheirSettingsNoted) {
  const GCodeProgram program = read_gcode(
      "$H\nG21G90G94G17\nM3S12000\nG4P2\nG0Z5\nG0X0Y0\nG1Z-1F100\nG1X10F400\nX10Y10\nG2X0Y10R5\n"
      "G1Y0\nG0Z5\nM5\nM30\n");
  ASSERT_EQ(program.notes.size(), 1u);
  EXPECT_EQ(program.notes[0].line, 1);
  expect_lawful(program);
  EXPECT_EQ(program.moves.size(), 6u);
  EXPECT_EQ(program.dwell_s, 2);
  EXPECT_NEAR(program.moves[3].sweep, -kPi, 1e-12);
}

TEST(GCodePosts, OfMachAreReadInInchesWithAbsoluteCentres) {
  const GCodeProgram program = read_gcode(
      "N10 (Mach)\nN20 G00 G20 G17 G90 G40 G49 G80 G90.1\nN30 M6 T1\nN40 G43 H1\nN50 S3000 M03\n"
      "N60 G00 Z0.2000\nN70 X1.0000 Y0.0000\nN80 G01 Z-0.0500 F10.0\n"
      "N90 G03 X0.0000 Y1.0000 I0.0000 J0.0000 F20.0\nN100 G28\nN110 M30\n");
  expect_lawful(program);
  ASSERT_EQ(program.moves.size(), 2u);
  EXPECT_NEAR(program.moves[1].sweep, kPi / 2, 1e-12);
  EXPECT_NEAR(program.moves[1].cx, 0, 1e-9);
  EXPECT_NEAR(program.moves[1].feed, 508, 1e-9);
  ASSERT_EQ(program.notes.size(), 1u);
  EXPECT_EQ(program.notes[0].line, 10);
}

TEST(GCodePosts, OfHaasAreReadOverTheirToolChanges) {
  const GCodeProgram program = read_gcode(R"(%
O01001 (POCKET)
(T1 6MM END MILL)
G00 G17 G21 G40 G49 G80 G90
G28 G91 Z0.
T1 M06
G00 G90 G54 X10. Y-5. S6000 M03
G43 Z25. H01 M08
Z2.
G01 Z-3. F200.
X20. F600.
G02 X30. Y5. R10.
G00 Z25. M09
G28 G91 Z0. M05
M01
T2 M6
G00 G90 G54 X0. Y0. S2000 M03
G43 Z25. H02
G98 G81 Z-5. R2. F120.
X15.
G80
G00 Z25.
G91 G28 Z0.
G28 Y0.
M30
%
)");
  expect_lawful(program);
  EXPECT_EQ(program.start_x, 10);
  EXPECT_EQ(program.start_z, 25);
  EXPECT_EQ(program.tools.front(), 1);
  EXPECT_EQ(program.tools.back(), 2);
  int holes = 0;
  for (const Move& move : program.moves) holes += move.kind == MoveKind::kCut && move.z == -5;
  EXPECT_EQ(holes, 2);
  for (const GCodeNote& note : program.notes) EXPECT_THAT(note.text, HasSubstr("G28 goes to"));
  EXPECT_EQ(program.notes.size(), 4u);
}

// ---- programs of no sense ----

// Whether it was read; nothing but a GCodeError may come out otherwise.
bool reads(const std::string& text, const GCodeOptions& options) {
  try {
    expect_lawful(read_gcode(text, options));
    return true;
  } catch (const GCodeError& error) {
    EXPECT_GE(error.line(), 1);
    return false;
  }
}

TEST(GCodeFuzz, BytesOfChanceAreReadOrRefused) {
  std::mt19937 random(1);
  GCodeOptions options;
  for (int i = 0; i < 3000; ++i) {
    std::string text(random() % 80, ' ');
    for (char& c : text) c = static_cast<char>(random() % 256);
    reads(text, options);
  }
}

TEST(GCodeFuzz, WordsOfChanceAreReadOrRefused) {
  const std::vector<std::string> words = {
      "G0",  "G1",    "G2",         "G3",         "G17", "G18",  "G19", "G20", "G21",  "G28",
      "G30", "G53",   "G54",        "G55",        "G73", "G80",  "G81", "G82", "G83",  "G84",
      "G90", "G91",   "G92",        "G90.1",      "G93", "G94",  "G95", "G98", "G99",  "G4",
      "G10", "G38.2", "G5",         "M3",         "M5",  "M6",   "X1",  "X-2", "Y3",   "Y0",
      "Z1",  "Z-1",   "I1",         "I-2",        "J1",  "J0",   "K1",  "R2",  "R-3",  "P1",
      "P3",  "Q1",    "L2",         "F10",        "F0",  "S100", "T1",  "A5",  "(c)",  ";",
      "\n",  "\n",    "\n",         "\n",         "\n",  "%",    "/",   "$X",  "X1e3", "#1",
      "O5",  "X",     "X999999999", "I999999999", "Y1e", "Z."};
  std::mt19937 random(2);
  int read = 0;
  for (int i = 0; i < 30000; ++i) {
    GCodeOptions options;
    options.arc_tolerance = 0.1;
    if (random() % 2) options.start = {{0, 0, 0}};
    std::string text;
    if (random() % 2) text = "F50 S100 G91\n";
    for (unsigned n = random() % 16; n > 0; --n) {
      text += words[random() % words.size()];
      if (random() % 3 == 0) text += "\n";
    }
    read += reads(text, options);
  }
  EXPECT_GT(read, 3000) << "most are refused, but not nearly all";
  EXPECT_LT(read, 27000);
}

TEST(GCodeFuzz, ProgramsWithChangedBytesAreReadOrRefused) {
  std::mt19937 random(5);
  const std::string program = program_of(random_steps(random, 12), {});
  for (int i = 0; i < 5000; ++i) {
    std::string text = program;
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(32 + random() % 95);
          break;
        case 1:
          text.erase(at, 1 + random() % 5);
          break;
        default:
          text.insert(at, 1, "GXYZIJRFP019.-\n"[random() % 15]);
      }
    }
    reads(text, {});
  }
}

TEST(GCode, RefusesOptionsThatMeanNothing) {
  GCodeOptions options;
  options.arc_tolerance = 0;
  EXPECT_THROW(read_gcode("", options), std::invalid_argument);
  options.arc_tolerance = 0.01;
  options.start = {{0, std::nan(""), 0}};
  EXPECT_THROW(read_gcode("", options), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
