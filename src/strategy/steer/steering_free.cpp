// Free steps of Steering: arcs at whose ends the engagement is what it shall be.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cutting/load_budget.h"
#include "strategy/moves/move_checks.h"
#include "strategy/steer/steering.h"
#include "strategy/steer/steering_parts.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {

using namespace steering_parts;

namespace {

// Lengths as shares of the tool's radius, but those in mm.
constexpr double kSmallestStep = 0.004;
constexpr double kLargestStep = 4;
constexpr double kMostTurn = 1.5;  // rad, of a step
// Between two looks on the way; of exact steps.
constexpr double kLookStep = 0.15, kExactLookStep = 0.05;
constexpr double kBend = 3 * kDegree;       // turned more or less than the step before: more looks
constexpr double kSolved = 0.03 * kDegree;  // of the engagement at the end of a step
// Of the engagement on the way of a step: load_budget::kSmooth above the limit; so much below, and
// so much at the ends of steps on whose way it rises: no more than a share of the limit, and the
// less the longer the step, since it costs time over all of it; so much in a step as long as the
// tool's radius.
constexpr double kSlack = 2.5 * kDegree, kSlackShare = 1.0 / 24, kSlackPerLength = 1 * kDegree;
constexpr double kBias = 2.2 * kDegree, kBiasShare = 1.0 / 27, kBiasPerLength = 0.5 * kDegree;
// Share of the slack that exact steps have; they aim at the limit itself.
constexpr double kExactSlack = 0.1;
constexpr double kGrowth = 0.9, kLeastGrowth = 0.3, kMostGrowth = 2.5;  // of steps
// A share of the allowed error above which a step shrinks as much as it may at once.
constexpr double kHopeless = kGrowth * kGrowth / (kLeastGrowth * kLeastGrowth);
constexpr int kLongerTries = 2;
constexpr double kWorthLonger = 1.25;  // growth for which a step is tried again
// The engagement that the last step is taken to have ended with, from the limit.
constexpr double kLowestBegin = -3 * kDegree, kHighestBegin = 0.5 * kDegree;
// rad: where less is met than the limit less this, no peak between two looks is above it.
constexpr double kNearPeak = 6 * kDegree;
constexpr double kNearBorder = 0.01;  // mm: the finest step of the search for a wall

}  // namespace

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
  const auto outside = [&](Vec2 q) { return stage_.turns.signed_distance(q) < -kSame; };
  double t = 0;
  while (t < 1) {
    const BoundaryIndex::Hit hit = stage_.turns.nearest(turn_centre(t));
    const double next =
        std::min(1.0, t + std::max(hit.distance - kSame, std::min(kNearBorder, 0.3 * turn_)) /
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

// True where the step's end meets what it aimed at, not less.
bool Steering::is_steady(const Step& step) { return step.excess > -kSolved * 2; }

// By which a step could be longer, or must be shorter: the error grows with its square.
double Steering::growth_after(const Error& error) {
  return std::clamp(kGrowth / std::sqrt(std::max(error.share, 1e-9)), kLeastGrowth, kMostGrowth);
}

// What the end of a step of `length` mm aims at.
double Steering::target_of(double length) const {
  if (!rises_ || steps_ == Steps::kExact) return theta_;
  return theta_ - std::min({kBias, kBiasShare * theta_, kBiasPerLength * radius_ / length});
}

// By how much less than the limit may be met on the way of a step of `length` mm.
double Steering::slack_of(double length) const {
  return (steps_ == Steps::kExact ? kExactSlack : 1) *
         std::min({kSlack, kSlackShare * theta_, kSlackPerLength * radius_ / length});
}

// The curvature of the step of `length` mm from here at whose end the engagement is that aimed at,
// or as near to it as the bounds of the curvature allow.
Steering::Step Steering::solve(double length) const {
  const Pose from = pose();
  const double target = target_of(length);
  Contact end, end_at_high;
  const auto excess = [&](double curvature) {
    end = contact(end_of(move_of(from, curvature, length)));
    return end.steer - target;
  };
  // excess falls as the curvature grows: bracket and solve.
  // A step turns by so much at most that its end says what happens on the way.
  const double sharpest = 1 / turn_, rightmost = -1 / right_radius_;
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
      end_at_high = end;
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
    end = end_at_high;
  }
  Step step{move_of(from, curvature, length), end, curvature, value, target + value - theta_};
  step.held_back = (curvature >= most && most < sharpest && value > kSolved) ||
                   (curvature <= least && least > rightmost && value < -kSolved);
  return step;
}

// The error of the engagement on the way of a step, as a share of what is allowed; `first`: the
// contact where it begins. Where the limit
// can be held it is the bulge over the straight course from the step's beginning to its end; where
// less is met, only what lies above the limit. No more looks are taken once the share is above
// `enough`.
Steering::Error Steering::error_of(const Step& step, const Contact& first, double enough) const {
  const double length = step.move.length();
  const bool steady = is_steady(step);
  const double slack = slack_of(length);
  const double end = step.above;
  const double begin = std::clamp(first.steer - theta_, kLowestBegin, kHighestBegin);
  const bool bends = std::abs(step.curvature - curvature_) * length > kBend;
  const double spacing = (steps_ == Steps::kExact ? kExactLookStep : kLookStep) * radius_;
  const int looks =
      std::max(steady ? (bends ? 3 : 2) : 4, static_cast<int>(std::ceil(length / spacing)));
  Error error;
  const auto look = [&](double t) {
    const Contact here = contact(end_of(step.move.part(0, t)));
    const double above = here.steer - theta_, even = begin + t * (end - begin);
    const double bulge = above - even;
    double share = above / load_budget::kSmooth;
    if (steady && bulge > 0) share = std::max(share, bulge / (load_budget::kSmooth - even));
    if (share > error.share) error = {share, true};
    if (steady && -bulge / slack > error.share) error = {-bulge / slack, false};
    return Look{t, here};
  };
  thread_local std::vector<Look> taken;
  taken.assign(1, {0, first});
  for (int i = 1; i <= looks && error.share <= enough; ++i)
    taken.push_back(look(static_cast<double>(i) / (looks + 1)));
  taken.push_back({1, step.end});
  // Where the engagement falls on the way, or the front has a cusp, it may have risen before: looks
  // close in on the cusp from both sides.
  const auto may_rise_between = [&](const Look& a, const Look& b) {
    const double apart = (b.t - a.t) * length;
    if (apart <= kCuspWidth * theta_ * radius_) return false;
    if (steady) return !is_smooth_between(a.contact, b.contact, apart > kCuspLook * radius_);
    if (apart > kCuspLook * radius_) return true;
    const double most = std::max(a.contact.total, b.contact.total);
    return most > theta_ - kNearPeak && changes_between(a.contact, b.contact);
  };
  while (taken.size() > 1 && error.share <= enough) {
    const Look after = taken.back(), before = taken[taken.size() - 2];
    if (may_rise_between(before, after))
      taken.insert(taken.end() - 1, look(0.5 * (before.t + after.t)));
    else
      taken.pop_back();
  }
  return error;
}

// The step of step_ mm, or shorter where its end or its error asks for that. `error`: of the step.
// Nothing where even the smallest step would exceed the limit.
std::optional<Steering::Step> Steering::try_step(const Contact& first, Error* error) {
  const double smallest = std::min(kSmallestStep * radius_, 0.2 * turn_);
  for (;;) {
    const Step step = solve(step_);
    const bool can_shrink = step_ > smallest * 1.001;
    if (can_shrink && (step.held_back || step.above > load_budget::kStepEnd)) {
      step_ = std::max(smallest, 0.5 * step_);
      continue;
    }
    if (step.above > load_budget::kStepEnd) return std::nullopt;
    *error =
        error_of(step, first, can_shrink ? kHopeless : std::numeric_limits<double>::infinity());
    if (error->share <= 1 || !can_shrink) return step;
    step_ = std::max(smallest, growth_after(*error) * step_);
  }
}

// Fewer moves: a step about as long as will do, where that is worth it; else `step` itself.
Steering::Step Steering::longer_than(const Step& step, const Contact& first, Error* error) const {
  const double length = step.move.length();
  const double longest =
      std::min(kLargestStep * radius_, kMostTurn / std::max(1e-9, std::abs(step.curvature)));
  Step best = step;
  double good = 1, bad = longest / length * kWorthLonger;  // shares of `length`
  double next = std::min(growth_after(*error), longest / length);
  for (int i = 0; i < kLongerTries && next >= kWorthLonger * good && is_steady(best); ++i) {
    const Step longer = solve(next * length);
    Error its_error{2, false};
    if (!longer.held_back && longer.above <= load_budget::kStepEnd && is_steady(longer))
      its_error = error_of(longer, first, 1);
    if (its_error.share > 1) {
      bad = next;
    } else {
      best = longer;
      *error = its_error;
      good = next;
    }
    next = std::sqrt(good * bad);
  }
  return best;
}

void Steering::step_free() {
  Error error;
  const Contact first = contact(pose());
  const std::optional<Step> tried = try_step(first, &error);
  if (!tried) {
    overload();
    return;
  }
  const Step step = longer_than(*tried, first, &error);
  const double length = step.move.length(), share = reach_of(step.move);
  if (share < 1) {
    // So short a move would be turned by the rounding of a program: it begins further back.
    if (share * length < kShortestMove && pass_.moves.size() > free_from_ &&
        pass_.moves.back().length() > 4 * kShortestMove) {
      cut_back(2 * kShortestMove);
      return;
    }
    if (share * length > 1e-7) {
      const Segment part = step.move.part(0, share);
      make_step(part, contact(end_of(part)).total);
    }
    roll_out();
    return;
  }
  make_step(step.move, step.end.total);
  curvature_ = step.curvature;
  rises_ = error.rises;
  step_ = std::min(kLargestStep * radius_, growth_after(error) * length);
  if (idle() > (has_cut() ? kIdleAfterCut : kIdleBeforeCut) * radius_) mode_ = Mode::kEnd;
}

}  // namespace evenload
