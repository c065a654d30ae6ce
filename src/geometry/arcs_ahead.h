// The next few tangent arcs along a curve: a quadratic spline, fitted by least squares.
//
// What lies aside of a curve by e(s) mm after s mm has the curvature k + e'' there, next to nothing
// else. Tangent arcs have a curvature that is constant piece by piece; so e plus the curve's
// curvature integrated twice is a parabola on each piece, with a continuous slope.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/curve_looks.h"

namespace evenload {

// Where arcs meet, beside the curve.
struct ArcJoint {
  CurveLook on;          // its place on the curve
  std::size_t look = 0;  // the last one not beyond it
  double demand = 0;     // arcs up to here
  double aside = 0;      // mm to the left
  double tilt = 0;       // rad to the left

  PlanePoint place() const;
};

class ArcsAhead {
 public:
  // All three must outlive this.
  ArcsAhead(const CurveLooks& looks, const ArcDemand& demand, const ArcJoint& from)
      : looks_(looks), demand_(demand), from_(from) {}

  // Fits arcs that have `step` of the demand each, or as many as end the curve. Returns how far the
  // first two lie from the curve, mm; infinity where there are too few looks to tell.
  double fit(double step);

  // Of the arcs fitted last: their demand, and mm from the joint to the end of the first two.
  double step() const { return step_; }
  double first() const { return knots_[1]; }
  double second() const { return knots_[2]; }
  // These two are the curve's last ones.
  bool is_last() const { return ends_ && count_ == 2; }
  // The curve's parameter where the first one ends, nearly; and where the second one does.
  double middle() const;
  ArcJoint end(const CurvePlace& place) const;

 private:
  static constexpr int kAhead = 4;  // arcs at once: what the last two do hardly moves the others
  using Values = std::array<double, kAhead>;
  struct Error {
    double aside = 0, tilt = 0;
  };

  void set_knots(double step);
  bool solve();
  void add_equation(const Values& values, int size, double wanted, double weight);
  bool solve_equations();
  double off() const;
  double heading() const { return from_.on.heading + from_.tilt; }
  double beyond(const CurveLook& on) const { return on.along - from_.on.along; }
  double wanted(const CurveLook& on) const;
  Error error_at(const CurveLook& on, int arc) const;

  const CurveLooks& looks_;
  const ArcDemand& demand_;
  const ArcJoint& from_;
  int count_ = kAhead;
  bool ends_ = false;  // the curve
  double step_ = 1;
  std::size_t middle_ = 0, last_ = 0;       // looks before the first two arcs' ends
  std::array<double, kAhead + 1> knots_{};  // mm from the joint
  Values bend_{}, value_{}, slope_{};       // the spline's: of each arc, and where it begins
  std::array<Values, kAhead> rows_{};       // of the equations, on and before the diagonal
};

}  // namespace evenload
