// Lamé spirals: a Lamé curve whose centre, semi-axes, exponent and segments run with the angle that
// it has turned by [Tancsa 2023, eqs. 5 to 7].
//
// It grows, or shrinks, through a family of closed curves: from circle to shape, from shape to
// circle, or from one shape through a circle to another. How far it has come is a monotone spline
// of the angle turned.
//
// Laws: where the share grows evenly and the run is 1, the spiral is eq. 6 with the exponent of
// eq. 7; where the share rests, it is the closed curve itself; it is tangent to the curve on which
// a growth begins with slope 0. The segments change only where the curve is a circle, which is the
// same for any number of them.
#pragma once

#include <vector>

#include "geometry/bi_arc.h"
#include "geometry/curve.h"
#include "geometry/lame_curve.h"
#include "geometry/monotone_spline.h"

namespace evenload {

// Where a stage goes over into another one through a circle, its exponent comes to rest there, with
// its first and second derivative, so that tangent and curvature are continuous.
enum class LameJoint { kNone, kAtBegin, kAtEnd };

// From one curve to another: centre and semi-axes run evenly, the exponent by a power of the share,
// or evenly but for the joint. One of them is a circle (n = 1, a = b), or both have the same
// segments and rotation.
struct LameStage {
  LameCurve from, to;
  double run = 1;  // the power, > 0; 1 with a joint
  LameJoint joint = LameJoint::kNone;
};

// A family of closed curves. The share is that of the way that the larger change of the semi-axes
// makes, over all stages.
struct LameGrowth {
  std::vector<LameStage> stages;

  double length() const;               // mm
  std::vector<double> joints() const;  // shares at which stages begin and end: 0, ..., 1
  // Below 0 the first stage's semi-axes are continued backwards.
  LameCurve at(double share) const;
};

// A circle with another curve's segments and rotation.
LameCurve lame_circle(const LameCurve& like, Vec2 centre, double radius);
// Ways from one curve through a circle between them to the other, the circle being smaller or
// larger. None where there is too little room for a circle.
std::vector<LameGrowth> growths_through_circles(const LameCurve& from, const LameCurve& to);

struct LameSpiral {
  LameGrowth growth;
  MonotoneSpline share;    // by the angle turned, rad, from 0 on
  double start = 0;        // rad: polar angle where it begins
  bool clockwise = false;  // for material on the right: when it comes from outside
  double end = 0;          // rad turned

  double angle(double turned) const { return start + (clockwise ? -turned : turned); }
  LameCurve curve(double turned) const { return growth.at(share.value(turned)); }
  PlanePoint place(double turned) const;
};

// rad of the polar angle that an arc may span.
inline constexpr double kMostTurnOfArc = kPi / 3;

struct LameArcs {
  std::vector<Segment> moves;
  std::vector<double> turned;  // rad, at the end of each move, nearly
};

// The spiral as arcs within `tolerance` mm, each tangent to the next. Throws std::invalid_argument
// for tolerance <= 0 and for curves that check_lame_curve refuses.
LameArcs arcs_of(const LameSpiral& spiral, double tolerance);

// A closed Lamé curve as arcs within `tolerance` mm, counter-clockwise.
Curve closed_arcs_of(const LameCurve& curve, double tolerance);

}  // namespace evenload
