// The largest Lamé curve inside a closed outline, and the smallest around one: least squares of the
// logarithms of radii, by Levenberg and Marquardt's method [Tancsa 2023 takes the curves as given].
//
// What lies on the wrong side of the outline weighs more and more, so that the curve settles on
// touching it; what is left of that is taken off the semi-axes. Laws: the curve lies on its side of
// the outline everywhere, `margin` mm away from it; a wished value is kept exactly; no radius of
// curvature is below the least one unless a wished exponent, or too little room, demands it; turned
// and shifted outlines give turned and shifted curves.
#pragma once

#include <optional>

#include "geometry/curve.h"
#include "geometry/lame_curve.h"

namespace evenload {

// What is to be kept of a curve; the rest is fitted.
struct LameWishes {
  std::optional<Vec2> centre;
  std::optional<int> segments;
  std::optional<double> semi_axis_a, semi_axis_b;  // mm
  std::optional<double> exponent;
  std::optional<double> rotation;  // rad
};

enum class LameSide { kInside, kAround };

struct LameFitTask {
  LameSide side = LameSide::kInside;
  double least_radius = 0.9;  // mm, of curvature, > 0
  double margin = 0.001;      // mm, >= 0
  LameWishes wishes;
};

// The best of all numbers of segments that are tried, by area. Nothing where no curve fits: with
// the wished values none lies on its side of the outline. Throws std::invalid_argument for wishes
// that no Lamé curve can have. Condition: `outline` is closed and does not cross itself.
std::optional<LameCurve> fit_lame_curve(const Curve& outline, const LameFitTask& task);

}  // namespace evenload
