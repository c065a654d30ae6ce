#include "strategy/lame/lame_spiral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/tangent_arcs.h"

namespace evenload {
namespace {

// Share of a stage within which its exponent comes to rest at a joint.
constexpr double kJointShare = 0.3;
// Semi-axes continued backwards never fall below this share of the first ones.
constexpr double kLeastAxis = 0.01;

bool is_circle(const LameCurve& curve) { return curve.exponent == 1 && curve.a == curve.b; }

// What a step that is sought is known to, of itself.
constexpr double kStepFound = 1e-12;

// How far a semi-axis has come at a share of the stage, which may be below 0, and its slope.
double come(const LameCourse& course, double s) { return course && s > 0 ? course->value(s) : s; }
double slope_of(const LameCourse& course, double s) {
  return course ? course->slope(std::max(0.0, s)) : 1;
}

double larger_change(const LameStage& stage) {
  return std::max({std::abs(stage.to.a - stage.from.a), std::abs(stage.to.b - stage.from.b), 1e-9});
}

// The stage at a share of the growth, and the share of the stage.
struct StagePlace {
  const LameStage* stage;
  double share;
};

StagePlace place_in(const LameGrowth& growth, double share) {
  if (growth.stages.size() == 1) return {&growth.stages.front(), std::min(1.0, share)};
  double left = share * growth.length();
  std::size_t i = 0;
  for (; i + 1 < growth.stages.size() && left > larger_change(growth.stages[i]); ++i)
    left -= larger_change(growth.stages[i]);
  return {&growth.stages[i], std::min(1.0, left / larger_change(growth.stages[i]))};
}

// From 0 to 1, at rest at 0 with two derivatives, and even from kJointShare on.
double from_rest(double s) {
  const double slope = 1 / (1 - kJointShare / 2), x = s / kJointShare;
  return slope * (x < 1 ? kJointShare * x * x * x * (1 - x / 2) : s - kJointShare / 2);
}
double slope_from_rest(double s) {
  const double slope = 1 / (1 - kJointShare / 2), x = s / kJointShare;
  return slope * (x < 1 ? x * x * (3 - 2 * x) : 1);
}

// How far the exponent has come at a share of the stage, and its slope; not where that is infinite,
// at the begin of a run below 1.
double exponent_share(const LameStage& stage, double s) {
  if (stage.courses.exponent) return stage.courses.exponent->value(s);
  if (stage.joint == LameJoint::kAtBegin) return from_rest(s);
  if (stage.joint == LameJoint::kAtEnd) return 1 - from_rest(1 - s);
  return stage.run == 1 ? s : std::pow(s, stage.run);
}
double exponent_slope(const LameStage& stage, double s) {
  if (stage.courses.exponent) return stage.courses.exponent->slope(s);
  if (stage.joint == LameJoint::kAtBegin) return slope_from_rest(s);
  if (stage.joint == LameJoint::kAtEnd) return slope_from_rest(1 - s);
  return stage.run * std::pow(std::max(1e-6, s), stage.run - 1);
}

// Between the shapes of two spirals the circle that joins them has this share of its radius to
// spare, at least; otherwise one goes over into the other without it.
constexpr double kCircleRoom = 0.05;
// Such circles are tried, as shares of that room.
constexpr std::array<double, 3> kCircles = {0.15, 0.45, 0.75};

}  // namespace

LameCourse course_through(const std::vector<double>& values) {
  if (values.empty()) return {};
  std::vector<double> shares;
  for (std::size_t i = 0; i < values.size(); ++i)
    shares.push_back(static_cast<double>(i) / static_cast<double>(values.size() - 1));
  return MonotoneSpline(std::move(shares), values);
}

std::size_t LameCourses::pieces() const {
  std::size_t most = 1;
  for (const LameCourse* course : {&a, &b, &exponent})
    if (*course) most = std::max(most, (*course)->pieces());
  return most;
}

double LameGrowth::length() const {
  double sum = 0;
  for (const LameStage& stage : stages) sum += larger_change(stage);
  return sum;
}

std::vector<double> LameGrowth::joints() const {
  std::vector<double> shares{0};
  for (const LameStage& stage : stages)
    shares.push_back(shares.back() + larger_change(stage) / length());
  shares.back() = 1;
  return shares;
}

LameCurve LameGrowth::at(double share) const {
  const auto [stage, s] = place_in(*this, share);
  const LameCurve &from = stage->from, &to = stage->to;
  const double t = std::max(0.0, s), e = exponent_share(*stage, t);
  LameCurve curve = is_circle(to) ? from : to;
  curve.centre = from.centre + t * (to.centre - from.centre);
  const double a = come(stage->courses.a, s), b = come(stage->courses.b, s);
  curve.a = std::max(kLeastAxis * from.a, from.a + a * (to.a - from.a));
  curve.b = std::max(kLeastAxis * from.b, from.b + b * (to.b - from.b));
  curve.exponent = from.exponent + e * (to.exponent - from.exponent);
  return curve;
}

double LameGrowth::change(double share, double step) const {
  if (!courses().a && !courses().b) return step * length();
  const LameStage& stage = stages.front();
  const auto by = [&](const LameCourse& course, double all) {
    return std::abs(all) * (come(course, share) - come(course, share - step));
  };
  return std::max(by(courses().a, stage.to.a - stage.from.a),
                  by(courses().b, stage.to.b - stage.from.b));
}

double LameGrowth::step_of(double share, double mm) const {
  const double even = mm / length();
  if (!courses().a && !courses().b) return even;
  // It is no longer than to where the growth, continued backwards, has changed by as much again.
  double low = 0, high = std::max(0.0, share) + even;
  while (high - low > kStepFound * high) {
    const double middle = 0.5 * (low + high);
    (change(share, middle) < mm ? low : high) = middle;
  }
  return high;
}

PlanePoint LameSpiral::place(double turned) const {
  const double phi = angle(turned), sense = clockwise ? -1 : 1;
  const double so_far = share.value(turned);
  const LameCurve here = growth.at(so_far);
  const auto [stage, s] = place_in(growth, so_far);
  const double rate = share.slope(turned) * growth.length() / larger_change(*stage);
  const LameRadius at = lame_radius(here, phi);
  const double growing = at.by_a * (stage->to.a - stage->from.a) * slope_of(stage->courses.a, s) +
                         at.by_b * (stage->to.b - stage->from.b) * slope_of(stage->courses.b, s) +
                         at.by_exponent * (stage->to.exponent - stage->from.exponent) *
                             exponent_slope(*stage, std::max(0.0, s));
  const Vec2 out = unit(phi);
  const Vec2 velocity = rate * (stage->to.centre - stage->from.centre) +
                        (sense * at.by_angle + rate * growing) * out +
                        sense * at.r * left_normal(out);
  return {here.centre + at.r * out, normalized(velocity)};
}

LameArcs arcs_of(const LameSpiral& spiral, double tolerance) {
  if (!(tolerance > 0)) throw std::invalid_argument("A spiral's tolerance must be positive.");
  for (const LameStage& stage : spiral.growth.stages) {
    check_lame_curve(stage.from);
    check_lame_curve(stage.to);
  }
  TangentArcs arcs = tangent_arcs([&](double turned) { return spiral.place(turned); }, spiral.end,
                                  kMostTurnOfArc, tolerance);
  return {std::move(arcs.moves), std::move(arcs.until)};
}

Curve closed_arcs_of(const LameCurve& curve, double tolerance) {
  const LameSpiral turn{{{{curve, curve}}}, MonotoneSpline(0), curve.rotation, false, 2 * kPi};
  std::vector<Vertex> vertices;
  for (const Segment& move : arcs_of(turn, tolerance).moves)
    vertices.push_back({move.a, move.bulge()});
  return Curve(std::move(vertices), true);
}

LameCurve lame_circle(const LameCurve& like, Vec2 centre, double radius) {
  LameCurve circle = like;
  circle.centre = centre;
  circle.a = circle.b = radius;
  circle.exponent = 1;
  return circle;
}

std::vector<LameGrowth> growths_through_circles(const LameCurve& from, const LameCurve& to) {
  const bool inwards = from.a > to.a;
  const LameCurve &inner = inwards ? to : from, &outer = inwards ? from : to;
  const double apart = distance(from.centre, to.centre);
  const double low = largest_lame_radius(inner), high = least_lame_radius(outer) - apart;
  std::vector<LameGrowth> growths;
  if (high - low < kCircleRoom * high) return growths;
  for (const double share : kCircles) {
    const double radius = low + share * (high - low);
    growths.push_back({{{from, lame_circle(from, inner.centre, radius), 1, LameJoint::kAtEnd},
                        {lame_circle(to, inner.centre, radius), to, 1, LameJoint::kAtBegin}}});
  }
  return growths;
}

}  // namespace evenload
