#include "strategy/slot_unabridging.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "strategy/links.h"
#include "strategy/move_ends.h"
#include "strategy/trochoid_period.h"

namespace evenload {
namespace {

// mm: stretches with the same middle.
constexpr double kSameMiddle = 1e-6;
// mm: what rounding makes of a step.
constexpr double kSameStep = 1e-9;
// mm along a move of a slot's length: from a parallel to the middle.
constexpr double kParallel = 1e-6;

// Of what periods remove that repeat each other: less is missing only for looks at other places.
constexpr double kAsMuch = 0.99;

// Of the time of a step: two that repeat each other differ by less.
constexpr double kSameTime = 0.03;

// Of what the tool's centre has gone over to both sides of the middle: links there are clear of
// what the pattern leaves at its sides.
constexpr double kClearWidth = 0.5;
// Of a link's two halves: what the turns take where it is bent to go along the middle.
constexpr double kTurnShare = 0.4;

// Where a cut is undone.
struct Undoing {
  std::size_t pattern = 0;  // that repeats itself there
  int period = 0;           // the one that is made again
  double at = 0;            // mm along the cut's middle, for all other moves
  double from = 0, to = 0;  // mm, between which that could be as well
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

using Interval = std::pair<double, double>;

// What both intervals share; nothing where that is nothing.
std::optional<Interval> shared(Interval a, Interval b) {
  const Interval both{std::max(a.first, b.first), std::min(a.second, b.second)};
  if (both.first > both.second) return std::nullopt;
  return both;
}

double middle_of(Interval a) { return 0.5 * (a.first + a.second); }

class Undo {
 public:
  Undo(const SlotCut& cut, const RemovedByPeriod& removed, std::vector<RepeatedPeriods>& patterns,
       const ClearingParams& params)
      : cut_(cut),
        middle_(cut.stretch.middle),
        removed_(removed),
        patterns_(patterns),
        params_(params),
        radius_(0.5 * params.tool_diameter) {}

  bool run(std::vector<PlanarRun>& runs, Unabridged& added) {
    const std::optional<Undoing> place = find_place();
    if (!place) return false;
    place_ = *place;
    sides_.emplace(cut_, place_.at);
    std::vector<PlanarRun> parts;
    for (const PlanarRun& run : runs) lift_over(run, parts, added);
    runs = std::move(parts);
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
      const std::optional<Interval> at =
          shared({p.reach.ahead + clear, last + p.reach.back - clear},
                 {walls_begin + clear, walls_end - clear});
      const std::optional<Interval> made =
          shared({p.reach.ahead - p.reach.back + clear, last},
                 {walls_begin - p.reach.back + radius_, walls_end - p.reach.ahead - radius_});
      if (!at || !made) continue;
      const int number = static_cast<int>(std::floor(middle_of(*made) / p.step));
      if (number * p.step <= p.reach.ahead - p.reach.back + clear) continue;
      if (!removes_as_much_as_any(p, p.first + number)) continue;
      const double one = first + sign * at->first, other = first + sign * at->second;
      return Undoing{i,
                     p.first + number,
                     middle_of({one, other}),
                     std::min(one, other),
                     std::max(one, other),
                     sign > 0};
    }
    return std::nullopt;
  }

  bool removes_as_much_as_any(const RepeatedPeriods& pattern, int period) const {
    const auto removed = [&](int number) {
      const auto found = removed_.find(number);
      return found == removed_.end() ? 0 : found->second;
    };
    double most = 0;
    for (int i = 0; i < pattern.count; ++i) most = std::max(most, removed(pattern.first + i));
    return removed(period) >= kAsMuch * most;
  }

  // ---- how ----

  bool leads_past(const PlanarMove& move) const {
    return move.period < 0 &&
           sides_->is_beyond(move.segment.a) != sides_->is_beyond(move.segment.b);
  }

  // Adds the run to `parts`, divided where a link would become longer than a retract: the tool goes
  // up there, and comes down where the next cut begins.
  void lift_over(const PlanarRun& run, std::vector<PlanarRun>& parts, Unabridged& added) const {
    const auto is_link = [](const PlanarMove& move) {
      return move.kind == MoveKind::kLink && move.period < 0;
    };
    parts.push_back({run.descent, {}, run.new_region});
    for (auto move = run.moves.begin(); move != run.moves.end();) {
      auto end = move;
      bool past = false;
      double length = cut_.out;  // mm
      for (; end != run.moves.end() && is_link(*end); ++end) {
        past = past || leads_past(*end);
        length += end->segment.length();
      }
      const auto gap = [&] { return distance(move->segment.a, std::prev(end)->segment.b); };
      const bool lifts =
          past && end != run.moves.end() && length > length_of_retract(gap() + cut_.out, params_);
      if (lifts) {
        parts.push_back({{DescentKind::kPlunge, end->segment.a, {}, 0, {}, true}, {}, false});
        --added.links;
      } else {
        parts.back().moves.insert(parts.back().moves.end(), move, end);
      }
      if (end != run.moves.end()) parts.back().moves.push_back(*end++);
      move = end;
    }
  }

  bool undo(PlanarRun& run) {
    Descent& descent = run.descent;
    if (sides_->is_beyond(descent.at)) {
      const Pose motion = motion_along(middle_, cut_.out);
      descent.at = moved(descent.at, motion);
      descent.centre = moved(descent.centre, motion);
      for (Vec2& place : descent.ramp_by) place = moved(place, motion);
      descent.stretch = rotated(descent.stretch, motion.heading);
    }
    const RepeatedPeriods& pattern = patterns_[place_.pattern];
    std::vector<PlanarMove> moves, again;
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
      const PlanarMove& move = run.moves[i];
      if (move.period != place_.period && !again.empty()) repeat(again, moves);
      if (move.period == place_.period) again.push_back(move);
      if (move.period == pattern.first + pattern.count - 1) is_done_ = true;
      if (move.period < 0) {
        if (!undo(run.moves, i, moves)) return false;
        continue;
      }
      moves.push_back(move);
      moves.back().segment = placed(move.segment, motion_of(move.period));
    }
    if (!again.empty()) repeat(again, moves);
    run.moves = std::move(moves);
    return true;
  }

  // A move that is no period's. False where it leads past the place, and nothing is known of what
  // it would meet.
  bool undo(const std::vector<PlanarMove>& all, std::size_t i,
            std::vector<PlanarMove>& moves) const {
    const PlanarMove& move = all[i];
    const Segment& way = move.segment;
    const bool starts_beyond = sides_->is_beyond(way.a), ends_beyond = sides_->is_beyond(way.b);
    std::vector<Segment> whole;
    if (!leads_past(move))
      whole = {starts_beyond ? placed(way, motion_along(middle_, cut_.out)) : way};
    else if (!is_done_)
      return false;
    else if (move.kind == MoveKind::kCut) {
      whole = lengthened(way, ends_beyond, 0.5 * cut_.step());
      if (whole.empty()) return make_again(all, i, moves);
    } else {
      whole = bent(way, ends_beyond);
    }
    for (const Segment& segment : whole) {
      moves.push_back(move);
      moves.back().segment = segment;
    }
    return !whole.empty();
  }

  bool leads_along(const Segment& move) const {
    if (move.is_arc() != middle_.is_arc()) return false;
    return move.is_arc() ? distance(move.centre, middle_.centre) <= kParallel
                         : std::abs(cross(move.b - move.a, middle_.tangent(0))) <= kParallel;
  }

  // A cut along the middle whose feed changes within a period, with what the periods left beside
  // it: its last pieces of one step in all are made again, as the period is. False where there are
  // none, or where the step before took another time: there the load does not repeat itself.
  bool make_again(const std::vector<PlanarMove>& all, std::size_t i,
                  std::vector<PlanarMove>& moves) const {
    const std::vector<PlanarMove> pieces = last_step(all, i);
    if (pieces.empty()) return false;
    const std::optional<double> last = time_of_last(all, i, cut_.step()),
                                both = time_of_last(all, i, 2 * cut_.step());
    if (!both || std::abs(*both - 2 * *last) > kSameTime * *last) return false;
    const bool forward = sides_->is_beyond(all[i].segment.b);
    const auto push = [&](const PlanarMove& move, double by) {
      moves.push_back(move);
      moves.back().segment = placed(move.segment, motion_along(middle_, by));
    };
    push(all[i], forward ? 0 : cut_.out);
    for (int k = 1; k <= cut_.periods; ++k)
      for (const PlanarMove& piece : pieces)
        push(piece, forward ? k * cut_.step() : cut_.out - k * cut_.step());
    return true;
  }

  // min: of a cut along the middle, the `length` mm of the middle before the end of the move
  // `last`; nothing where it is shorter.
  std::optional<double> time_of_last(const std::vector<PlanarMove>& all, std::size_t last,
                                     double length) const {
    double time = 0;
    for (std::size_t i = last + 1; i-- > 0;) {
      const PlanarMove& move = all[i];
      if (move.kind != MoveKind::kCut || move.period >= 0 || !leads_along(move.segment)) break;
      const double whole =
          std::abs(along(middle_, move.segment.b) - along(middle_, move.segment.a));
      const double share = std::min(1.0, length / whole);
      time += share * move.segment.length() / move.feed;
      length -= share * whole;
      if (share < 1) return time;
    }
    return std::nullopt;
  }

  // The pieces of a cut along the middle that lead one step to the end of the move `last`; empty
  // where it is shorter.
  std::vector<PlanarMove> last_step(const std::vector<PlanarMove>& all, std::size_t last) const {
    std::vector<PlanarMove> pieces;
    double left = cut_.step();
    for (std::size_t i = last + 1; i-- > 0;) {
      const PlanarMove& move = all[i];
      if (move.kind != MoveKind::kCut || move.period >= 0 || !leads_along(move.segment)) return {};
      const double length =
          std::abs(along(middle_, move.segment.b) - along(middle_, move.segment.a));
      pieces.push_back(move);
      if (length >= left) {
        pieces.back().segment = move.segment.part(1 - left / length, 1);
        break;
      }
      left -= length;
      if (i == 0) return {};
    }
    std::reverse(pieces.begin(), pieces.end());
    // No piece becomes tiny.
    if (pieces.size() > 1 && pieces[0].segment.length() < kSlotFeedSteps.shortest) {
      pieces[1].segment = joined(pieces[0].segment, pieces[1].segment);
      pieces[1].feed = std::min(pieces[0].feed, pieces[1].feed);
      pieces.erase(pieces.begin());
    }
    return pieces;
  }

  // A move along the middle, which must go on for `least` mm to both sides of the place: a cut that
  // passes a whole period has the feed for any more. Empty where it does not.
  std::vector<Segment> lengthened(const Segment& move, bool forward, double least) const {
    const double a = along(middle_, move.a), b = along(middle_, move.b);
    if (std::abs(a - place_.at) < least || std::abs(b - place_.at) < least) return {};
    if (!leads_along(move)) return {};
    const Pose motion = motion_along(middle_, cut_.out);
    if (!move.is_arc()) {
      return {forward ? Segment::line(move.a, moved(move.b, motion))
                      : Segment::line(moved(move.a, motion), move.b)};
    }
    const double sweep = move.sweep + (move.sweep > 0 ? 1 : -1) * cut_.out / middle_.radius;
    if (std::abs(sweep) >= 2 * kPi) return {};
    const double start = move.start_angle + (forward ? 0 : motion.heading);
    return {Segment::arc(move.centre, move.radius, start, sweep)};
  }

  // A link that leads aslant past a straight pattern that is done: at the place where it is nearest
  // to the middle it is bent, and goes along the middle for as long as was taken out.
  std::vector<Segment> bent(const Segment& link, bool forward) const {
    if (std::vector<Segment> longer = lengthened(link, forward, 0); !longer.empty()) return longer;
    if (middle_.is_arc() || link.is_arc()) return {};
    const Vec2 u = middle_.tangent(0), ahead = link.tangent(0), turned = forward ? u : -u;
    const double a = along(middle_, link.a), b = along(middle_, link.b);
    const double aside_a = dot(link.a - middle_.a, left_normal(u)),
                 aside_b = dot(link.b - middle_.a, left_normal(u));
    const double one = (place_.from - a) / (b - a), other = (place_.to - a) / (b - a);
    const double first = std::max(0.0, std::min(one, other)),
                 last = std::min(1.0, std::max(one, other));
    if (first >= last) return {};
    const double t = std::clamp(aside_a / (aside_a - aside_b), first, last);
    const double aside = aside_a + t * (aside_b - aside_a);
    if (std::abs(aside) > kClearWidth * patterns_[place_.pattern].half_width) return {};
    const double angle = std::atan2(cross(ahead, turned), dot(ahead, turned));
    const double most =
        kTurnShare * std::min({t * link.length(), (1 - t) * link.length(), cut_.out});
    const double tangent = std::min(most, radius_ * std::tan(0.5 * std::abs(angle)));
    const double turn_radius = tangent / std::tan(0.5 * std::abs(angle));
    const Pose motion = motion_along(middle_, cut_.out);
    const Vec2 near = link.point(t), far = moved(near, motion);
    const Vec2 in = forward ? near : far, out = forward ? far : near;
    const auto turn = [&](Vec2 from, Vec2 direction, double by) {
      const Vec2 side = (by > 0 ? 1 : -1) * left_normal(direction);
      return Segment::arc(from + turn_radius * side, turn_radius, angle_of(-side), by);
    };
    return {Segment::line(forward ? link.a : moved(link.a, motion), in - tangent * ahead),
            turn(in - tangent * ahead, ahead, angle),
            Segment::line(in + tangent * turned, out - tangent * turned),
            turn(out - tangent * turned, turned, -angle),
            Segment::line(out + tangent * ahead, forward ? moved(link.b, motion) : link.b)};
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
  const RemovedByPeriod& removed_;
  std::vector<RepeatedPeriods>& patterns_;
  const ClearingParams& params_;
  double radius_;
  Undoing place_;
  std::optional<GroundSides> sides_;
  bool was_repeated_ = false, is_done_ = false;  // the period, the pattern
};

}  // namespace

std::optional<Unabridged> unabridge(std::vector<PlanarRun>& runs, const RemovedByPeriod& removed,
                                    const std::vector<SlotCut>& cuts,
                                    std::vector<RepeatedPeriods> patterns,
                                    const ClearingParams& params, std::vector<SlotPiece>& spared) {
  const std::size_t known = spared.size();
  for (const SlotCut& cut : cuts)
    if (std::none_of(patterns.begin(), patterns.end(),
                     [&](const RepeatedPeriods& pattern) { return passes(pattern, cut.place); }))
      for (const bool reversed : {false, true})
        spared.push_back({cut.from.stretch, cut.from.number, reversed});
  if (spared.size() > known) return std::nullopt;
  Unabridged added;
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut)
    if (!Undo(*cut, removed, patterns, params).run(runs, added)) {
      spared.push_back(cut->from);
      return std::nullopt;
    }
  return added;
}

}  // namespace evenload
