// The method: arcs are fitted from each joint on, as long as the first two of them are near enough;
// these are kept, and their end, which lies beside the curve, is the next joint. Pairs of arcs that
// begin and end on the curve, in its directions, would leave it by three times as much.

#include "geometry/tangent_arcs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "geometry/arcs_ahead.h"

namespace evenload {
namespace {

// Of the tolerance: between the looks it may be a little more.
constexpr double kSafety = 0.98;
// Arcs that the curve demands, on each one: the most and the least that is tried, and the usual.
constexpr double kLongest = 1, kShortest = 0.3, kUsual = 0.85;
// Shares of what is allowed: what is aimed at, and what is near enough to it; lengths tried, and
// what they change by.
constexpr double kAim = 0.96, kFine = 0.8;
constexpr int kTries = 4;
constexpr double kLeastChange = 0.6, kMostChange = 1.3;
// Of a length whose arcs turn out to be too far off, and how often.
constexpr double kBack = 0.93;
constexpr int kShorter = 4;
// Pairs that are taken back from one place, at most.
constexpr int kMostBacks = 2;
// Of arcs to a place on the curve: shares of the length before; of the largest step, the least.
constexpr double kToCurve = 0.8, kLeastStep = 1e-4;

// The longest arcs that are near enough, `most` of the demand each at most; those fitted last.
// `step`: a guess. Returns theirs, or 0 where there are none.
double longest(ArcsAhead& ahead, double step, double most, double allowed) {
  double good = 0, bad = most * (1 + 1e-9), next = std::min(step, most);
  for (int i = 0; i < kTries && next >= kShortest; ++i) {
    const double off = ahead.fit(next) / allowed;
    const double here = ahead.step();
    if (off <= 1) {
      good = here;
      if (off >= kFine || ahead.is_last() || next == most) return good;
    } else {
      bad = here;
    }
    next = std::min(most, here * std::clamp(std::cbrt(kAim / off), kLeastChange, kMostChange));
    if (next >= bad || next <= good) next = good > 0 ? 0.5 * (good + bad) : kLeastChange * bad;
    if (i + 2 >= kTries && good > 0) break;
  }
  if (good > 0) ahead.fit(good);
  return good;
}

// mm from the whole circle, or line, of an arc.
double beside(const Segment& arc, Vec2 p) {
  return std::abs(arc.is_arc() ? distance(p, arc.centre) - arc.radius
                               : cross(normalized(arc.b - arc.a), p - arc.a));
}

// Whether the arcs from a joint to another are near enough, at the looks and between them.
bool is_near(const BiArc& pair, const CurveLooks& looks, const ArcJoint& from, const ArcJoint& to,
             double first, double allowed) {
  const CurveLook* before = &from.on;
  for (std::size_t i = from.look + 1; i <= to.look + 1; ++i) {
    const CurveLook& here = i <= to.look ? looks[i] : to.on;
    const double length = here.along - before->along;
    const Vec2 middle =
        0.5 * (before->at.p + here.at.p) + length / 8 * (before->at.direction - here.at.direction);
    const auto off = [&](Vec2 p, double along) {
      return beside(along < from.on.along + first ? pair.first : pair.second, p);
    };
    if (off(middle, here.along - 0.5 * length) > allowed) return false;
    if (i <= to.look && off(here.at.p, here.along) > allowed) return false;
    before = &here;
  }
  return true;
}

// Arcs one pair after the other.
class Chain {
 public:
  Chain(const CurvePlace& place, double end, double most_step, double allowed)
      : place_(place),
        most_step_(most_step),
        allowed_(allowed),
        looks_(place, end, most_step, allowed),
        demand_(looks_, most_step, allowed),
        joints_{{looks_[0]}} {}

  TangentArcs run() {
    while (here().demand < demand_.all())
      if (!add_longest() && !go_back()) add_to_curve();
    return std::move(arcs_);
  }

 private:
  const ArcJoint& here() const { return joints_.back(); }

  bool add_longest() {
    ArcsAhead ahead(looks_, demand_, here());
    for (int i = 0; i < kShorter; ++i) {
      const double found = longest(ahead, step_, most_, allowed_);
      if (found == 0) return false;
      const ArcJoint there = ahead.end(place_);
      const double first = ahead.first(), ratio = first / (ahead.second() - first);
      const std::optional<BiArc> pair = bi_arc(here().place(), there.place(), kPi, ratio);
      if (pair && is_near(*pair, looks_, here(), there, first, allowed_)) {
        add(*pair, there, ahead.middle(), found);
        return true;
      }
      step_ = most_ = kBack * found;
    }
    return false;
  }

  // The last pair was too long for those after it. Not too often, or nothing is gained.
  bool go_back() {
    if (backs_ == kMostBacks || steps_.empty() || steps_.back() == 0) return false;
    ++backs_;
    step_ = most_ = kBack * steps_.back();
    joints_.pop_back();
    steps_.pop_back();
    arcs_.moves.resize(arcs_.moves.size() - 2);
    arcs_.until.resize(arcs_.until.size() - 2);
    return true;
  }

  // Two arcs to a place on the curve, in its direction.
  void add_to_curve() {
    const ArcJoint from = here();
    const double least = kLeastStep * most_step_, end = looks_.back().u;
    for (double step = 2 * most_step_;; step *= kToCurve) {
      const ArcJoint there = joint_at(end - from.on.u < step + least ? end : from.on.u + step);
      const std::optional<BiArc> pair = bi_arc(from.place(), there.place(), kPi);
      const double first = 0.5 * (there.on.along - from.on.along);
      if (step > least && !(pair && is_near(*pair, looks_, from, there, first, allowed_))) continue;
      const Segment line = Segment::line(from.place().p, there.on.at.p);
      add(pair.value_or(BiArc{line.part(0, 0.5), line.part(0.5, 1)}), there,
          0.5 * (from.on.u + there.on.u), 0);
      return;
    }
  }

  ArcJoint joint_at(double u) const {
    std::size_t i = here().look;
    while (i + 2 < looks_.size() && looks_[i + 1].u <= u) ++i;
    if (i + 2 == looks_.size() && looks_[i + 1].u <= u)
      return {looks_[i + 1], i + 1, demand_.all()};
    const CurveLook on = looks_.between(i, u, place_(u));
    return {on, i, demand_.at(i, on)};
  }

  // `middle`: the parameter where its two arcs meet. `step`: what they have of the demand; 0 for
  // arcs to the curve.
  void add(const BiArc& pair, const ArcJoint& there, double middle, double step) {
    arcs_.moves.insert(arcs_.moves.end(), {pair.first, pair.second});
    arcs_.until.insert(arcs_.until.end(), {middle, there.on.u});
    joints_.push_back(there);
    steps_.push_back(step);
    step_ = step > 0 ? step : kUsual;
    most_ = kLongest;
    if (joints_.size() <= farthest_) return;
    farthest_ = joints_.size();
    backs_ = 0;
  }

  const CurvePlace& place_;
  double most_step_, allowed_;
  CurveLooks looks_;
  ArcDemand demand_;
  TangentArcs arcs_;
  std::vector<ArcJoint> joints_;
  std::vector<double> steps_;               // from each to the next
  double step_ = kUsual, most_ = kLongest;  // to be tried, and not to be exceeded
  std::size_t farthest_ = 0;                // joint
  int backs_ = 0;                           // since then
};

}  // namespace

TangentArcs tangent_arcs(const CurvePlace& place, double end, double most_step, double tolerance) {
  return Chain(place, end, most_step, kSafety * tolerance).run();
}

}  // namespace evenload
