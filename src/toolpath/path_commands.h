// Moves as the G0, G1, G2 and G3 of a program, made so that rounding harms none of them.
//
// Post-processors write three decimals, or four when told to. Ends are rounded here first, to four,
// and the arcs' centres are then chosen for the rounded ends: what is posted with four decimals is
// what was computed, and tangent arcs stay so. With three no arc's two radii disagree by more than
// a controller accepts. Arcs beyond half a turn are cut into pieces, arcs that controllers or
// FreeCAD would take for others become lines, and no command repeats a position.
// Tolerance: kArcSagitta, 0.004 mm, for lines in place of an arc.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

// What is named, in mm and mm/min; I and J relative to the start, as G91.1 has it.
struct PathCommand {
  int code = 0;  // of G0 to G3
  std::optional<double> x, y, z;
  std::optional<double> i, j;
  std::optional<double> feed;
};

struct Position {
  double x = 0, y = 0, z = 0;
};

// `start`: where the tool is; without it anywhere above everything, so that the first rapid rises
// before it travels. Rapids at the path's end that are at `left_out_from` (mm) or above it are left
// out. A descent of less than 0.0005 mm is made by the feed move before. Throws
// std::invalid_argument, with the number of the move, for numbers that are not finite, feeds that
// are not positive, and a cut before the tool's place is known.
std::vector<PathCommand> path_commands(
    const std::vector<Move>& moves, const std::optional<Position>& start,
    double left_out_from = std::numeric_limits<double>::infinity());

// As Python's round: the double next to the decimal next to `value`. `decimals` from 0 to 15.
double rounded(double value, int decimals);

}  // namespace evenload
