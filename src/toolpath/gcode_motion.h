// What the lines of a G-code program make of the tool's place: moves, cycles, places lost.
#pragma once

#include <string>

#include "toolpath/gcode_line.h"
#include "toolpath/gcode_path.h"

namespace evenload {

enum class GCodeFeedMode { kPerMinute, kInverseTime, kPerRevolution };

// What holds for moves until it is changed.
struct GCodeModes {
  GCodePlane plane;
  bool incremental = false;      // G91
  bool centre_absolute = false;  // G90.1
  double scale = 1;              // mm per unit
  GCodeFeedMode feed_mode = GCodeFeedMode::kPerMinute;
  double feed = 0;                // mm/min or mm/rev, 0: none
  double inverse_time = 0;        // 1/min, of one line
  double speed = 0;               // rev/min
  bool to_retract_plane = false;  // G99
};

class GCodeMotion {
 public:
  // Both must outlive this; `modes` are read at each line.
  GCodeMotion(GCodePath& path, const GCodeModes& modes) : path_(path), modes_(modes) {}

  // The motion from now on: a G code of GGroup::kMotion, in tenths.
  void set(int tenths);
  void end_cycle();
  // The moves of one line, whose modes are set.
  void run(GCodeLine& line, const GCodeLineCodes& codes);

  bool moved() const { return moved_; }  // an axis word has been run

 private:
  enum class Kind {
    kNone,
    kRapid,
    kFeed,
    kClockwise,
    kCounterClockwise,
    kDrill,
    kBackBoring,
    kUnread
  };

  bool is_cycle() const { return kind_ == Kind::kDrill || kind_ == Kind::kBackBoring; }
  void forget_axes(const GCodeLine& line);
  void aim(GCodePlace& place, int axis, double number) const;
  GCodePlace target(GCodeLine& line) const;
  double feed_for(const GCodeLine& line, double length) const;
  void go_straight(GCodeLine& line);
  void go_round(GCodeLine& line, bool named);
  GCodeArc arc_of(GCodeLine& line, const GCodePlace& from, const GCodePlace& to) const;

  void read_cycle(GCodeLine& line, const std::string& name);
  void drill(GCodeLine& line);
  void drill_one(const GCodeLine& line, GCodePlace place);
  bool pecks() const { return code_ == 830 || code_ == 730; }
  bool feeds_out() const { return code_ == 740 || code_ == 840 || code_ == 850 || code_ == 890; }

  void lose(const std::string& code, bool all, const GCodeLine& line);
  void go_to_reference(GCodeLine& line, const std::string& code);
  void go_in_machine_coordinates(GCodeLine& line);
  void offset(GCodeLine& line, int tenths);

  GCodePath& path_;
  const GCodeModes& modes_;
  Kind kind_ = Kind::kNone;
  int code_ = 0;  // tenths
  bool moved_ = false;
  // Of the cycle:
  bool has_retract_ = false, has_bottom_ = false, has_initial_ = false;
  double retract_ = 0, bottom_ = 0, initial_ = 0, peck_ = 0;  // mm
  double dwell_ = 0;                                          // s
};

}  // namespace evenload
