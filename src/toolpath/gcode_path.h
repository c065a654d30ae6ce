// The moves of a G-code program, and how much of the tool's place is known while they are read.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "toolpath/gcode.h"
#include "toolpath/gcode_arc.h"

namespace evenload {

// x, y and z by their index, each known or not.
struct GCodePlace {
  std::array<double, 3> at{};  // mm
  std::array<bool, 3> known{};
  bool whole() const { return known[0] && known[1] && known[2]; }
};

// The axes of G17, G18 or G19: the first two span the plane, counter-clockwise seen from the tip of
// the third.
struct GCodePlane {
  int first = 0, second = 1, third = 2;
};

class GCodePath {
 public:
  explicit GCodePath(const GCodeOptions& options);

  const GCodePlace& place() const { return place_; }
  // Words that hold for the moves to come.
  void set_line(int line) { line_ = line; }
  void set_tool(int tool) { tool_ = tool; }
  void set_spindle_speed(double speed) { spindle_speed_ = speed; }

  void note(const std::string& sentence) { program_.notes.push_back({line_, sentence}); }
  void dwell(double seconds) { program_.dwell_s += seconds; }

  // A straight move; what is not known at its target is not known after it.
  void straight(MoveKind kind, const GCodePlace& target, double feed);
  // `arc` lies in `plane`, from the present place to `target`; the third axis goes along evenly.
  // Where one of them is not wholly known it is a straight feed move, with its note.
  void arc(const GCodeArc& arc, const GCodePlane& plane, const GCodePlace& target, double feed);
  void forget(int axis);
  // As a G92 tells it: the present place in one axis.
  void learn(int axis, double value);

  GCodeProgram take() { return std::move(program_); }

 private:
  void arrive_from_unknown(MoveKind kind, double feed);
  void push(MoveKind kind, const std::array<double, 3>& to, double feed);
  void push(const Move& move);

  const double arc_tolerance_;
  GCodeProgram program_;
  GCodePlace place_;
  std::array<double, 3> end_{};  // of the last move, or the start
  double highest_ = 0;           // of all ends
  bool lost_height_ = false;     // z was forgotten since the last move
  bool told_unknown_ = false;    // the present stretch of unknown feed moves has its note
  int line_ = 0;
  int tool_ = 0;
  double spindle_speed_ = 0;
};

}  // namespace evenload
