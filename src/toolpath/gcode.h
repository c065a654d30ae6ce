// A G-code program read into moves: what LinuxCNC, grbl, Mach and Haas posts write for three axes.
//
// Read are G0 to G3 with all their modes, the cycles G73, G74, G76, G81 to G86, G88 and G89, F, S,
// T and the usual M codes; docs/gcode.md has the whole list. A word that is unknown or not
// simulated gives a note with its line, never silence. What cannot be run (parameters, expressions,
// subprograms) and what a controller refuses (arcs whose radii disagree, feed moves without a feed)
// is a GCodeError.
//
// Laws:
// - moves, lines, tools and spindle_speeds are equally long.
// - Each move begins where the one before it ended, the first at start_x, start_y, start_z.
// - No move is without length. Arcs turn by at most half a circle about z; longer ones are split.
// - An arc's start and end are equally far from its centre, to 1e-9 mm (for radii up to 1 m), and
// the
//   turn of the one into the other about it is `sweep`.
// - Until x, y and z are all known there are no moves: the place where the last of them becomes
//   known is the start. A place that is lost (G28, G30, G53) is known again in each axis by its
//   next absolute value; the way there is unknown and given as rapids, over the greatest height so
//   far if z was lost.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

struct GCodeNote {
  int line = 0;      // from 1
  std::string text;  // one sentence
};

struct GCodeProgram {
  std::vector<Move> moves;                       // rapids and cuts; mm, mm/min
  std::vector<int> lines;                        // for each move, from 1
  std::vector<int> tools;                        // for each move the T of the last M6, 0 before it
  std::vector<double> spindle_speeds;            // for each move, rev/min; 0 when off or unknown
  bool has_start = false;                        // whether x, y and z were ever all known
  double start_x = 0, start_y = 0, start_z = 0;  // mm
  double dwell_s = 0;                            // s, all dwells together
  std::vector<GCodeNote> notes;
};

struct GCodeOptions {
  double arc_tolerance = 1e-3;                 // mm, of the lines in place of arcs in G18 and G19
  bool block_delete = false;                   // skip the lines that begin with "/"
  std::optional<std::array<double, 3>> start;  // mm, where the tool stands before the program
};

// A program that cannot be run. The sentence begins with "Line N: ".
class GCodeError : public std::invalid_argument {
 public:
  GCodeError(int line, const std::string& sentence)
      : std::invalid_argument("Line " + std::to_string(line) + ": " + sentence), line_(line) {}
  int line() const { return line_; }

 private:
  int line_;
};

GCodeProgram read_gcode(const std::string& text, const GCodeOptions& options = {});

}  // namespace evenload
