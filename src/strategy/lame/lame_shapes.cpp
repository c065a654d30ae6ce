#include "strategy/lame/lame_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace evenload {
namespace {

// Arcs turn this share more tightly than the curve that they follow.
constexpr double kArcRadius = 1.03;
constexpr double kEqualAxes = 0.01;  // of themselves
// Shares of the way from a curve's exponent to the circle's: curves that are tried.
constexpr std::array<double, 4> kRounder = {0.25, 0.5, 0.75, 1};

// Of the two axes of a curve of four segments: whether its first is the shorter, or of equal ones
// that farther from the X axis.
bool is_second(const LameCurve& curve) {
  if (std::abs(curve.a - curve.b) > kEqualAxes * std::max(curve.a, curve.b))
    return curve.a < curve.b;
  return std::abs(std::sin(curve.rotation)) > std::abs(std::cos(curve.rotation));
}

}  // namespace

LameShapes::LameShapes(const ClearingParams& params, const LameParams& lame, double margin)
    : params_(params), lame_(lame), margin_(margin) {}

LameWishes LameShapes::last_wishes() const {
  return {lame_.centre,      lame_.segments,     lame_.semi_axis_a,
          lame_.semi_axis_b, lame_.exponent_end, lame_.rotation};
}

LameWishes LameShapes::first_wishes() const {
  LameWishes wishes;
  wishes.exponent = lame_.exponent_start;
  return wishes;
}

LameFitTask LameShapes::task(LameSide side, const LameWishes& wishes) const {
  const double corner = kCornerRadius * 0.5 * params_.tool_diameter;
  return {side, kArcRadius * std::max(params_.minimum_radius, corner), margin_, wishes};
}

std::optional<LameCurve> LameShapes::last(const Curve& outline, LameSide side) const {
  std::optional<LameCurve> curve = fitted(outline, task(side, last_wishes()));
  if (curve && curve->segments == 4 && lame_.has_axis_courses() && !has_wished_size() &&
      !lame_.rotation && is_second(*curve)) {
    std::swap(curve->a, curve->b);
    curve->rotation = std::remainder(curve->rotation + kPi / 2, kPi);
  }
  return curve;
}

std::optional<LameCurve> LameShapes::fitted(const Curve& outline, LameFitTask fit) const {
  const std::optional<LameCurve> curve = fit_lame_curve(outline, fit);
  if (!curve || has_wished_size() || fit.side != LameSide::kInside ||
      std::max(curve->a, curve->b) <= kLongest * std::min(curve->a, curve->b))
    return curve;
  (curve->a > curve->b ? fit.wishes.semi_axis_a : fit.wishes.semi_axis_b) =
      kLongest * std::min(curve->a, curve->b);
  fit.wishes.segments = 4;
  fit.wishes.rotation = curve->rotation;
  fit.wishes.centre = curve->centre;
  const std::optional<LameCurve> shorter = fit_lame_curve(outline, fit);
  return shorter ? shorter : curve;
}

std::optional<LameCurve> LameShapes::first(const Curve& outline) const {
  return fit_lame_curve(outline, task(LameSide::kAround, first_wishes()));
}

std::optional<LameCurve> LameShapes::first_like(const LameCurve& other,
                                                const Curve& outline) const {
  LameWishes wishes = first_wishes();
  wishes.segments = other.segments;
  wishes.rotation = other.rotation;
  return fit_lame_curve(outline, task(LameSide::kAround, wishes));
}

std::vector<LameCurve> LameShapes::with_rounder_ones(const LameCurve& last, const Curve& outline,
                                                     LameSide side) const {
  std::vector<LameCurve> curves{last};
  if (lame_.exponent_end || lame_.rest == LameRest::kLeave) return curves;
  LameWishes wishes = last_wishes();
  wishes.centre = last.centre;
  wishes.segments = last.segments;
  wishes.rotation = last.rotation;
  for (const double share : kRounder) {
    wishes.exponent = last.exponent + share * (1 - last.exponent);
    if (const std::optional<LameCurve> curve = fitted(outline, task(side, wishes)))
      curves.push_back(*curve);
  }
  return curves;
}

}  // namespace evenload
