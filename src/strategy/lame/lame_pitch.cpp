#include "strategy/lame/lame_pitch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cutting/engagement.h"
#include "geometry/curve_looks.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

constexpr int kLevels = 8;         // of the growth at which steps are looked for, to each stage
constexpr int kLevelsOfPiece = 3;  // the same to each piece of its courses, at least
constexpr int kEveryAngle = 3;     // of lame_angles() is looked at: axes and corners are among them
constexpr int kKnots = 16;         // of a spiral's functions, for each turn
constexpr double kRampIn = 0.5;    // rad within which a spiral takes up its first slope
constexpr double kTurnOff = 0.15;  // rad within which it turns off its last curve
constexpr double kMostBack = 0.1;  // of the last step: it turns off by no more
constexpr double kLeastStep = 1e-4;  // share of the growth: less is no progress
// Share of what semi-axes change by: fits of even shapes come as near to even curves.
constexpr double kAlike = 1e-3;
constexpr double kSmallStep = 1e-4;  // share of the growth: for its direction
constexpr double kFirstStep = 2;     // side steps: no turn goes farther
constexpr int kMostPitchLooks = 8;   // for one step
constexpr double kEdge = 5e-4;       // tool radii: how well the edge of the engagement is met
constexpr double kLess = 0.95;       // by which a step is tried again that exceeds the pitch
constexpr std::array<double, 2> kRuns = {1, 2.5};

struct Heading {
  Vec2 p;
  Vec2 direction;    // of unit length
  double speed;      // mm/rad
  double curvature;  // 1/mm, of the curve as it grows with the angle
};

Heading heading_at(const LameCurve& curve, double angle, bool inwards) {
  const LameRadius at = lame_radius(curve, angle);
  const Vec2 out = unit(angle);
  const Vec2 velocity = at.by_angle * out + at.r * left_normal(out);
  const double speed = norm(velocity);
  return {curve.centre + at.r * out, (inwards ? -1 : 1) / speed * velocity, speed,
          curvature_of(at)};
}

// Whether each of the m parts of a turn is like the others, as far as steps can tell: one of them
// is looked at, then.
bool is_even(const LameGrowth& growth) {
  const double small = kAlike * growth.length();
  return std::all_of(growth.stages.begin(), growth.stages.end(), [&](const LameStage& s) {
    return std::abs(s.from.a - s.from.b) < small && std::abs(s.to.a - s.to.b) < small &&
           distance(s.from.centre, s.to.centre) < small && s.courses.a == s.courses.b;
  });
}

// Over one part where all are alike, else over a turn.
std::vector<double> angles_to_look_at(const LameGrowth& growth, const LameCurve& curve) {
  const double part = is_even(growth) ? 2 * kPi / curve.segments : 2 * kPi;
  std::vector<double> angles;
  const std::vector<double> all = lame_angles(curve);
  for (std::size_t i = 0; i < all.size(); i += kEveryAngle)
    if (all[i] < curve.rotation + part - kRounding) angles.push_back(all[i]);
  return angles;
}

// A turn that comes to `share` at polar angle `angle`, and the turn before it.
class Turn {
 public:
  Turn(const LameGrowth& growth, bool inwards, double share, double angle)
      : growth_(growth), sense_(inwards ? -1 : 1), share_(share), angle_(angle) {}

  // mm: by how much a point lies farther than `reach` from the turn before, which is about `reach`
  // away, where turns grow by `step`; some number that is not positive where `only_sign` is asked
  // for and it lies no farther.
  double beyond(Vec2 p, double reach, double step, bool only_sign = false) const {
    const auto foot = [&](double phi) { return place(phi, share_ - step * (1 - back(phi))); };
    const double middle = angle_of(p - growth_.at(share_ - step).centre);
    // Around a corner the distance has flat places: the nearest of a few looks, then refined.
    const double window = std::min(kPi / 3, reach / std::max(reach, distance(p, centre())));
    double best = middle, least = distance(foot(middle), p);
    for (double apart = window; apart > kFoot; apart *= kCloser) {
      if (only_sign && least <= reach) break;
      for (const double phi : {best - apart, best + apart})
        if (const double here = distance(foot(phi), p); here < least) {
          least = here;
          best = phi;
        }
    }
    return least - reach;
  }

 private:
  static constexpr double kFoot = 3e-3;  // rad: nearer looks change nothing that matters
  static constexpr double kCloser = 0.55;

  Vec2 centre() const { return growth_.at(share_).centre; }
  // Share of a turn by which an angle lies ahead of here.
  double back(double phi) const { return sense_ * wrap_signed(phi - angle_) / (2 * kPi); }
  Vec2 place(double phi, double share) const { return lame_point(growth_.at(share), phi); }

  const LameGrowth& growth_;
  double sense_, share_, angle_;
};

// The change of the share from turn to turn with which the engagement at this angle is the limit;
// `most` where it is no less.
double step_at(const LameGrowth& growth, const TurnTask& task, double share, double angle,
               double most) {
  const double r = task.tool_radius;
  const LameCurve curve = growth.at(share);
  const Heading along = heading_at(curve, angle, task.inwards);
  const Turn turn(growth, task.inwards, share, angle);
  // The spiral itself heads a little outwards, or inwards.
  const Vec2 towards = lame_point(growth.at(share + kSmallStep), angle) - along.p;
  const auto beyond = [&](double step, bool only_sign = false) {
    const Vec2 velocity = along.speed * along.direction + step / (2 * kPi * kSmallStep) * towards;
    const Vec2 edge = along.p + r * rotated(normalized(velocity), task.engagement - kPi / 2);
    return turn.beyond(edge, r, step, only_sign);
  };
  // The distance grows nearly in proportion to the step: regula falsi with the Illinois rule.
  double low = 0, high = most, f_high = beyond(high, true);
  if (f_high <= 0) return high;
  double f_low = beyond(low);
  if (f_low >= 0) return 0;
  for (int i = 0; i < kMostPitchLooks; ++i) {
    const double step = low + (high - low) * f_low / (f_low - f_high);
    const double f = beyond(step);
    if (std::abs(f) < kEdge * r) return step;
    if (f < 0) {
      low = step;
      f_low = f;
      f_high *= 0.5;
    } else {
      high = step;
      f_high = f;
      f_low *= 0.5;
    }
  }
  return low;
}

std::vector<double> levels_of(const LameGrowth& growth) {
  const std::vector<double> joints = growth.joints();
  const int count = std::max(kLevels, kLevelsOfPiece * static_cast<int>(growth.courses().pieces()));
  std::vector<double> levels{0};
  for (std::size_t k = 0; k + 1 < joints.size(); ++k)
    for (int i = 1; i <= count; ++i)
      levels.push_back(joints[k] + i * (joints[k + 1] - joints[k]) / count);
  levels.back() = 1;
  return levels;
}

// Whether all of its curves lie outside the inner one of its first and last.
bool stays_between(const LameGrowth& growth) {
  const LameCurve &first = growth.stages.front().from, &last = growth.stages.back().to;
  const LameCurve& inner = first.a > last.a ? last : first;
  for (const double level : levels_of(growth)) {
    const LameCurve curve = growth.at(level);
    for (const double angle : angles_to_look_at(growth, inner)) {
      const Vec2 p = lame_point(inner, angle) - curve.centre;
      if (radius_at(curve, angle_of(p)) < norm(p) * (1 - kSame)) return false;
    }
  }
  return true;
}

}  // namespace

MonotoneSpline largest_steps(const LameGrowth& growth, const TurnTask& task) {
  const std::vector<double> levels = levels_of(growth);
  std::vector<double> steps;
  const double farthest = kFirstStep * side_step(task.engagement, task.tool_radius);  // mm
  std::size_t worst = 0;  // where the step was the least
  for (const double level : levels) {
    if (task.progress) task.progress->step();
    double least = growth.step_of(level, task.pitch ? std::min(farthest, *task.pitch) : farthest);
    const std::vector<double> angles = angles_to_look_at(growth, growth.at(level));
    // It is likely to be the least there again, and then one look at each other angle is enough.
    const std::size_t first = std::min(worst, angles.size() - 1);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const std::size_t i = (first + k) % angles.size();
      const double step = step_at(growth, task, level, angles[i], least);
      if (step < least) worst = i;
      least = std::min(least, step);
    }
    steps.push_back(std::max(least, kLeastStep));
  }
  return MonotoneSpline(levels, steps);
}

namespace {

// As far as the step here allows, and less where it is about to become smaller.
double step_from(const MonotoneSpline& steps, double share) {
  const double here = steps.value(share);
  return std::min(here, steps.value(share + here));
}

// A piece of a turn.
struct TurnPiece {
  double length;     // mm
  double pace;       // min/mm
  double curvature;  // 1/mm
  double least_blocks;
};

// s: what blocks cost on the pieces of a closed turn: the arcs that its curvature demands, more of
// them where the feed changes, and what is lost since it changes in steps.
double blocks_cost(const std::vector<TurnPiece>& pieces, const TurnTask& task) {
  double cost = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TurnPiece &here = pieces[i], &next = pieces[(i + 1) % pieces.size()];
    const double apart = 0.5 * (here.length + next.length);
    const double bend = std::abs(next.curvature - here.curvature) / apart;
    const double slope = 60 * std::abs(next.pace - here.pace) / apart;  // s/mm^2
    const double arcs =
        std::max(here.least_blocks / here.length, arcs_per_mm(bend, task.tolerance));
    // As many as lose as little as possible: half the slope over the blocks, and their price.
    const double blocks = std::max(arcs, std::sqrt(0.5 * slope / task.block_price));
    cost += here.length * (blocks * task.block_price + 0.5 * slope / blocks);
  }
  return cost;
}

}  // namespace

double time_of(const LameGrowth& growth, const MonotoneSpline& steps, const TurnTask& task) {
  const double nominal = side_step(task.engagement, task.tool_radius);
  const std::vector<double> levels = levels_of(growth);
  double total = 0;
  std::vector<TurnPiece> pieces;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double level = 0.5 * (levels[k] + levels[k + 1]), step = step_from(steps, level);
    const LameCurve curve = growth.at(level), before = growth.at(level - step);
    const std::vector<double> angles = angles_to_look_at(growth, curve);
    const int parts = is_even(growth) ? curve.segments : 1;
    pieces.clear();
    double turn = 0;  // s
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * kPi / parts;
      const Heading here = heading_at(curve, 0.5 * (angles[i] + next), task.inwards);
      // mm to the turn before, across this one; what is removed lies a tool's radius farther on.
      const Vec2 back = lame_point(before, 0.5 * (angles[i] + next)) - here.p;
      const double apart = dot(back, left_normal(here.direction));
      const double bent = (task.inwards ? -1 : 1) * task.tool_radius * here.curvature;
      const double width = std::max(0.0, apart * (1 + bent));
      const double pace = task.pace
                              ? task.pace->value(width)
                              : std::max(width / (nominal * task.feed), 1 / task.maximum_feed);
      const double length = here.speed * (next - angles[i]);
      pieces.push_back({length, pace, here.curvature, (next - angles[i]) / kMostTurnOfArc});
      turn += 60 * length * pace;
    }
    turn += blocks_cost(pieces, task);
    total += parts * turn * (levels[k + 1] - levels[k]) / step;
  }
  return total;
}

std::optional<PlannedGrowth> best_growth(const std::vector<LameGrowth>& growths,
                                         const TurnTask& task) {
  std::optional<PlannedGrowth> best;
  double least = std::numeric_limits<double>::infinity();
  for (LameGrowth growth : growths) {
    const bool one = growth.stages.size() == 1;
    const LameStage& stage = growth.stages.front();
    for (const double run : kRuns) {
      const bool has_run = one && stage.from.exponent != stage.to.exponent;
      if (run != 1 && (!has_run || stage.courses.exponent)) continue;
      if (one) growth.stages.front().run = run;
      if (!stays_between(growth)) continue;
      MonotoneSpline steps = largest_steps(growth, task);
      const double time = time_of(growth, steps, task);
      if (time >= least) continue;
      least = time;
      best = {growth, std::move(steps)};
    }
  }
  return best;
}

LameSpiral spiral_of(const LameGrowth& growth, const MonotoneSpline& steps, double start,
                     bool inwards, double off, std::optional<double> pitch) {
  const double knot = 2 * kPi / kKnots;
  std::vector<double> turned{-knot, 0}, shares{0, 0};
  while (shares.back() < 1) {
    if (turned.back() > 2 * kPi * kMostTurns)
      throw std::invalid_argument(
          "The spiral would take more than 2000 turns: raise EngagementAngle or Pitch, make "
          "courses "
          "more even, or take the operation Adaptive.");
    const double share = shares.back(), step = step_from(steps, share);
    const double ramp = std::min(1.0, (turned.back() + knot / 2) / kRampIn);
    double by = ramp * step / kKnots;
    if (pitch && growth.courses().any())
      while (growth.change(share + by, by) > (1 + kSame) * *pitch / kKnots) by *= kLess;
    turned.push_back(turned.back() + knot);
    shares.push_back(std::min(1.0, share + by));
  }
  turned.push_back(turned.back() + 2 * kPi);
  shares.push_back(1);
  if (off > 0) {
    turned.push_back(turned.back() + kTurnOff);
    // Never back to the beginning, nor, where a course ends at rest, by much of a step.
    double back = std::min(0.5, growth.step_of(1, off));
    if (growth.courses().any()) back = std::min(back, kMostBack * steps.value(1));
    shares.push_back(1 - back);
  }
  const double end = turned.back();
  return {growth, MonotoneSpline(std::move(turned), std::move(shares)), start, inwards, end};
}

}  // namespace evenload
