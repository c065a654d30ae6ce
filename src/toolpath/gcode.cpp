#include "toolpath/gcode.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "toolpath/gcode_codes.h"
#include "toolpath/gcode_line.h"
#include "toolpath/gcode_motion.h"
#include "toolpath/gcode_path.h"
#include "toolpath/gcode_words.h"

namespace evenload {
namespace {

constexpr double kInch = 25.4;  // mm

// Ten times the number of a G or M code, or -1 for a number that is none.
int tenths_of(double number) {
  const double tenths = std::round(number * 10);
  return std::abs(number * 10 - tenths) < 1e-6 && tenths >= 0 && tenths < 1e5
             ? static_cast<int>(tenths)
             : -1;
}

// LinuxCNC's G76 is a thread, whose depths are I, J and K; elsewhere it bores a hole.
bool cuts_a_thread(const GCodeLine& line) {
  return line.has('I') && line.has('J') && line.has('K');
}

void exclude(const GCodeLine& line, std::uint32_t& groups, int group, const GCodeWord& word,
             bool exclusive) {
  if (!exclusive) return;
  if (groups & (1U << group))
    line.fail(text_of(word.text) +
              " and another code of its kind exclude each other: put them on two lines.");
  groups |= 1U << group;
}

void add_unknown(GCodeLineCodes& codes, const GCodeWord& word) {
  codes.unknown += (codes.unknown.empty() ? "" : " ") + text_of(word.text);
}

class Interpreter {
 public:
  explicit Interpreter(const GCodeOptions& options)
      : options_(options), path_(options), motion_(path_, modes_) {}

  GCodeProgram run(std::string_view text) {
    GCodeBlocks blocks(text);
    GCodeBlock block;
    bool begun = false;
    while (!ended_ && blocks.next(block)) {
      path_.set_line(block.line);
      switch (block.kind) {
        case GCodeBlock::Kind::kPercent:
          ended_ = begun;  // the first stands before the program, the second behind it
          break;
        case GCodeBlock::Kind::kSetting:
          path_.note("'" + text_of(block.text) +
                     "' is a setting of the controller: not simulated.");
          break;
        case GCodeBlock::Kind::kWords:
          begun = begun || !block.words.empty();
          if (block.open_comment)
            path_.note("The comment does not end: the line is not read from its '(' on.");
          run_block(block);
          break;
      }
    }
    while (blocks.skip(block)) {
      if (block.text.empty() || block.kind == GCodeBlock::Kind::kPercent) continue;
      path_.set_line(block.line);
      path_.note("The program has ended before this line: nothing is read from here on.");
      break;
    }
    return path_.take();
  }

 private:
  void run_block(const GCodeBlock& block) {
    if (block.optional) {
      if (options_.block_delete) return;
      if (!told_block_delete_)
        path_.note("Lines that begin with '/' are run, as the block delete switch counts as off.");
      told_block_delete_ = true;
    }
    if (block.words.empty()) return;
    GCodeLine line(block);
    const GCodeLineCodes codes = read_codes(line);
    line.ignore("NODHT");
    take_values(line, codes);
    if (codes.non_modal == 40) dwell(line);
    if (codes.ends_cycle) motion_.end_cycle();
    if (codes.motion >= 0) motion_.set(codes.motion);
    motion_.run(line, codes);
    if (motion_.moved() && !units_named_) {
      path_.note(
          "The program moves before it names its units: they count as mm; put G21, or G20 for "
          "inches, before it.");
      units_named_ = true;  // told once
    }
    tell_the_rest(line, codes);
    if (codes.stop == 20 || codes.stop == 300) ended_ = true;
  }

  GCodeLineCodes read_codes(GCodeLine& line) {
    GCodeLineCodes codes;
    std::uint32_t g_groups = 0, m_groups = 0;
    for (const GCodeWord& word : line.words()) {
      if (word.letter == 'G') {
        const int tenths = tenths_of(word.value);
        if (tenths == 650 || tenths == 660 || tenths == 661)
          line.fail(text_of(word.text) + " calls a macro, which cannot be run: post without it.");
        const GGroup group =
            tenths == 760 && cuts_a_thread(line) ? GGroup::kUnknown : group_of_g(tenths);
        exclude(line, g_groups, static_cast<int>(group), word, group != GGroup::kUnknown);
        apply_g(line, codes, tenths, group, word);
      } else if (word.letter == 'M') {
        const int tenths = tenths_of(word.value);
        if (tenths >= 960 && tenths <= 990)
          line.fail(text_of(word.text) +
                    " is a subprogram, which cannot be run: post the program in one piece.");
        const MGroup group = group_of_m(tenths);
        exclude(line, m_groups, static_cast<int>(group), word,
                group != MGroup::kUnknown && group != MGroup::kAccepted);
        if (group == MGroup::kUnknown) add_unknown(codes, word);
        if (group == MGroup::kStop) codes.stop = tenths;
        if (group == MGroup::kSpindle) codes.spindle = tenths / 10;
        if (group == MGroup::kToolChange) codes.tool_change = true;
      }
    }
    return codes;
  }

  void apply_g(GCodeLine& line, GCodeLineCodes& codes, int tenths, GGroup group,
               const GCodeWord& word) {
    switch (group) {
      case GGroup::kUnknown:
        add_unknown(codes, word);
        codes.unknown_g = true;
        codes.unknown_moves = codes.unknown_moves || !only_names_a_place(tenths);
        codes.unknown_motion = codes.unknown_motion || is_unread_motion(tenths);
        break;
      case GGroup::kNonModal:
        codes.non_modal = tenths;
        break;
      case GGroup::kMotion:
        codes.motion = tenths;
        break;
      case GGroup::kCycleEnd:
        codes.ends_cycle = true;
        break;
      case GGroup::kPlane:
        modes_.plane = tenths == 170   ? GCodePlane{0, 1, 2}
                       : tenths == 180 ? GCodePlane{2, 0, 1}
                                       : GCodePlane{1, 2, 0};
        break;
      case GGroup::kDistance:
        modes_.incremental = tenths == 910;
        break;
      case GGroup::kArcDistance:
        modes_.centre_absolute = tenths == 901;
        break;
      case GGroup::kFeedMode: {
        const GCodeFeedMode mode = tenths == 930   ? GCodeFeedMode::kInverseTime
                                   : tenths == 950 ? GCodeFeedMode::kPerRevolution
                                                   : GCodeFeedMode::kPerMinute;
        if (mode != modes_.feed_mode) modes_.feed = 0;  // its number means something else now
        modes_.feed_mode = mode;
        break;
      }
      case GGroup::kUnits:
        codes.changes_units = modes_.scale != (tenths == 200 ? kInch : 1);
        modes_.scale = tenths == 200 ? kInch : 1;
        units_named_ = true;
        break;
      case GGroup::kCompensation:
        if (tenths != 400)
          path_.note(text_of(word.text) +
                     " is not simulated: the path is the programmed one, without compensation.");
        break;
      case GGroup::kRetract:
        modes_.to_retract_plane = tenths == 990;
        break;
      case GGroup::kWorkCoordinates:
        set_work_coordinates(line, tenths, word);
        break;
      case GGroup::kSpindleMode:
        if (tenths == 960)
          path_.note(text_of(word.text) +
                     " is not simulated: the spindle speed counts as unknown until G97.");
        if (surface_speed_ != (tenths == 960)) modes_.speed = 0;
        surface_speed_ = tenths == 960;
        break;
      case GGroup::kToolLength:
      case GGroup::kPathControl:
        line.ignore("PQ");  // the tolerances of G64
        break;
      case GGroup::kScaling:
      case GGroup::kRotation:
      case GGroup::kPolar:
        break;
    }
  }

  void set_work_coordinates(GCodeLine& line, int tenths, const GCodeWord& word) {
    std::string name = "G" + std::to_string(tenths);
    if (tenths == 541 || tenths == 1540) {
      if (!line.has('P')) line.fail(text_of(word.text) + " needs P: say which system is meant.");
      name += "P" + std::to_string(line.take('P'));
    }
    if (work_coordinates_ != name && (!work_coordinates_.empty() || motion_.moved()))
      path_.note(text_of(word.text) +
                 " changes the work coordinates: they count as the same place as those before.");
    work_coordinates_ = name;
  }

  // F, S, T and what M codes do with them. Units and feed mode of the same line hold for F already.
  void take_values(GCodeLine& line, const GCodeLineCodes& codes) {
    modes_.inverse_time = 0;
    if (line.has('F')) {
      const double value = line.take_not_negative('F');
      if (modes_.feed_mode == GCodeFeedMode::kInverseTime) {
        modes_.inverse_time = value;
      } else {
        modes_.feed = value * modes_.scale;
        if (codes.changes_units)
          path_.note(
              "F counts in the units of its own line, as grbl has it; LinuxCNC takes those "
              "before.");
      }
    }
    if (line.has('S')) {
      const double value = line.take_not_negative('S');
      if (!surface_speed_) modes_.speed = value;
    }
    if (line.has('T')) {
      const double value = line.take_not_negative('T');
      if (value != std::floor(value))
        line.fail(text_of(line.word('T').text) + " is no tool number: write a whole number.");
      selected_tool_ = static_cast<int>(value);
    }
    if (codes.tool_change) path_.set_tool(selected_tool_);
    if (codes.spindle != 0) spindle_on_ = codes.spindle != 5;
    if (codes.spindle == 4)
      path_.note("M4 turns the spindle counter-clockwise: it is simulated like M3.");
    path_.set_spindle_speed(spindle_on_ ? modes_.speed : 0);
  }

  void dwell(GCodeLine& line) {
    const char letter = line.has('P') ? 'P' : 'X';
    if (!line.has(letter)) line.fail("G4 needs P: say how many seconds.");
    path_.dwell(line.take_not_negative(letter));
  }

  void tell_the_rest(GCodeLine& line, const GCodeLineCodes& codes) {
    if (!codes.unknown.empty()) {
      const bool lost = codes.unknown_moves && codes.motion < 0 && line.has_axes();
      const std::string rest = line.take_the_rest();
      path_.note("'" + codes.unknown + (rest.empty() ? "" : " " + rest) + "' is not simulated" +
                 (lost ? ", and the place in its axes is unknown after it." : "."));
    } else if (!line.all_used()) {
      path_.note("'" + line.take_the_rest() + "' is not simulated.");
    }
  }

  const GCodeOptions& options_;
  GCodePath path_;
  GCodeModes modes_;
  GCodeMotion motion_;
  bool ended_ = false, told_block_delete_ = false, units_named_ = false;
  std::string work_coordinates_;
  bool surface_speed_ = false, spindle_on_ = false;
  int selected_tool_ = 0;
};

}  // namespace

GCodeProgram read_gcode(const std::string& text, const GCodeOptions& options) {
  if (!(options.arc_tolerance > 0) || !std::isfinite(options.arc_tolerance))
    throw std::invalid_argument("arc_tolerance must be above zero.");
  if (options.start)
    for (const double value : *options.start)
      if (!std::isfinite(value)) throw std::invalid_argument("start must be finite.");
  return Interpreter(options).run(text);
}

}  // namespace evenload
