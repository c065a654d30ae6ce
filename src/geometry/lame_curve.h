// Lamé curves (superellipses) of m-fold symmetry in polar form [Tancsa 2023, eq. 4; Gielis 2003].
//
// About the centre, psi = m (phi - rotation) / 4 after Gielis, the curve is
//   r(phi) = (|cos psi / a|^(2/n) + |sin psi / b|^(2/n))^(-n/2),
// which is eq. 4 without its tangents, so that nothing overflows at their poles. n = 1 is the
// ellipse (for m = 4), n -> 0 the rectangle for m = 4 and a sec(psi) otherwise.
// Conditions: 0 < a, b; kLeastExponent <= n <= kMostExponent; m >= 2; where a and b differ m is
// even, or the curve would not close. Throws std::invalid_argument where they are not kept.
// Laws: r is a on the axes psi = 0 and pi, b on the others, and has m-fold symmetry where a = b;
// it grows with a and b and falls as n grows; continuous everywhere. Derivatives exist everywhere
// for n <= 1; for more the curve has no finite second derivative on its axes, and from n = 2 on no
// tangent either: infinity and 0 stand for them.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace evenload {

inline constexpr double kLeastExponent = 0.05, kMostExponent = 3;

struct LameCurve {
  Vec2 centre;
  double a = 1, b = 1;  // mm, semi-axes
  double exponent = 1;  // n
  int segments = 4;     // m
  double rotation = 0;  // rad, of the first axis

  bool operator==(const LameCurve&) const = default;
};

void check_lame_curve(const LameCurve& curve);

// The curve at one polar angle: r and its derivatives. Condition: a checked curve.
struct LameRadius {
  double r = 0;                       // mm
  double by_angle = 0;                // mm/rad
  double by_angle_twice = 0;          // mm/rad^2
  double by_a = 0, by_b = 0;          // mm/mm
  double by_exponent = 0;             // mm
  double log_by_a = 0, log_by_b = 0;  // of ln r by ln a and ln b: the axes' shares, of sum 1
};
LameRadius lame_radius(const LameCurve& curve, double angle);
// mm: its r alone, which takes half the time.
double radius_at(const LameCurve& curve, double angle);

Vec2 lame_point(const LameCurve& curve, double angle);
// 1/mm, positive where the curve turns left as the angle grows.
double lame_curvature(const LameCurve& curve, double angle);
double curvature_of(const LameRadius& at);

// Angles at which the curve is looked at where its tightest and its flattest places must not be
// missed: even steps, and closer ones around its corners. In order, within one full turn.
std::vector<double> lame_angles(const LameCurve& curve);
// mm: the least radius of curvature; infinity where it never turns left.
double least_curvature_radius(const LameCurve& curve);

// mm^2 inside the curve, and mm of its length, to 1e-4 of themselves.
double lame_area(const LameCurve& curve);
double lame_length(const LameCurve& curve);
// mm^2 inside the curve moved outwards by `by` mm. For by < 0 inwards: exact where it has no
// tighter corners than that.
double grown_lame_area(const LameCurve& curve, double by);

// mm, of the curve's points from its centre.
double least_lame_radius(const LameCurve& curve);
double largest_lame_radius(const LameCurve& curve);

}  // namespace evenload
