#include "strategy/steering.h"

#include <algorithm>
#include <cmath>

#include "support/errors.h"

namespace evenload {
namespace {

constexpr double kDegree = kPi / 180;

// Lengths as shares of the tool's radius.
constexpr double kWallStep = 0.1;  // between two looks at the engagement along a wall
constexpr double kFinestWallStep =
    0.002;                          // the same along the exact border where the limit is passed
constexpr double kFirstStep = 0.2;  // of free steering; adapted from there
constexpr double kSmallestStep = 0.004;
constexpr double kLargestStep = 4;
constexpr double kMostTurn = 1.5;       // rad, of a step
constexpr double kLookStep = 0.25;      // between two looks on the way
constexpr double kCuspLook = 0.03;      // the same where the engagement cannot be held
constexpr double kIdleAfterCut = 0.2;   // without contact for this long: the pass is over
constexpr double kRunOut = 0.1;         // of which this much is kept
constexpr double kContactLook = 0.1;    // between two looks for the end of contact
constexpr double kContactEnd = 0.01;    // to which the end of contact within a step is found
constexpr double kIdleBeforeCut = 1.5;  // nothing met for this long: there is nothing
constexpr double kProgress =
    0.01;  // less than this between two overloads: the place cannot be entered

constexpr double kTurnStep = 10 * kDegree;    // between two looks along a turn
constexpr double kRollOutStep = 3 * kDegree;  // the same where a turn is made without a second look
constexpr double kWayOutStep = 2 * kDegree;   // between two looks on the way out of the material
constexpr double kNearlyOut = 3 * kDegree;    // of engagement
constexpr double kBend = 3 * kDegree;       // turned more or less than the step before: more looks
constexpr double kSolved = 0.03 * kDegree;  // of the engagement at the end of a step
// Of the engagement on the way of a step: so much above its target, and so much below, but no more
// than a share of the target.
constexpr double kSmooth = 0.9 * kDegree;
constexpr double kSlack = 2.5 * kDegree, kSlackShare = 1.0 / 24;
constexpr double kBias = 0.8 * kDegree, kBiasShare = 1.0 / 75;
constexpr double kGrowth = 0.9, kLeastGrowth = 0.3, kMostGrowth = 2.5;  // of steps
constexpr double kMeanLength = 0.1;   // mm of path over which engagement is a mean
constexpr double kRunUpStep = 0.025;  // mm: between two looks on the way back to a start
constexpr double kCornerShare =
    0.7;  // of the limit for that mean: rounded G-code meets more in a corner
constexpr double kSharp = 0.02;  // of unit vectors along the wall on both sides of a corner
constexpr double kOverload = 0.25 * kDegree;  // accepted above the limit before the path is changed
constexpr double kInContact = 0.06 * kDegree;  // less counts as no contact
// mm: material thinner than this is not seen; what has been cut must not be found again by
// rounding.
constexpr double kThin = 1e-6;
// mm: a pose this near to the tool's present place is that place.
constexpr double kHere = 1e-9;
constexpr double kOutside = 1e-6;     // mm beyond the border that still counts as on it
constexpr double kNearBorder = 0.01;  // mm: the finest step of the search for a wall

Segment move_of(const Pose& from, double curvature, double length) {
  if (std::abs(curvature) * length < 1e-9)
    return Segment::line(from.p, from.p + length * unit(from.heading));
  const double radius = 1 / std::abs(curvature), side = curvature > 0 ? 1 : -1;
  const Vec2 centre = from.p + side * radius * left_normal(unit(from.heading));
  return Segment::arc(centre, radius, from.heading - side * kPi / 2, curvature * length);
}

Pose end_of(const Segment& move) { return {move.b, angle_of(move.tangent(1))}; }

bool continues(const Segment& a, const Segment& b) {
  if (a.is_arc() != b.is_arc()) return false;
  if (!a.is_arc()) return norm(a.tangent(1) - b.tangent(0)) < 1e-9;
  return distance(a.centre, b.centre) < 1e-9 && std::abs(a.radius - b.radius) < 1e-9 &&
         (a.sweep > 0) == (b.sweep > 0) && std::abs(a.sweep + b.sweep) < kPi;
}

Segment joined(const Segment& a, const Segment& b) {
  return a.is_arc() ? Segment::arc(a.centre, a.radius, a.start_angle, a.sweep + b.sweep)
                    : Segment::line(a.a, b.b);
}

}  // namespace

Steering::Steering(ClearedGround& ground, const Stage& stage, double engagement,
                   double right_radius)
    : ground_(ground),
      stage_(stage),
      theta_(engagement),
      radius_(ground.tool_radius()),
      turn_(stage.turn_radius),
      right_radius_(right_radius) {}

Steering::Contact Steering::contact(const Pose& at) const {
  const double right = at.heading - kPi / 2;
  // Where the tool stands its own last move, which ends here, must not hide what lies ahead.
  const bool here = !pass_.moves.empty() && distance(at.p, pass_.moves.back().b) < kHere;
  ground_.uncovered(at.p, right, right + kPi, scratch_, kThin,
                    here ? ground_.size() - 1 : ground_.size());
  Contact result;
  double widest = 0;
  for (const AngularInterval& piece : scratch_) {
    result.total += piece.width();
    if (piece.width() > widest) {
      widest = piece.width();
      result.steer = piece.high - right;
      result.edge = at.p + (radius_ - kThin) * unit(piece.high);
    }
  }
  result.steer = std::max(result.steer, result.total);
  return result;
}

// True where the engagement cannot peak between two places beside each other: the front has no cusp
// there, at which it would.
bool Steering::is_smooth_between(const Contact& a, const Contact& b) const {
  if (a.total <= kInContact || b.total <= kInContact) return true;
  return ground_.is_smooth_between(a.edge, b.edge);
}

Pose Steering::pose() const { return pass_.moves.empty() ? start_ : end_of(pass_.moves.back()); }

void Steering::append(const Segment& move) {
  const double length = move.length();
  if (length < 1e-9) return;
  travelled_ += length;
  if (!pass_.moves.empty() && continues(pass_.moves.back(), move)) {
    pass_.moves.back() = joined(pass_.moves.back(), move);
    ground_.remove_last();
  } else {
    pass_.moves.push_back(move);
  }
  ground_.add(pass_.moves.back());
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
  while (!met_.empty() && met_.back().until > travelled_ + kHere) met_.pop_back();
}

// rad engaged before the last `length` mm of the path; 0 where that was nothing.
double Steering::met_before(double length) const {
  return has_cut() && met_.back().until > travelled_ - length - kHere ? met_.back().total : 0;
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
    if (i > 0 ? !touches(low) : !has_cut() || idle() > kHere) continue;
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
  int falling = 0;
  for (double turned = kTurnStep; turned < kPi; turned += kTurnStep) {
    const double value = at(turned);
    if (value > best) {
      best = value;
      best_turned = turned;
    }
    falling = value < last ? falling + 1 : 0;
    last = value;
    if (best > theta_ + 5 * kDegree) break;  // too much anyway
    if (part == TurnPart::kFirstPeak && falling >= 2 && best > 10 * kDegree)
      break;  // past the peak
    if (best > kInContact && value <= kInContact) break;
  }
  // Refine the peak where it decides.
  if (best > theta_ - 5 * kDegree && best < theta_ + 5 * kDegree) {
    for (double width = kTurnStep / 2; width > 0.5 * kDegree; width /= 2)
      for (const double turned : {best_turned - width, best_turned + width}) {
        if (turned < 0) continue;
        const double value = at(turned);
        if (value > best) {
          best = value;
          best_turned = turned;
        }
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
  while (peak > theta_ + kOverload) {
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
      if (value <= theta_ + kOverload) {
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

void Steering::step_on_wall() {
  const Curve& curve = stage_.centres.curves()[wall_.curve];
  const Segment wall = curve.segment(wall_.segment);
  const double length = wall.length();
  double step = kWallStep * radius_;
  if (wall.is_arc()) step = std::min(step, kTurnStep * wall.radius);
  const double left = (1 - wall_.t) * length;
  if (left < 1e-9) {
    wall_ = {wall_.curve, (wall_.segment + 1) % curve.segment_count(), 0};
    return;
  }
  step = std::min(step, left);
  double t1 = step >= left - 1e-12 ? 1.0 : wall_.t + step / length;
  const auto contact_at = [&](double t) {
    return contact({wall.point(t), angle_of(wall.tangent(t))});
  };
  const auto engagement_at = [&](double t) { return contact_at(t).total; };
  const Contact end = contact_at(t1);
  double total = end.total;
  if (step > kCuspLook * radius_ && !is_smooth_between(contact_at(wall_.t), end)) {
    step = kCuspLook * radius_;
    t1 = wall_.t + step / length;
    total = engagement_at(t1);
  }
  while (turn_ <= 0 && (total > theta_ || over_mean(total, step)) &&
         step > kFinestWallStep * radius_) {
    step *= 0.5;
    t1 = wall_.t + step / length;
    total = engagement_at(t1);
  }
  if (turn_ > 0 && total > theta_ + 0.2 * kOverload) {
    double low = wall_.t, high = t1;
    while ((high - low) * length > 1e-3 * radius_) {
      const double middle = 0.5 * (low + high);
      (engagement_at(middle) > theta_ ? high : low) = middle;
    }
    if (low > wall_.t) {
      append(wall.part(wall_.t, low));
      note_contact(engagement_at(low), (low - wall_.t) * length);
    }
    wall_.t = low;
    if (may_leave_wall_)
      overload();
    else
      give_up();
    return;
  }
  if (turn_ <= 0 && over_mean(total, step)) {
    // The little that is left in a sharp corner is taken bit by bit; elsewhere the tool would stand
    // in the middle of a front.
    if (may_leave_wall_ && (bit_by_bit_ || near_corner(step)))
      mode_ = Mode::kEnd;
    else
      give_up();
    return;
  }
  make_step(wall.part(wall_.t, t1), total);
  wall_.t = t1;
  if (idle() > (has_cut() ? kIdleAfterCut : kIdleBeforeCut) * radius_) mode_ = Mode::kEnd;
}

// True where the wall turns sharply within kMeanLength mm of the step of `step` mm.
bool Steering::near_corner(double step) const {
  const Curve& curve = stage_.centres.curves()[wall_.curve];
  const std::size_t n = curve.segment_count();
  const Segment wall = curve.segment(wall_.segment);
  const double done = wall_.t * wall.length(), left = wall.length() - done - step;
  if (wall.length() < kMeanLength) return true;
  const auto is_sharp = [&](std::size_t before, std::size_t after) {
    return norm(curve.segment(before).tangent(1) - curve.segment(after).tangent(0)) > kSharp;
  };
  return (done < kMeanLength && is_sharp((wall_.segment + n - 1) % n, wall_.segment)) ||
         (left < kMeanLength && is_sharp(wall_.segment, (wall_.segment + 1) % n));
}

// Along the exact border nothing can be steered: true where `total` rad over the next `step` mm
// would lift the mean engagement over the last kMeanLength mm above the limit, or above
// kCornerShare of it near a sharp corner.
bool Steering::over_mean(double total, double step) const {
  double sum = total * std::min(step, kMeanLength);
  const double from = travelled_ + step - kMeanLength;
  for (auto met = met_.rbegin(); met != met_.rend() && met->until > from; ++met)
    sum += met->total * (met->until - std::max(from, met->until - met->length));
  return sum > (bit_by_bit_ || near_corner(step) ? kCornerShare : 1) * theta_ * kMeanLength;
}

// The share of `move` that can be made before the centre of the left turn meets the border of its
// place.
double Steering::reach_of(const Segment& move) const {
  const double length = move.length();
  const auto turn_centre = [&](double t) {
    return move.point(t) + turn_ * left_normal(move.tangent(t));
  };
  // The centre moves at most this much faster than the tool, so that a step as long as the distance
  // is safe.
  const double speed = std::max(1e-9, std::abs(1 - move.curvature() * turn_));
  const auto outside = [&](Vec2 q) { return stage_.turns.signed_distance(q) < -kOutside; };
  double t = 0;
  while (t < 1) {
    const BoundaryIndex::Hit hit = stage_.turns.nearest(turn_centre(t));
    const double next =
        std::min(1.0, t + std::max(hit.distance - kOutside, std::min(kNearBorder, 0.3 * turn_)) /
                              (speed * length));
    const Vec2 q = turn_centre(next);
    if (outside(q)) {
      double low = t, high = next;
      while ((high - low) * length > 1e-7) {
        const double middle = 0.5 * (low + high);
        (outside(turn_centre(middle)) ? high : low) = middle;
      }
      return low;
    }
    t = next;
  }
  return 1;
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

void Steering::step_free() {
  const Pose from = pose();
  const Contact begin = contact(from);
  const double sharpest = 1 / turn_, rightmost = -1 / right_radius_;
  const double smallest_step = std::min(kSmallestStep * radius_, 0.2 * turn_);
  // Where the engagement rises on the way of a step, the ends lie a little below the limit.
  const double target = theta_ - (rises_ ? std::min(kBias, kBiasShare * theta_) : 0);
  for (;;) {
    const double length = step_;
    const auto excess = [&](double curvature) {
      return contact(end_of(move_of(from, curvature, length))).steer - target;
    };
    // excess falls as the curvature grows: bracket and solve.
    // A step turns by so much at most that its end says what happens on the way.
    const double least = std::max(rightmost, -kMostTurn / length),
                 most = std::min(sharpest, kMostTurn / length);
    double low = least, high = most, curvature = std::clamp(curvature_, low, high);
    double value = excess(curvature);
    double low_value = 1, high_value = -1;  // signs only, until known
    bool low_known = false, high_known = false;
    const double slope = -(length + length * length / (2 * radius_ * std::sin(theta_)));
    for (int i = 0; i < 40 && std::abs(value) > kSolved; ++i) {
      if (value > 0) {
        low = curvature;
        low_value = value;
        low_known = true;
      } else {
        high = curvature;
        high_value = value;
        high_known = true;
      }
      if ((low_known && low >= most) || (high_known && high <= least)) break;
      if (low_known && high_known && high - low < 1e-7) break;
      double next = curvature - value / slope;
      if (low_known && high_known) {
        if (i > 4)
          next = 0.5 * (low + high);
        else if (i > 1)
          next = low + (high - low) * low_value / (low_value - high_value);
      }
      if (low_known && next <= low) next = high_known ? 0.5 * (low + high) : most;
      if (high_known && next >= high) next = low_known ? 0.5 * (low + high) : least;
      curvature = std::clamp(next, least, most);
      value = excess(curvature);
    }
    if (value > kSolved && high_known) {  // a jump: stay on the side that cuts less
      curvature = high;
      value = high_value;
    }
    const bool smallest = length <= smallest_step * 1.001;
    const bool held_back = (curvature >= most && most < sharpest && value > kSolved) ||
                           (curvature <= least && least > rightmost && value < -kSolved);
    if (held_back && !smallest) {
      step_ = std::max(smallest_step, 0.5 * length);
      continue;
    }
    if (value > kOverload) {
      if (!smallest) {
        step_ = std::max(smallest_step, 0.5 * length);
        continue;
      }
      overload();
      return;
    }
    const Segment move = move_of(from, curvature, length);
    const bool steady = value > -kSolved * 2;
    double error = 0;  // as a share of what is allowed
    bool rises = false;
    const double slack = std::min(kSlack, kSlackShare * theta_);
    const Contact end = contact(end_of(move));
    // Where the engagement falls on the way, or the front has a cusp, it may have risen before.
    const bool smooth = steady && is_smooth_between(begin, end);
    const double between = (smooth ? kLookStep : kCuspLook) * radius_;
    const int along = static_cast<int>(std::ceil(length / between));
    const bool bends = std::abs(curvature - curvature_) * length > kBend;
    const int looks = std::max(steady ? (bends ? 3 : 2) : 4, along);
    for (int i = 1; i <= looks; ++i) {
      const double t = static_cast<double>(i) / (looks + 1);
      const double above = contact(end_of(move.part(0, t))).steer - theta_;
      if (steady && -above / slack > error) {
        error = -above / slack;
        rises = false;
      }
      if (above / kSmooth > error) {
        error = above / kSmooth;
        rises = true;
      }
    }
    // The error grows with the square of the step.
    const double growth =
        std::clamp(kGrowth / std::sqrt(std::max(error, 1e-9)), kLeastGrowth, kMostGrowth);
    if (error > 1 && !smallest) {
      step_ = std::max(smallest_step, growth * length);
      continue;
    }
    const double share = reach_of(move);
    if (share < 1) {
      if (share * length > 1e-7) {
        const Segment part = move.part(0, share);
        make_step(part, contact(end_of(part)).total);
      }
      roll_out();
      return;
    }
    make_step(move, end.total);
    curvature_ = curvature;
    rises_ = rises;
    step_ = std::min(kLargestStep * radius_, growth * length);
    if (idle() > (has_cut() ? kIdleAfterCut : kIdleBeforeCut) * radius_) mode_ = Mode::kEnd;
    return;
  }
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
    if (total > theta_ + kOverload) {
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
  wall_ = {wall.curve, wall.segment, wall.t};
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
  met_.clear();
  trouble_at_ = -1;
  troubles_ = 0;
  step_ = kFirstStep * radius_;
  curvature_ = 0;
  rises_ = false;
}

// Where a pass along the exact border ended in the middle of a front the next one would begin
// there, and the mean engagement count anew. So it begins kMeanLength mm before `start`, or as far
// back as the tool is clear, unless nothing is met at once.
WallPlace Steering::run_up(const WallPlace& start) const {
  const Curve& curve = stage_.centres.curves()[start.curve];
  const std::size_t n = curve.segment_count();
  const Segment first = curve.segment(start.segment);
  const double ahead = start.t + kFinestWallStep * radius_ / first.length();
  if (ahead < 1 &&
      contact({first.point(ahead), angle_of(first.tangent(ahead))}).total <= kInContact)
    return start;
  WallPlace place = start;
  for (double left = kMeanLength; left > kHere;) {
    WallPlace back = place;
    if (back.t <= 0) back = {back.curve, (back.segment + n - 1) % n, 1};
    const Segment wall = curve.segment(back.segment);
    const double step = std::min({left, kRunUpStep, back.t * wall.length()});
    back.t = std::max(0.0, back.t - std::max(step, kHere) / wall.length());
    if (!ground_.is_clear(wall.point(back.t))) break;
    place = back;
    left -= std::max(step, kHere);
  }
  return place;
}

Pass Steering::from_wall(const WallPlace& start) {
  wall_ = turn_ > 0 ? start : run_up(start);
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
  return run();
}

}  // namespace evenload
