#include "geometry/arcs_ahead.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evenload {
namespace {

// What the arcs after the first two leave counts so much, that those can be as long.
constexpr double kNext = 0.95;
// Where so little is left of a curve, in arcs, it has none of its own.
constexpr double kSpare = 0.2;
// Ends of curves are kept to so many times as well as places between them.
constexpr double kEndWeight = 1e6;
constexpr double kSingular = 1e-12;  // share of a diagonal

}  // namespace

PlanePoint ArcJoint::place() const {
  const Vec2 left = left_normal(on.at.direction);
  return {on.at.p + aside * left, normalized(on.at.direction + tilt * left)};
}

double ArcsAhead::fit(double step) {
  set_knots(step);
  return solve() ? off() : std::numeric_limits<double>::infinity();
}

void ArcsAhead::set_knots(double step) {
  const double left = demand_.all() - from_.demand;
  ends_ = left <= (kAhead + kSpare) * step;
  count_ = kAhead;
  if (ends_) {
    count_ = std::clamp(2 * static_cast<int>(std::ceil(0.5 * (left / step - kSpare))), 2, kAhead);
    step = left / count_;
  }
  step_ = step;
  std::size_t look = from_.look;
  for (int i = 1; i <= count_; ++i) {
    knots_[i] = demand_.along(from_.demand + i * step, look) - from_.on.along;
    if (i == 1) middle_ = look;
    if (i == 2) last_ = look;
  }
  if (ends_) knots_[count_] = beyond(looks_.back());
  if (is_last()) last_ = looks_.size() - 1;
}

double ArcsAhead::middle() const { return looks_.u_at(from_.on.along + knots_[1], middle_); }

ArcJoint ArcsAhead::end(const CurvePlace& place) const {
  if (is_last()) return {looks_.back(), last_, demand_.all()};
  const double u = looks_.u_at(from_.on.along + knots_[2], last_);
  ArcJoint joint{looks_.between(last_, u, place(u)), last_, from_.demand + 2 * step_};
  const Error error = error_at(joint.on, beyond(joint.on) > knots_[2] ? 2 : 1);
  joint.aside = error.aside;
  joint.tilt = error.tilt;
  return joint;
}

// mm from the line along the joint's heading to where the curve is.
double ArcsAhead::wanted(const CurveLook& on) const {
  return on.sum - from_.on.sum - from_.aside - heading() * beyond(on);
}

ArcsAhead::Error ArcsAhead::error_at(const CurveLook& on, int arc) const {
  const double in = beyond(on) - knots_[arc];
  return {value_[arc] + in * (slope_[arc] + 0.5 * in * bend_[arc]) - wanted(on),
          slope_[arc] + in * bend_[arc] - on.heading + heading()};
}

// The arcs' curvatures by least squares.
bool ArcsAhead::solve() {
  bend_ = {};
  rows_ = {};
  Values values{};
  int arc = 0;
  for (std::size_t i = from_.look + 1; i < looks_.size(); ++i) {
    const double x = beyond(looks_[i]);
    if (x > knots_[count_]) break;
    while (arc + 1 < count_ && x > knots_[arc + 1]) ++arc;
    for (int k = 0; k < arc; ++k)
      values[k] = (knots_[k + 1] - knots_[k]) * (x - 0.5 * (knots_[k] + knots_[k + 1]));
    values[arc] = 0.5 * (x - knots_[arc]) * (x - knots_[arc]);
    const bool is_end = ends_ && i + 1 == looks_.size();
    add_equation(values, arc + 1, wanted(looks_[i]), is_end ? kEndWeight : 1);
  }
  if (ends_) {
    const double size = knots_[count_];
    for (int k = 0; k < count_; ++k) values[k] = size * (knots_[k + 1] - knots_[k]);
    add_equation(values, count_, size * (looks_.back().heading - heading()), kEndWeight);
  }
  if (!solve_equations()) return false;
  for (int k = 0; k + 1 < count_; ++k) {
    const double in = knots_[k + 1] - knots_[k];
    value_[k + 1] = value_[k] + in * (slope_[k] + 0.5 * in * bend_[k]);
    slope_[k + 1] = slope_[k] + in * bend_[k];
  }
  return true;
}

void ArcsAhead::add_equation(const Values& values, int size, double wanted, double weight) {
  for (int i = 0; i < size; ++i) {
    const double weighed = weight * values[i];
    for (int k = 0; k <= i; ++k) rows_[i][k] += weighed * values[k];
    bend_[i] += weighed * wanted;
  }
}

// By Cholesky's method, in place; false where they have no answer.
bool ArcsAhead::solve_equations() {
  for (int i = 0; i < count_; ++i) {
    const double whole = rows_[i][i];
    for (int j = 0; j <= i; ++j) {
      double sum = rows_[i][j];
      for (int k = 0; k < j; ++k) sum -= rows_[i][k] * rows_[j][k];
      if (i == j && !(sum > kSingular * whole)) return false;
      rows_[i][j] = i == j ? std::sqrt(sum) : sum / rows_[j][j];
    }
    for (int k = 0; k < i; ++k) bend_[i] -= rows_[i][k] * bend_[k];
    bend_[i] /= rows_[i][i];
  }
  for (int i = count_; i-- > 0;) {
    for (int k = i + 1; k < count_; ++k) bend_[i] -= rows_[k][i] * bend_[k];
    bend_[i] /= rows_[i][i];
  }
  return true;
}

// At the looks and between them.
double ArcsAhead::off() const {
  double worst = 0, last = 0;
  Error before{from_.aside, from_.tilt};
  int arc = 0;
  for (std::size_t i = from_.look + 1; i < looks_.size(); ++i) {
    const double x = beyond(looks_[i]);
    if (x > knots_[count_]) break;
    while (arc + 1 < count_ && x > knots_[arc + 1]) ++arc;
    const Error here = error_at(looks_[i], arc);
    const double middle =
        0.5 * (before.aside + here.aside) + (x - last) / 8 * (before.tilt - here.tilt);
    const double weight = arc < 2 ? 1 : kNext;
    worst = std::max({worst, weight * std::abs(here.aside), weight * std::abs(middle)});
    before = here;
    last = x;
  }
  return worst;
}

}  // namespace evenload
