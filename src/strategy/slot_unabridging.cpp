#include "strategy/slot_unabridging.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm: stretches with the same middle.
constexpr double kSameMiddle = 1e-6;
// mm: what rounding makes of a step.
constexpr double kSameStep = 1e-9;
// mm along a move of a slot's length: from a parallel to the middle.
constexpr double kParallel = 1e-6;

// Where a cut is undone.
struct Undoing {
  std::size_t pattern = 0;  // that repeats itself there
  int period = 0;           // the one that is made again
  double at = 0;            // mm along the cut's middle, for all other moves
  bool forward = true;      // periods follow each other in the direction of the cut's middle
};

bool follows(const RepeatedPeriods& pattern, const SlotStretch& stretch) {
  const Segment &own = pattern.stretch.middle, &middle = stretch.middle;
  const Vec2 p = middle.point(0.5);
  return own.is_arc() == middle.is_arc() &&
         std::abs(pattern.stretch.half_room - stretch.half_room) < kSameMiddle &&
         distance(pose_on(pattern.stretch, along(own, p)).p, p) < kSameMiddle;
}

bool passes(const RepeatedPeriods& pattern, Vec2 place) {
  const double s = along(pattern.stretch.middle, place) - pattern.begin;
  return s > 0 && s < pattern.count * pattern.step &&
         distance(pose_on(pattern.stretch, s + pattern.begin).p, place) < kSameMiddle;
}

// The middle of what both intervals share; nothing where that is nothing.
std::optional<double> middle_of(std::pair<double, double> a, std::pair<double, double> b) {
  const double low = std::max(a.first, b.first), high = std::min(a.second, b.second);
  if (low > high) return std::nullopt;
  return 0.5 * (low + high);
}

class Undo {
 public:
  Undo(const SlotCut& cut, std::vector<RepeatedPeriods>& patterns, double radius)
      : cut_(cut), middle_(cut.stretch.middle), patterns_(patterns), radius_(radius) {}

  bool run(std::vector<PlanarRun>& runs, Unabridged& added) {
    const std::optional<Undoing> place = find_place();
    if (!place) return false;
    place_ = *place;
    sides_.emplace(cut_, place_.at);
    for (PlanarRun& run : runs)
      if (!undo(run)) return false;
    if (!was_repeated_) return false;
    added.passes += cut_.periods;
    added.links += cut_.periods;
    added.area += 2 * (cut_.stretch.half_room + radius_) * cut_.out;
    move_patterns();
    return true;
  }

 private:
  // ---- where ----

  // A pattern repeats itself once it has gone as far as it reaches. Nothing else reaches there from
  // its ends, nor from where the walls end.
  std::optional<Undoing> find_place() const {
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      const RepeatedPeriods& p = patterns_[i];
      if (!follows(p, cut_.stretch) || std::abs(p.step - cut_.step()) > kSameStep) continue;
      const double length = middle_.length();
      const Pose begin = pose_on(p.stretch, p.begin);
      const double sign =
          dot(unit(begin.heading), middle_.tangent(middle_.nearest(begin.p))) > 0 ? 1 : -1;
      const double first = along(middle_, begin.p), end = first + sign * (p.count - 1) * p.step;
      const double clear = 2 * radius_;
      // Measured in the direction of the periods, from where the first one is.
      const double walls_begin = sign > 0 ? -first : first - length,
                   walls_end = walls_begin + length, last = sign * (end - first);
      const std::optional<double> at =
          middle_of({p.reach.ahead + clear, last + p.reach.back - clear},
                    {walls_begin + clear, walls_end - clear});
      const std::optional<double> made =
          middle_of({p.reach.ahead - p.reach.back + clear, last},
                    {walls_begin - p.reach.back + radius_, walls_end - p.reach.ahead - radius_});
      if (!at || !made) continue;
      const int number = static_cast<int>(std::floor(*made / p.step));
      if (number * p.step <= p.reach.ahead - p.reach.back + clear) continue;
      return Undoing{i, p.first + number, first + sign * *at, sign > 0};
    }
    return std::nullopt;
  }

  // ---- how ----

  bool undo(PlanarRun& run) {
    Descent& descent = run.descent;
    if (sides_->is_beyond(descent.at)) {
      const Pose motion = motion_along(middle_, cut_.out);
      descent.at = moved(descent.at, motion);
      descent.centre = moved(descent.centre, motion);
      descent.ramp_end = moved(descent.ramp_end, motion);
      descent.stretch = rotated(descent.stretch, motion.heading);
    }
    std::vector<PlanarMove> moves, again;
    for (PlanarMove& move : run.moves) {
      if (move.period >= 0) {
        if (move.period == place_.period) again.push_back(move);
        if (move.period != place_.period && !again.empty()) repeat(again, moves);
        move.segment = placed(move.segment, motion_of(move.period));
      } else {
        if (!again.empty()) repeat(again, moves);
        if (!undo(move)) return false;
      }
      moves.push_back(move);
    }
    if (!again.empty()) repeat(again, moves);
    run.moves = std::move(moves);
    return true;
  }

  // A move that is no period's.
  bool undo(PlanarMove& move) const {
    const bool starts_beyond = sides_->is_beyond(move.segment.a),
               ends_beyond = sides_->is_beyond(move.segment.b);
    if (starts_beyond != ends_beyond) return lengthen(move.segment, ends_beyond);
    if (starts_beyond) move.segment = placed(move.segment, motion_along(middle_, cut_.out));
    return true;
  }

  // A move past the place, which must be parallel to the middle and pass a whole period: then its
  // feed is that for any more.
  bool lengthen(Segment& move, bool forward) const {
    const double half = 0.5 * cut_.step();
    const double a = along(middle_, move.a), b = along(middle_, move.b);
    if (std::abs(a - place_.at) < half || std::abs(b - place_.at) < half) return false;
    const Pose motion = motion_along(middle_, cut_.out);
    if (!move.is_arc()) {
      if (std::abs(cross(move.b - move.a, middle_.tangent(0))) > kParallel || middle_.is_arc())
        return false;
      move = forward ? Segment::line(move.a, moved(move.b, motion))
                     : Segment::line(moved(move.a, motion), move.b);
      return true;
    }
    if (!middle_.is_arc() || distance(move.centre, middle_.centre) > kParallel) return false;
    const double sense = move.sweep > 0 ? 1 : -1;
    const double start = move.start_angle + (forward ? 0 : motion.heading);
    move = Segment::arc(move.centre, move.radius, start,
                        move.sweep + sense * cut_.out / middle_.radius);
    return std::abs(move.sweep) < 2 * kPi;
  }

  // The periods made again, after the one that `again` holds as it was.
  void repeat(std::vector<PlanarMove>& again, std::vector<PlanarMove>& moves) {
    const double step = place_.forward ? cut_.step() : -cut_.step();
    const double from = place_.forward ? 0 : cut_.out;
    moves.reserve(moves.size() + again.size() * static_cast<std::size_t>(cut_.periods));
    for (int i = 1; i <= cut_.periods; ++i) {
      const Pose motion = motion_along(middle_, from + i * step);
      for (PlanarMove move : again) {
        move.segment = placed(move.segment, motion);
        moves.push_back(move);
      }
    }
    again.clear();
    was_repeated_ = true;
  }

  Pose motion_of(int period) const {
    const RepeatedPeriods& own = patterns_[place_.pattern];
    bool is_moved = false;
    if (period >= own.first && period < own.first + own.count)
      is_moved = (period > place_.period) == place_.forward;
    else
      is_moved = sides_->is_beyond(pose_of(period).p);
    return motion_along(middle_, is_moved ? cut_.out : 0);
  }

  Pose pose_of(int period) const {
    for (const RepeatedPeriods& p : patterns_)
      if (period >= p.first && period < p.first + p.count)
        return pose_on(p.stretch, p.begin + (period - p.first) * p.step);
    return {};
  }

  // Other patterns go with the ground. This one's periods are no more one step from each other:
  // what comes after the repeated one is a pattern of its own.
  void move_patterns() {
    const Pose motion = motion_along(middle_, cut_.out);
    RepeatedPeriods after = patterns_[place_.pattern];
    const int done = place_.period + 1 - after.first;
    after.first += done;
    after.count -= done;
    after.begin += done * after.step;
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      RepeatedPeriods& p = patterns_[i];
      const bool is_own = i == place_.pattern;
      if (is_own ? !place_.forward : sides_->is_beyond(pose_on(p.stretch, p.begin).p))
        p.stretch.middle = placed(p.stretch.middle, motion);
    }
    patterns_[place_.pattern].count = done;
    if (place_.forward) after.stretch.middle = placed(after.stretch.middle, motion);
    patterns_.push_back(after);
  }

  const SlotCut& cut_;
  const Segment& middle_;
  std::vector<RepeatedPeriods>& patterns_;
  double radius_;
  Undoing place_;
  std::optional<GroundSides> sides_;
  bool was_repeated_ = false;
};

}  // namespace

std::optional<Unabridged> unabridge(std::vector<PlanarRun>& runs, const std::vector<SlotCut>& cuts,
                                    std::vector<RepeatedPeriods> patterns, double tool_radius,
                                    std::vector<SlotPiece>& spared) {
  const std::size_t known = spared.size();
  for (const SlotCut& cut : cuts)
    if (std::none_of(patterns.begin(), patterns.end(),
                     [&](const RepeatedPeriods& pattern) { return passes(pattern, cut.place); }))
      for (const bool reversed : {false, true})
        spared.push_back({cut.from.stretch, cut.from.number, reversed});
  if (spared.size() > known) return std::nullopt;
  Unabridged added;
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut)
    if (!Undo(*cut, patterns, tool_radius).run(runs, added)) {
      spared.push_back(cut->from);
      return std::nullopt;
    }
  return added;
}

}  // namespace evenload
