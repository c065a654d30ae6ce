#include "toolpath/gcode_motion.h"

#include <array>
#include <cmath>

#include "toolpath/gcode_arc.h"
#include "toolpath/gcode_cycle.h"

namespace evenload {
namespace {

constexpr std::array<char, 3> kAxes{'X', 'Y', 'Z'};
constexpr std::array<char, 3> kCentres{'I', 'J', 'K'};

}  // namespace

void GCodeMotion::set(int tenths) {
  const bool was_cycle = is_cycle();
  switch (tenths) {
    case 0:
      kind_ = Kind::kRapid;
      break;
    case 10:
      kind_ = Kind::kFeed;
      break;
    case 20:
      kind_ = Kind::kClockwise;
      break;
    case 30:
      kind_ = Kind::kCounterClockwise;
      break;
    case 870:
      kind_ = Kind::kBackBoring;
      break;
    default:
      kind_ = Kind::kDrill;
  }
  code_ = tenths;
  if (!is_cycle() || was_cycle) return;
  has_retract_ = has_bottom_ = false;
  peck_ = dwell_ = 0;
  has_initial_ = path_.place().known[2];
  initial_ = path_.place().at[2];
}

void GCodeMotion::end_cycle() {
  if (is_cycle() || kind_ == Kind::kUnread) kind_ = Kind::kNone;
}

void GCodeMotion::run(GCodeLine& line, const GCodeLineCodes& codes) {
  switch (codes.non_modal) {
    case 40:
      return;
    case 280:
    case 300:
      return go_to_reference(line, codes.non_modal == 280 ? "G28" : "G30");
    case 530:
      return go_in_machine_coordinates(line);
    case 100:
    case 520:
    case 920:
    case 923:
      return offset(line, codes.non_modal);
    default:
      break;
  }
  const bool named = codes.motion >= 0;
  if (codes.unknown_g && !named) {  // the line's words belong to that code
    if (codes.unknown_moves) forget_axes(line);
    if (codes.unknown_motion && line.has_axes()) kind_ = Kind::kUnread;
    return;
  }
  if (line.has_axes()) moved_ = true;
  switch (kind_) {
    case Kind::kNone:
      if (line.has_axes())
        line.fail("the axis words have no motion code: put G0, G1, G2 or G3 before them.");
      break;
    case Kind::kRapid:
    case Kind::kFeed:
      if (line.has_axes()) go_straight(line);
      break;
    case Kind::kClockwise:
    case Kind::kCounterClockwise:
      go_round(line, named);
      break;
    case Kind::kDrill:
    case Kind::kBackBoring:
      if (line.has_axes() || named) drill(line);
      break;
    case Kind::kUnread:
      if (!line.has_axes()) break;
      forget_axes(line);
      path_.note(
          "'" + line.take_the_rest() +
          "' goes with the motion of a line before, which is not simulated: the place in its "
          "axes is unknown after it.");
      break;
  }
}

void GCodeMotion::forget_axes(const GCodeLine& line) {
  for (int axis = 0; axis < 3; ++axis)
    if (line.has(kAxes[axis])) path_.forget(axis);
}

// An axis of `place` by the number of its word.
void GCodeMotion::aim(GCodePlace& place, int axis, double number) const {
  const double value = number * modes_.scale;
  place.at[axis] = modes_.incremental ? place.at[axis] + value : value;
  place.known[axis] = place.known[axis] || !modes_.incremental;
}

// The place that the axis words name.
GCodePlace GCodeMotion::target(GCodeLine& line) const {
  GCodePlace place = path_.place();
  for (int axis = 0; axis < 3; ++axis)
    if (line.has(kAxes[axis])) aim(place, axis, line.take(kAxes[axis]));
  return place;
}

// mm/min of a feed move of `length` mm.
double GCodeMotion::feed_for(const GCodeLine& line, double length) const {
  switch (modes_.feed_mode) {
    case GCodeFeedMode::kInverseTime:
      if (modes_.inverse_time <= 0) line.fail("a feed move in G93 needs its own F above zero.");
      return modes_.inverse_time * length;
    case GCodeFeedMode::kPerRevolution:
      if (modes_.feed <= 0) break;
      if (modes_.speed <= 0)
        line.fail("a feed move in G95 needs a spindle speed: put S before it.");
      return modes_.feed * modes_.speed;
    case GCodeFeedMode::kPerMinute:
      break;
  }
  if (modes_.feed <= 0) line.fail("a feed move has no feed: put F before it, above zero.");
  return modes_.feed;
}

void GCodeMotion::go_straight(GCodeLine& line) {
  const GCodePlace from = path_.place();
  const GCodePlace to = target(line);
  if (kind_ == Kind::kRapid) return path_.straight(MoveKind::kRapid, to, 0);
  double squares = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (from.known[axis] && to.known[axis])
      squares += (to.at[axis] - from.at[axis]) * (to.at[axis] - from.at[axis]);
  path_.straight(MoveKind::kCut, to, feed_for(line, std::sqrt(squares)));
}

void GCodeMotion::go_round(GCodeLine& line, bool named) {
  const GCodePlane& plane = modes_.plane;
  const std::string centre{kCentres[plane.first], kCentres[plane.second]};
  if (!line.has_axes() && !line.has_any(centre) && !(named && line.has('R'))) {
    if (named) line.fail("the arc has no words: give its end, and its centre or radius.");
    return;
  }
  const GCodePlace from = path_.place();
  if (!from.known[plane.first] || !from.known[plane.second])
    line.fail("the arc's start is unknown: go there by G0 or G1 before it.");
  const GCodePlace to = target(line);
  const GCodeArc arc = arc_of(line, from, to);
  // Some posts write I, J and K; the one that has no meaning here is zero then.
  const char third = kCentres[plane.third];
  if (line.has(third) && line.word(third).value == 0) line.ignore({&third, 1});
  const bool rises = from.known[plane.third] && to.known[plane.third];
  const double rise = rises ? to.at[plane.third] - from.at[plane.third] : 0;
  path_.arc(arc, plane, to, feed_for(line, std::hypot(arc.length(), rise)));
}

GCodeArc GCodeMotion::arc_of(GCodeLine& line, const GCodePlace& from, const GCodePlace& to) const {
  const GCodePlane& plane = modes_.plane;
  const char first = kCentres[plane.first], second = kCentres[plane.second];
  const std::string both = std::string(1, first) + " and " + second;
  const bool centre = line.has(first) || line.has(second), radius = line.has('R');
  if (!centre && !radius)
    line.fail("the arc has neither " + both + " nor R: give its centre or its radius.");
  if (centre && radius) line.fail("the arc has a centre and R: take one of them out.");
  const Vec2 start{from.at[plane.first], from.at[plane.second]};
  const Vec2 end{to.at[plane.first], to.at[plane.second]};
  const int turns = line.take_count('P', 1, 1);
  const bool counter_clockwise = kind_ == Kind::kCounterClockwise;
  if (radius)
    return arc_by_radius(start, end, line.take('R') * modes_.scale, counter_clockwise, turns,
                         line.line());
  if (modes_.centre_absolute && !(line.has(first) && line.has(second)))
    line.fail("an arc in G90.1 needs both " + both + ".");
  const Vec2 given{line.has(first) ? line.take(first) * modes_.scale : 0,
                   line.has(second) ? line.take(second) * modes_.scale : 0};
  return arc_by_centre(start, end, modes_.centre_absolute ? given : start + given,
                       counter_clockwise, turns, line.line());
}

// The words of the cycle, which hold until it ends.
void GCodeMotion::read_cycle(GCodeLine& line, const std::string& name) {
  const GCodePlace& place = path_.place();
  if (line.has('R')) {
    retract_ = line.take('R') * modes_.scale + (modes_.incremental ? place.at[2] : 0);
    has_retract_ = !modes_.incremental || place.known[2];
  }
  if (line.has('Z')) {
    bottom_ = line.take('Z') * modes_.scale + (modes_.incremental ? retract_ : 0);
    has_bottom_ = true;
  }
  if (pecks() && line.has('Q')) {
    peck_ = line.take('Q') * modes_.scale;
    if (peck_ <= 0) line.fail(text_of(line.word('Q').text) + " is no depth above zero.");
  }
  if (code_ != 810 && line.has('P')) dwell_ = line.take_not_negative('P');
  if (code_ == 760 || code_ == 870) line.ignore("QIJ");  // how far the tool keeps off the wall
  if (kind_ == Kind::kBackBoring) {
    path_.note(name +
               " bores from below, which is not simulated: the tool goes to its place and not "
               "down.");
    return;
  }
  if (!has_retract_ || !has_bottom_)
    line.fail(name + " needs R and Z: give the retract plane and the depth.");
  if (bottom_ > retract_) line.fail(name + " has its depth Z above its retract plane R.");
  if (pecks() && peck_ == 0)
    path_.note(name + " without Q is simulated in one feed, without pecks.");
}

void GCodeMotion::drill(GCodeLine& line) {
  const std::string name = "G" + std::to_string(code_ / 10);
  if (modes_.plane.third != 2) line.fail(name + " is read in G17 only: choose G17 before it.");
  read_cycle(line, name);
  const int repeats = line.take_count('L', 0, 1);
  for (int i = 0; i < repeats; ++i) {
    GCodePlace place = path_.place();
    const bool bores_back = kind_ == Kind::kBackBoring;  // its R lies below the work
    if (!bores_back && has_retract_ && place.known[2] && place.at[2] < retract_) {
      place.at[2] = retract_;
      path_.straight(MoveKind::kRapid, place, 0);
    }
    if (line.has('X')) aim(place, 0, line.take('X'));
    if (line.has('Y')) aim(place, 1, line.take('Y'));
    path_.straight(MoveKind::kRapid, place, 0);
    if (bores_back) continue;
    drill_one(line, place);
    place.known[2] = true;
    place.at[2] = retract_;
    if (!modes_.to_retract_plane && has_initial_ && initial_ > retract_) place.at[2] = initial_;
    path_.straight(MoveKind::kRapid, place, 0);
  }
}

// One hole at the present x and y.
void GCodeMotion::drill_one(const GCodeLine& line, GCodePlace place) {
  if (modes_.feed_mode == GCodeFeedMode::kInverseTime)
    line.fail("a drilling cycle has no feed in G93: choose G94 before it.");
  const double feed = feed_for(line, 0);
  place.known[2] = true;
  place.at[2] = retract_;
  path_.straight(MoveKind::kRapid, place, 0);
  const DrillCycle cycle{retract_, bottom_, pecks() ? peck_ : 0, code_ == 830, feeds_out()};
  if (cycle.peck > 0 && (retract_ - bottom_) / cycle.peck > kMostRepeats)
    line.fail("the cycle has more than " + std::to_string(kMostRepeats) + " pecks: raise Q.");
  for (const DrillStroke& stroke : strokes_of(cycle)) {
    place.at[2] = stroke.z;
    path_.straight(stroke.kind, place, feed);
  }
  path_.dwell(dwell_);
}

void GCodeMotion::lose(const std::string& code, bool all, const GCodeLine& line) {
  std::string lost;
  for (int axis = 0; axis < 3; ++axis) {
    if (!all && !line.has(kAxes[axis])) continue;
    path_.forget(axis);
    lost += (lost.empty() ? "" : ", ") + std::string(1, kAxes[axis]);
  }
  if (!lost.empty())
    path_.note(code + " goes to a place of the machine's, which the program does not tell: " +
               lost + " is unknown until given again.");
}
void GCodeMotion::go_to_reference(GCodeLine& line, const std::string& code) {
  const bool all = !line.has_any("XYZABCUVW");
  if (line.has_axes()) path_.straight(MoveKind::kRapid, target(line), 0);
  line.ignore("P");  // which reference, of G30
  lose(code, all, line);
}
void GCodeMotion::go_in_machine_coordinates(GCodeLine& line) {
  if (line.has_axes() && kind_ != Kind::kRapid && kind_ != Kind::kFeed)
    line.fail("G53 goes with G0 or G1 only.");
  line.ignore("XYZ");
  lose("G53", false, line);
}
void GCodeMotion::offset(GCodeLine& line, int tenths) {
  const std::string code = "G" + std::to_string(tenths / 10) + (tenths == 923 ? ".3" : "");
  // A place that was unknown is told by G92, whatever the shift.
  if (tenths == 920)
    for (int axis = 0; axis < 3; ++axis)
      if (line.has(kAxes[axis]) && !path_.place().known[axis])
        path_.learn(axis, line.word(kAxes[axis]).value * modes_.scale);
  const std::string rest = line.take_the_rest();
  path_.note("'" + code + (rest.empty() ? "" : " " + rest) +
             "' shifts coordinates, which is not simulated: places after it are in doubt.");
}

}  // namespace evenload
