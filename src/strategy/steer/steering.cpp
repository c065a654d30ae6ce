#include "strategy/steer/steering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cutting/load_budget.h"
#include "strategy/moves/move_ends.h"
#include "strategy/steer/steering_parts.h"
#include "support/errors.h"
#include "support/tolerances.h"

namespace evenload {

using namespace steering_parts;

namespace {

// Lengths as shares of the tool's radius.
constexpr double kFirstStep = 0.2;     // of free steering; adapted from there
constexpr double kRunOut = 0.1;        // kept of what comes after contact
constexpr double kContactLook = 0.05;  // between two looks for the end of contact
constexpr double kContactEnd = 0.01;   // to which the end of contact within a step is found
// Steps along a wall become one move up to here: what is cut back is learnt anew as a whole.
constexpr double kLongestJoined = 8;
// Less than this since the furthest overload: the place cannot be entered.
constexpr double kProgress = 0.01;

constexpr double kRollOutStep = 3 * kDegree;  // between two looks along a turn made at once
constexpr int kPeakLooks = 3;                 // for a peak between two looks along such a turn
// Shares of the step on which contact begins: further looks, for a peak where a front is met
// head-on.
constexpr double kHeadOnShares[] = {0.05, 0.2, 0.5};
constexpr double kWayOutStep = 2 * kDegree;  // between two looks on the way out of the material
constexpr double kNearlyOut = 3 * kDegree;   // of engagement

// rad: material that is thinner than a cut is kept by so much on the right of the feed.
constexpr double kOnRight = 5 * kDegree;
// rad: less than this is thin stuff on either side.
constexpr double kLeastLeaning = kDegree;

}  // namespace

Steering::Steering(ClearedGround& ground, const Stage& stage, double engagement,
                   double right_radius, Steps steps)
    : ground_(ground),
      stage_(stage),
      theta_(engagement),
      radius_(ground.tool_radius()),
      turn_(stage.turn_radius),
      right_radius_(right_radius),
      steps_(steps) {}

Steering::Contact Steering::contact(const Pose& at) const {
  const double right = at.heading - kPi / 2;
  // Where the tool stands its own last move, which ends here, must not hide what lies ahead.
  const bool here = !pass_.moves.empty() && distance(at.p, pass_.moves.back().b) < kRounding;
  const std::vector<AngularInterval>& arcs =
      probe_.arcs(at.p, at.heading, kThin, here ? ground_.size() - 1 : Probe::kNow);
  Contact result;
  double widest = 0, towards_left = 0, beside = 0;
  for (const AngularInterval& piece : arcs) {
    result.total += piece.width();
    towards_left += piece.width() * (0.5 * (piece.low + piece.high) - at.heading);
    if (piece.width() > widest) {
      widest = piece.width();
      result.steer = piece.high - right;
      beside = piece.low - right;
      result.edge = at.p + (radius_ - kThin) * unit(piece.high);
    }
  }
  // Thin material with nothing beside it on the right could have its far end there and lie on the
  // left, where the limit is beyond a right angle: its middle stays on the right.
  if (theta_ > kPi / 2) result.steer += std::max(0.0, beside - (kPi - theta_) + kOnRight);
  result.on_right = result.total > kInContact && beside < kRounding;
  result.steer = std::max(result.steer, result.total);
  result.leans_left = towards_left > 0 && result.total > kLeastLeaning;
  return result;
}

// True where the engagement does not peak between two places beside each other, as it would at a
// cusp of the front. Where contact begins or ends on the way it is less than at the other place.
// `apart`: they are not next to each other.
bool Steering::is_smooth_between(const Contact& a, const Contact& b, bool apart) const {
  if (a.total <= kInContact || b.total <= kInContact) return true;
  const bool has_moved = !pass_.moves.empty();
  return ground_.is_smooth_between(
      a.edge, b.edge, ground_.size() - (has_moved ? 1 : 0),
      apart ? kMostTurnOfFront : std::numeric_limits<double>::infinity());
}

Pose Steering::pose() const { return pass_.moves.empty() ? start_ : end_of(pass_.moves.back()); }

void Steering::append(const Segment& move) {
  const double length = move.length();
  if (length < 1e-9) return;
  travelled_ += length;
  const bool joins = !pass_.moves.empty() && continues(pass_.moves.back(), move) &&
                     pass_.moves.back().length() < kLongestJoined * radius_;
  if (joins) {
    pass_.moves.back() = joined(pass_.moves.back(), move);
    ground_.extend_last(pass_.moves.back(), move);
  } else {
    pass_.moves.push_back(move);
    ground_.add(move);
  }
}

void Steering::cut_back(double length) {
  while (length > 1e-12 && !pass_.moves.empty()) {
    const Segment last = pass_.moves.back();
    const double whole = last.length();
    pass_.moves.pop_back();
    ground_.remove_last();
    if (whole <= length + 1e-9) {
      travelled_ -= whole;
      length -= whole;
    } else {
      pass_.moves.push_back(last.part(0, 1 - length / whole));
      ground_.add(pass_.moves.back());
      travelled_ -= length;
      length = 0;
    }
  }
  if (pass_.moves.empty()) travelled_ = 0;
  while (!met_.empty() && met_.back().until > travelled_ + kRounding) {
    Met& last = met_.back();
    const double left = travelled_ - (last.until - last.length);
    if (left <= kRounding) {
      met_.pop_back();
      continue;
    }
    last.total = last.from + left / last.length * (last.total - last.from);
    last.until = travelled_;
    last.length = left;
  }
}

// rad engaged before the last `length` mm of the path; 0 where that was nothing.
double Steering::met_before(double length) const {
  return has_cut() && met_.back().until > travelled_ - length - kRounding ? met_.back().total : 0;
}

// True where all of the last `length` mm of the path met material.
bool Steering::was_met_for(double length) const {
  double from = travelled_;
  for (auto met = met_.rbegin(); met != met_.rend() && met->until > from - kRounding; ++met) {
    from = met->until - met->length;
    if (travelled_ - from >= length) return true;
  }
  return false;
}

// Says that the last `length` mm of the path met `total` rad of material.
void Steering::note_contact(double total, double length) {
  if (total > kInContact) met_.push_back({travelled_, length, met_before(length), total});
}

// The share of the next move, which ends without contact, up to which there is contact; 0 where
// there is none.
double Steering::contact_until(const Segment& move) const {
  const auto touches = [&](double t) {
    return contact(end_of(move.part(0, t))).total > kInContact;
  };
  const int n = static_cast<int>(std::ceil(move.length() / (kContactLook * radius_)));
  for (int i = n - 1; i >= 0; --i) {
    double low = static_cast<double>(i) / n, high = static_cast<double>(i + 1) / n;
    if (i > 0 ? !touches(low) : !has_cut() || idle() > kRounding) continue;
    // Never all of the move, or contact would seem to go on in steps however short.
    while (high - low > std::min(0.1, kContactEnd * radius_ / move.length())) {
      const double middle = 0.5 * (low + high);
      (touches(middle) ? low : high) = middle;
    }
    return high;
  }
  return 0;
}

// Makes a step at whose end `total` rad are engaged, and notes what it meets, also where contact
// ends on the way.
void Steering::make_step(const Segment& move, double total) {
  const double length = move.length(), touched = total > kInContact ? 0 : contact_until(move);
  append(move);
  if (total > kInContact)
    note_contact(total, length);
  else if (touched > 0)
    met_.push_back(
        {travelled_ - (1 - touched) * length, touched * length, met_before(length), kInContact});
}

// The highest engagement on the left turn from `from`, up to where it has passed its first peak, or
// on the whole way out of the material; `angle`: turned at the peak.
double Steering::peak_of_left_turn(const Pose& from, TurnPart part, double* angle) const {
  const Vec2 centre = from.p + turn_ * left_normal(unit(from.heading));
  const auto at = [&](double turned) {
    const double heading = from.heading + turned;
    return contact({centre - turn_ * left_normal(unit(heading)), heading}).total;
  };
  double best = at(0), best_turned = 0, last = best;
  const auto look = [&](double turned) {
    const double value = at(turned);
    if (value > best) {
      best = value;
      best_turned = turned;
    }
    return value;
  };
  thread_local std::vector<double> met;
  met.assign(1, best);
  int falling = 0;
  for (double turned = kTurnStep; turned < kPi; turned += kTurnStep) {
    const double value = look(turned);
    if (last <= kInContact && value > kInContact)  // met head-on a front is there at once
      for (const double share : kHeadOnShares) look(turned - (1 - share) * kTurnStep);
    met.push_back(value);
    falling = value < last ? falling + 1 : 0;
    last = value;
    if (best > theta_ + 5 * kDegree) break;  // too much anyway
    if (part == TurnPart::kFirstPeak && falling >= 2 && best > 10 * kDegree)
      break;  // past the peak
    if (best > kInContact && value <= kInContact) break;
  }
  // Another front that is touched on the way lets it rise and fall from one look to the next. As it
  // falls from there on, so it has fallen before.
  for (std::size_t i = 1; i + 2 < met.size() && best <= theta_ + load_budget::kStepEnd; ++i) {
    const double highest = 2 * met[i + 1] - met[i + 2];
    if (highest <= theta_ + load_budget::kStepEnd || highest <= met[i]) continue;
    double low = static_cast<double>(i), high = low + 1;
    for (int k = 0; k < kPeakLooks; ++k) {
      const double middle = 0.5 * (low + high);
      (look(middle * kTurnStep) < met[i + 1] ? low : high) = middle;
    }
  }
  // Refine the peak where it decides.
  if (best > theta_ - 5 * kDegree && best < theta_ + 5 * kDegree) {
    for (double width = kTurnStep / 2; width > 0.5 * kDegree; width /= 2) {
      const double middle = best_turned;
      for (const double turned : {middle - width, middle + width})
        if (turned >= 0) look(turned);
    }
  }
  if (angle) *angle = best_turned;
  return best;
}

// Takes the path back to where a left turn can still stay within the limit, and makes that turn up
// to its peak.
bool Steering::roll_in(TurnPart part) {
  if (turn_ <= 0) return false;
  double turned = 0, peak = peak_of_left_turn(pose(), part, &turned);
  double delta = 0.05 * turn_;
  Segment piece;
  bool cut = false;
  while (peak > theta_ + load_budget::kStepEnd) {
    if (travelled_ <= 1e-9) return false;
    const Segment last = pass_.moves.back();
    const double whole = last.length(), take = std::min(delta, whole);
    piece = last.part(std::max(0.0, 1 - take / whole), 1);
    cut_back(take);
    cut = true;
    delta *= 1.6;
    peak = peak_of_left_turn(pose(), part, &turned);
  }
  if (cut) {
    double low = 0, high = 1;
    const double length = piece.length();
    while ((high - low) * length > 2e-3 * turn_) {
      const double middle = 0.5 * (low + high);
      const double share = middle - low;
      const Segment more = piece.part(low, low + share);
      append(more);
      double angle = 0;
      const double value = peak_of_left_turn(pose(), part, &angle);
      if (value <= theta_ + load_budget::kStepEnd) {
        note_contact(contact(pose()).total, more.length());
        low = middle;
        turned = angle;
        peak = value;
      } else {
        cut_back(more.length());
        high = middle;
      }
    }
  }
  if (turned > 1e-6) {
    append(move_of(pose(), 1 / turn_, turned * turn_));
    note_contact(peak, turned * turn_);
  }
  mode_ = Mode::kFree;
  free_from_ = pass_.moves.size();
  step_ = kFirstStep * radius_;
  curvature_ = 1 / turn_;
  return true;
}

// Ends the pass by a left turn out of the material, from the last place where that is possible
// within the limit.
void Steering::escape() {
  if (roll_in(TurnPart::kWayOut)) {
    // Where contact all but ends and grows again, the turn ends as well.
    double lowest = kPi;
    double since = 0;  // mm
    double total = contact(pose()).total;
    for (double turned = 0; turned < kPi && total > kInContact; turned += kWayOutStep) {
      append(move_of(pose(), 1 / turn_, kWayOutStep * turn_));
      note_contact(total, kWayOutStep * turn_);
      total = contact(pose()).total;
      since = total < lowest ? 0 : since + kWayOutStep * turn_;
      lowest = std::min(lowest, total);
      if (lowest < kNearlyOut && total > lowest + kNearlyOut) {
        cut_back(since);
        break;
      }
    }
  } else if (turn_ > 0) {
    cut_back(travelled_);
  }
  mode_ = Mode::kEnd;
}

void Steering::overload() {
  // No way on since the furthest overload: whatever lies here is left to a tighter turn.
  if (trouble_at_ >= 0 && travelled_ - trouble_at_ < kProgress * radius_) {
    if (++troubles_ > 3) {
      escape();
      return;
    }
  } else {
    troubles_ = 0;
  }
  trouble_at_ = std::max(trouble_at_, travelled_);
  if (!roll_in(troubles_ > 0 ? TurnPart::kWayOut : TurnPart::kFirstPeak)) escape();
}

// Turns left about the present turn centre, which stands on its border, until the tool runs along
// the wall.
void Steering::roll_out() {
  const Pose from = pose();
  const Vec2 centre = from.p + turn_ * left_normal(unit(from.heading));
  const BoundaryIndex::Hit hit = stage_.turns.nearest(centre);
  const Vec2 along = stage_.turns.segment_at(hit).tangent(hit.t);
  double turned = wrap_signed(angle_of(along) - from.heading);
  if (turned < 0) turned = turned < -kPi / 2 ? turned + 2 * kPi : 0;
  const int looks = static_cast<int>(std::ceil(turned / kRollOutStep));
  double sum = 0, in_contact = 0;  // rad engaged, rad turned
  for (int i = 1; i <= looks; ++i) {
    const double heading = from.heading + turned * i / looks;
    const double total = contact({centre - turn_ * left_normal(unit(heading)), heading}).total;
    if (total > theta_ + load_budget::kStepEnd) {
      overload();
      return;
    }
    sum += total;
    if (total > kInContact) in_contact = turned * i / looks;
  }
  if (turned > 1e-9) {
    append(move_of(from, 1 / turn_, turned * turn_));
    if (in_contact > 0) {
      const double mean = sum / looks * turned / in_contact;
      met_.push_back({travelled_ - (turned - in_contact) * turn_, in_contact * turn_, mean, mean});
    }
  }
  const BoundaryIndex::Hit wall = stage_.centres.nearest(pose().p);
  EVENLOAD_ASSERT(wall.distance < 1e-3);
  go_to_wall({wall.curve, wall.segment, wall.t});
  mode_ = Mode::kWall;
}

void Steering::give_up() {
  cut_back(travelled_);
  mode_ = Mode::kEnd;
}

Pass Steering::run() {
  while (mode_ != Mode::kEnd) {
    if (mode_ == Mode::kWall)
      step_on_wall();
    else
      step_free();
  }
  // However long the last step was, the same run-out is kept.
  cut_back(has_cut() ? std::max(0.0, idle() - kRunOut * radius_) : travelled_);
  if (has_cut()) {
    pass_.idle_before = met_.front().until - met_.front().length;
    pass_.idle_after = idle();
  }
  for (const Met& met : met_) {
    pass_.cut_length += met.length;
    pass_.cut_area += met.length * radius_ * (1 - 0.5 * (std::cos(met.from) + std::cos(met.total)));
  }
  return std::move(pass_);
}

void Steering::reset(const Pose& start) {
  pass_ = {};
  start_ = start;
  travelled_ = 0;
  on_left_ = 0;
  met_.clear();
  trouble_at_ = -1;
  troubles_ = 0;
  step_ = kFirstStep * radius_;
  curvature_ = 0;
  rises_ = false;
}

Pass Steering::from_wall(const WallPlace& start) {
  go_to_wall(turn_ > 0 ? start : run_up(start));
  const Segment wall = stage_.centres.curves()[wall_.curve].segment(wall_.segment);
  reset({wall.point(wall_.t), angle_of(wall.tangent(wall_.t))});
  mode_ = Mode::kWall;
  return run();
}

Pass Steering::bit_by_bit(const WallPlace& start) {
  bit_by_bit_ = true;
  Pass pass = from_wall(start);
  bit_by_bit_ = false;
  return pass;
}

Pass Steering::along_wall(const WallPlace& start) {
  may_leave_wall_ = false;
  Pass pass = from_wall(start);
  may_leave_wall_ = true;
  return pass;
}

Pass Steering::from_pose(const Pose& start) {
  EVENLOAD_ASSERT(turn_ > 0);
  reset(start);
  mode_ = Mode::kFree;
  free_from_ = 0;
  return run();
}

}  // namespace evenload
