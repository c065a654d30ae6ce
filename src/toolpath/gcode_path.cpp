#include "toolpath/gcode_path.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Lines in place of one arc: more is no arc of a real machine, and would fill the memory.
constexpr double kMostChords = 1e6;

}  // namespace

GCodePath::GCodePath(const GCodeOptions& options) : arc_tolerance_(options.arc_tolerance) {
  if (!options.start) return;
  for (int axis = 0; axis < 3; ++axis) learn(axis, (*options.start)[axis]);
}

void GCodePath::push(const Move& move) {
  program_.moves.push_back(move);
  program_.lines.push_back(line_);
  program_.tools.push_back(tool_);
  program_.spindle_speeds.push_back(spindle_speed_);
  end_ = {move.x, move.y, move.z};
  highest_ = std::max(highest_, move.z);
}

void GCodePath::push(MoveKind kind, const std::array<double, 3>& to, double feed) {
  if (to == end_) return;
  Move move;
  move.kind = kind;
  move.x = to[0];
  move.y = to[1];
  move.z = to[2];
  move.feed = kind == MoveKind::kRapid ? 0 : feed;
  push(move);
}

void GCodePath::straight(MoveKind kind, const GCodePlace& target, double feed) {
  const bool from_known = place_.whole();
  place_ = target;
  if (from_known && place_.whole()) {
    push(kind, place_.at, feed);
  } else {
    arrive_from_unknown(kind, feed);
  }
}

// The tool has come from a place that is not wholly known to one that perhaps is.
void GCodePath::arrive_from_unknown(MoveKind kind, double feed) {
  if (kind != MoveKind::kRapid && !told_unknown_) {
    note(
        place_.whole()
            ? "The feed move is not simulated as it is, for its start is unknown: give X, Y and Z "
              "by a rapid before it, or the start."
            : "Feed moves from here on are not simulated until X, Y and Z are all known: give them "
              "by a rapid, or give the start.");
    told_unknown_ = true;
  }
  if (!place_.whole()) return;
  told_unknown_ = false;
  if (!program_.has_start) {
    program_.has_start = true;
    program_.start_x = place_.at[0];
    program_.start_y = place_.at[1];
    program_.start_z = highest_ = place_.at[2];
    end_ = place_.at;
  } else {
    if (lost_height_) {
      const double height = std::max(highest_, place_.at[2]);
      push(MoveKind::kRapid, {end_[0], end_[1], height}, 0);
      push(MoveKind::kRapid, {place_.at[0], place_.at[1], height}, 0);
    }
    push(feed > 0 ? kind : MoveKind::kRapid, place_.at, feed);
  }
  lost_height_ = false;
}

void GCodePath::arc(const GCodeArc& arc, const GCodePlane& plane, const GCodePlace& target,
                    double feed) {
  if (!place_.whole() || !target.whole()) {
    straight(MoveKind::kCut, target, feed);
    return;
  }
  const double from = place_.at[plane.third];
  const double rise = target.at[plane.third] - from;
  place_ = target;
  if (plane.third == 2) {
    const std::vector<ArcPiece> pieces = pieces_of(arc);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const ArcPiece& piece = pieces[i];
      const double z = i + 1 == pieces.size() ? target.at[2] : from + rise * piece.share;
      push(Move{MoveKind::kCut, piece.end.x, piece.end.y, z, piece.sweep, piece.centre.x,
                piece.centre.y, feed});
    }
    return;
  }
  const double chords = chords_of(arc, arc_tolerance_);
  if (chords > kMostChords)
    throw GCodeError(line_,
                     "the arc would need more than a million lines: raise the arc tolerance.");
  const int n = static_cast<int>(chords);
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    const Vec2 p = arc.point(t);
    std::array<double, 3> to{};
    to[plane.first] = p.x;
    to[plane.second] = p.y;
    to[plane.third] = from + rise * t;
    push(MoveKind::kCut, to, feed);
  }
  push(MoveKind::kCut, target.at, feed);
}

void GCodePath::forget(int axis) {
  place_.known[axis] = false;
  if (axis == 2) lost_height_ = true;
}

void GCodePath::learn(int axis, double value) {
  place_.known[axis] = true;
  place_.at[axis] = value;
  if (place_.whole()) arrive_from_unknown(MoveKind::kRapid, 0);
}

}  // namespace evenload
