// Lamé spirals: a Lamé curve whose centre, semi-axes, exponent and segments run with the angle that
// it has turned by [Tancsa 2023, eqs. 5 to 7].
//
// It grows, or shrinks, through a family of closed curves: from circle to shape, from shape to
// circle, or from one shape through a circle to another. How far it has come is a monotone spline
// of the angle turned; a semi-axis or the exponent may follow it by a course, a monotone spline of
// its own.
//
// Laws: where the share grows evenly, the run is 1 and no course is set, the spiral is eq. 6 with
// the exponent of eq. 7; a straight course is as good as none; where the share rests, the spiral is
// the closed curve itself; it is tangent to the curve on which a growth begins with slope 0. The
// segments change only where the curve is a circle, which is the same for any number of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/bi_arc.h"
#include "geometry/curve.h"
#include "geometry/lame_curve.h"
#include "geometry/monotone_spline.h"

namespace evenload {

// Where a stage goes over into another one through a circle, its exponent comes to rest there, with
// its first and second derivative, so that tangent and curvature are continuous.
enum class LameJoint { kNone, kAtBegin, kAtEnd };

// How far a value has come, by the share of a stage: from 0 at 0 to 1 at 1, never falling.
using LameCourse = std::optional<MonotoneSpline>;
// Through values at even steps of the share, from 0 to 1; none where there are none.
LameCourse course_through(const std::vector<double>& values);

// Those that are set; the others run evenly, or as the stage says.
struct LameCourses {
  LameCourse a, b, exponent;

  bool any() const { return a || b || exponent; }
  std::size_t pieces() const;  // of the one with the most; 1 where none is set
};

// From one curve to another: centre and semi-axes run evenly, the exponent by a power of the share,
// or evenly but for the joint, unless courses are set. One of them is a circle (n = 1, a = b), or
// both have the same segments and rotation. Conditions of courses: no joint; where the segments are
// odd those of a and b are the same, or the curves between would not close.
struct LameStage {
  LameCurve from, to;
  double run = 1;  // the power, > 0; 1 with a joint
  LameJoint joint = LameJoint::kNone;
  LameCourses courses = {};
};

// A family of closed curves. The share is that of the way that the larger change of the semi-axes
// makes, over all stages, where they run evenly. Only a growth of one stage has courses.
struct LameGrowth {
  std::vector<LameStage> stages;

  double length() const;               // mm
  std::vector<double> joints() const;  // shares at which stages begin and end: 0, ..., 1
  // Below 0 the first stage's semi-axes are continued backwards, evenly.
  LameCurve at(double share) const;
  const LameCourses& courses() const { return stages.front().courses; }
  // mm: the larger change of the semi-axes over the step of the share that leads to `share`.
  double change(double share, double step) const;
  // The step that leads to `share` with this change, > 0 mm.
  double step_of(double share, double mm) const;
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

// The spiral as arcs within `tolerance` mm, by a tenth more where a course bends sharply, each
// tangent to the next. Throws std::invalid_argument
// for tolerance <= 0 and for curves that check_lame_curve refuses.
LameArcs arcs_of(const LameSpiral& spiral, double tolerance);

// A closed Lamé curve as arcs within `tolerance` mm, counter-clockwise.
Curve closed_arcs_of(const LameCurve& curve, double tolerance);

}  // namespace evenload
