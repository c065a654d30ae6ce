// Steering along walls, and along the exact border.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cutting/load_budget.h"
#include "strategy/moves/move_checks.h"
#include "strategy/steer/steering.h"
#include "strategy/steer/steering_parts.h"
#include "support/tolerances.h"

namespace evenload {

using namespace steering_parts;

namespace {

// Lengths as shares of the tool's radius.
constexpr double kWallStep = 0.1;  // between two looks at the engagement along a wall
// The same along the exact border where the limit is passed.
constexpr double kFinestWallStep = 0.002;
constexpr double kMostOnLeft = 0.1;   // along a wall with more material on the left than there
constexpr double kRunUpStep = 0.025;  // mm: between two looks on the way back to a start
// Of the limit for that mean: rounded G-code meets more in a corner.
constexpr double kCornerShare = 0.7;
// Looks between two where contact begins; rad: where a peak comes as near to the limit its place is
// found exactly.
constexpr int kHeadOnLooks = 4;
constexpr double kNearLimit = 5 * kDegree;
// Share of the limit, and rad: by so much a peak between two looks may exceed both.
constexpr double kLowShare = 0.25;
constexpr double kHighestPeak = 6 * kDegree;
constexpr double kSharp = 0.02;  // of unit vectors along the wall on both sides of a corner

}  // namespace

void Steering::go_to_wall(const WallPlace& place) {
  wall_ = place;
  rough_until_ = 0;
  met_here_.reset();
}

void Steering::step_on_wall() {
  const Curve& curve = stage_.centres.curves()[wall_.curve];
  const Segment wall = curve.segment(wall_.segment);
  const double length = wall.length();
  double step = kWallStep * radius_;
  if (wall.is_arc()) step = std::min(step, kTurnStep * wall.radius);
  const double left = (1 - wall_.t) * length;
  if (left < 1e-9) {
    go_to_wall({wall_.curve, (wall_.segment + 1) % curve.segment_count(), 0});
    return;
  }
  step = std::min(step, left);
  double t1 = step >= left - 1e-12 ? 1.0 : wall_.t + step / length;
  const auto contact_at = [&](double t) {
    return contact({wall.point(t), angle_of(wall.tangent(t))});
  };
  // Short of a cusp that was found ahead steps are short.
  const double fine = kCuspLook * radius_;
  const bool before_cusp = wall_.t * length < rough_until_ - kRounding;
  if (before_cusp && step > fine) {
    step = std::min(fine, rough_until_ - wall_.t * length);
    t1 = wall_.t + step / length;
  }
  Contact end = contact_at(t1);
  if (before_cusp || step > fine) {
    const Contact here = met_here_ ? *met_here_ : contact_at(wall_.t);
    bool is_smooth = !may_peak_between(here, end);
    if (!is_smooth && step > fine) {
      rough_until_ = t1 * length;
      step = fine;
      t1 = wall_.t + step / length;
      end = contact_at(t1);
      is_smooth = !may_peak_between(here, end);
    }
    if (!is_smooth && turn_ > 0)
      if (const std::optional<double> cusp = cusp_between(wall, {wall_.t, here}, {t1, end})) {
        t1 = *cusp;
        step = (t1 - wall_.t) * length;
        end = contact_at(t1);
      }
  }
  if (turn_ > 0 && step > fine && end.total > kInContact && !was_met_for(kWallStep * radius_))
    if (const std::optional<double> peak = peak_before(wall, {t1, end})) {
      t1 = *peak;
      step = (t1 - wall_.t) * length;
      end = contact_at(t1);
    }
  // What the step meets on its way may be what it met where it begins; and more where contact
  // begins, of a front that is met head-on.
  const double before = met_before(0);
  const auto most = [&] { return std::max(end.total, before); };
  const auto may_pass_limit = [&] {
    return most() > theta_ || over_mean(most(), step) ||
           (before <= kInContact && end.total > kInContact);
  };
  while (turn_ <= 0 && may_pass_limit() && step > kFinestWallStep * radius_) {
    step *= 0.5;
    t1 = wall_.t + step / length;
    end = contact_at(t1);
  }
  if (turn_ > 0 && end.total > theta_ + load_budget::kWallStepEnd) {
    double low = wall_.t, high = t1;
    while ((high - low) * length > 1e-3 * radius_) {
      const double middle = 0.5 * (low + high);
      (contact_at(middle).total > theta_ ? high : low) = middle;
    }
    if (low > wall_.t) {
      append(wall.part(wall_.t, low));
      note_contact(contact_at(low).total, (low - wall_.t) * length);
    }
    wall_.t = low;
    if (may_leave_wall_)
      overload();
    else
      give_up();
    return;
  }
  if (turn_ <= 0 && over_mean(most(), step)) {
    // The little that is left in a sharp corner is taken bit by bit; elsewhere the tool would stand
    // in the middle of a front.
    if (may_leave_wall_ && (bit_by_bit_ || near_corner(step)))
      mode_ = Mode::kEnd;
    else
      give_up();
    return;
  }
  // A wall that is near another has material on both sides. A tighter turn leads out of that before
  // it is conventional milling; only where there is none the exact border is followed all the same.
  on_left_ = end.leans_left ? on_left_ + step : 0;
  if ((turn_ > 0 || !may_leave_wall_) && on_left_ > kMostOnLeft * radius_) {
    cut_back(on_left_ - step);
    on_left_ = 0;
    if (may_leave_wall_)
      overload();
    else
      give_up();
    return;
  }
  make_step(wall.part(wall_.t, t1), end.total);
  wall_.t = t1;
  met_here_ = end;
  if (idle() > (has_cut() ? kIdleAfterCut : kIdleBeforeCut) * radius_) mode_ = Mode::kEnd;
}

// True where the front may have a cusp between two looks, or where the tool's right side, along the
// wall, comes free on the way: until then the engaged arc has grown at its far end, from there on
// it is lost at the other.
bool Steering::changes_between(const Contact& a, const Contact& b) const {
  return (a.on_right && !b.on_right) || !is_smooth_between(a, b);
}

// The same, but that a side that comes free does not count far below the limit.
bool Steering::may_peak_between(const Contact& a, const Contact& b) const {
  const double high = theta_ - std::max(kLowShare * theta_, kHighestPeak);
  return std::max(a.total, b.total) > high ? changes_between(a, b) : !is_smooth_between(a, b);
}

// The last look before a cusp, or before the right side comes free, between two looks at `wall`, if
// more is met there than at the second: the engagement may peak there.
std::optional<double> Steering::cusp_between(const Segment& wall, const WallLook& first,
                                             const WallLook& second) const {
  WallLook before = first;
  for (double high = second.t; (high - before.t) * wall.length() > kCuspWidth * theta_ * radius_;) {
    const double middle = 0.5 * (before.t + high);
    const Contact there = contact({wall.point(middle), angle_of(wall.tangent(middle))});
    if (!changes_between(before.contact, there))
      before = {middle, there};
    else
      high = middle;
  }
  const bool is_peak = before.contact.total > second.contact.total && before.t > first.t;
  return is_peak ? std::optional(before.t) : std::nullopt;
}

// Contact begins on the way to `last`, or has just begun. With a front that is met head-on it is
// there at once, and less from there on: the place, if more is met there than at `last`.
std::optional<double> Steering::peak_before(const Segment& wall, const WallLook& last) const {
  const auto total_at = [&](double t) {
    return contact({wall.point(t), angle_of(wall.tangent(t))}).total;
  };
  std::optional<double> peak;
  double most = last.contact.total, apart = (last.t - wall_.t) / kHeadOnLooks;
  for (int i = 1; i < kHeadOnLooks; ++i) {
    const double t = wall_.t + i * apart, total = total_at(t);
    if (total <= most) continue;
    most = total;
    peak = t;
  }
  if (!peak || most < theta_ - kNearLimit) return peak;
  while (apart * wall.length() > kFinestWallStep * radius_) {
    apart *= 0.5;
    const double middle = *peak;
    for (const double t : {middle - apart, middle + apart}) {
      const double total = total_at(t);
      if (total <= most) continue;
      most = total;
      peak = t;
    }
  }
  return peak;
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

// mm along the exact border from `place` to the last look, none further than kMeanLength, before
// one that meets material.
double Steering::clear_ahead(WallPlace place) const {
  const Curve& curve = stage_.centres.curves()[place.curve];
  double ahead = 0;
  for (double look = kFinestWallStep * radius_; ahead < kMeanLength; look = kRunUpStep) {
    Segment wall = curve.segment(place.segment);
    double left = std::min(look, kMeanLength - ahead);
    const double step = left;
    while (left > (1 - place.t) * wall.length()) {
      left -= (1 - place.t) * wall.length();
      place = {place.curve, (place.segment + 1) % curve.segment_count(), 0};
      wall = curve.segment(place.segment);
    }
    place.t += left / wall.length();
    if (contact({wall.point(place.t), angle_of(wall.tangent(place.t))}).total > kInContact) break;
    ahead += step;
  }
  return ahead;
}

// Where a pass along the exact border ended in the middle of a front the next one would begin
// there, and the mean engagement count anew. So it begins kMeanLength mm before it meets material,
// or as far back from `start` as the tool is clear.
WallPlace Steering::run_up(const WallPlace& start) const {
  const Curve& curve = stage_.centres.curves()[start.curve];
  const std::size_t n = curve.segment_count();
  WallPlace place = start;
  for (double left = kMeanLength - clear_ahead(start); left > kRounding;) {
    WallPlace back = place;
    if (back.t <= 0) back = {back.curve, (back.segment + n - 1) % n, 1};
    const Segment wall = curve.segment(back.segment);
    const double step = std::min({left, kRunUpStep, back.t * wall.length()});
    back.t = std::max(0.0, back.t - std::max(step, kRounding) / wall.length());
    if (!ground_.is_clear(wall.point(back.t))) break;
    place = back;
    left -= std::max(step, kRounding);
  }
  return place;
}

}  // namespace evenload
