#include "geometry/lame_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace evenload {
namespace {

constexpr int kEvenSteps = 12;    // from an axis to the next corner
constexpr int kCornerSteps = 24;  // besides, around a corner, each side
constexpr double kCloser = 0.75;  // one of them over the one before

// rad: angles as near to an axis as their own rounding are on it.
constexpr double kRounding = 4e-16;

double unless_rounding(double x, double rounding) { return std::abs(x) < rounding ? 0 : x; }

void require(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

}  // namespace

void check_lame_curve(const LameCurve& curve) {
  require(std::isfinite(curve.centre.x) && std::isfinite(curve.centre.y) &&
              std::isfinite(curve.rotation),
          "A Lamé curve's centre and rotation must be finite.");
  require(curve.a > 0 && curve.a < 1e6 && curve.b > 0 && curve.b < 1e6,
          "A Lamé curve's semi-axes must be positive.");
  require(curve.exponent >= kLeastExponent && curve.exponent <= kMostExponent,
          "A Lamé curve's exponent must lie between 0.05 and 3.");
  require(curve.segments >= 2, "A Lamé curve has two segments at least.");
  require(curve.segments % 2 == 0 || curve.a == curve.b,
          "A Lamé curve with an odd number of segments closes only with equal semi-axes: set both "
          "to the same length.");
}

namespace {

// The curve's two terms at one polar angle, the larger of their bases taken out: its power is 1
// then, and that of the smaller neither over- nor underflows. Logarithms are taken once, for
// powers, too.
struct Terms {
  double turn, c, s;          // psi over the angle; cos psi and sin psi
  double larger, smaller;     // of |c| / a and |s| / b; the smaller over the larger
  bool along_a;               // the larger is that of a
  double power;               // 2 / n
  double log_raised, raised;  // of the smaller to that power, and itself
  double log_sum;             // of 1 + raised
  double r() const { return std::exp(-log_sum / power) / larger; }
};

Terms terms_of(const LameCurve& curve, double angle) {
  Terms t;
  t.turn = curve.segments / 4.0;
  const double psi = t.turn * (angle - curve.rotation);
  const double rounding = kRounding * std::max(1.0, std::abs(psi));
  t.c = unless_rounding(std::cos(psi), rounding);
  t.s = unless_rounding(std::sin(psi), rounding);
  const double x = std::abs(t.c) / curve.a, y = std::abs(t.s) / curve.b;
  t.along_a = x >= y;
  t.larger = t.along_a ? x : y;
  t.smaller = (t.along_a ? y : x) / t.larger;
  t.power = 2 / curve.exponent;
  t.log_raised = t.power * std::log(t.smaller);  // minus infinity on an axis
  t.raised = std::exp(t.log_raised);
  t.log_sum = std::log(1 + t.raised);
  return t;
}

}  // namespace

LameRadius lame_radius(const LameCurve& curve, double angle) {
  const Terms t = terms_of(curve, angle);
  const double sum = 1 + t.raised;
  LameRadius at;
  at.r = t.r();
  // ln r = -(n / 2) ln(X + Y): its derivatives are weighted by the shares of X and Y.
  const double more = 1 / sum, less = t.raised / sum;
  const double wx = t.along_a ? more : less, wy = t.along_a ? less : more;
  at.log_by_a = wx;
  at.log_by_b = wy;
  at.by_a = at.r * wx / curve.a;
  at.by_b = at.r * wy / curve.b;
  at.by_exponent = 0.5 * at.r * ((less > 0 ? less * t.log_raised : 0) - t.log_sum);
  // wx / c and wx / c^2, which stay finite where c is 0 and the power allows it.
  const double ca = curve.a * t.larger, sb = curve.b * t.larger;
  const double wx_c = t.c == 0 ? 0 : wx / t.c, wy_s = t.s == 0 ? 0 : wy / t.s;
  const double lowered =
      t.smaller > 0 ? t.raised / (t.smaller * t.smaller) : std::pow(0.0, t.power - 2);
  const double wx_cc = (t.along_a ? 1 : lowered) / (sum * ca * ca);
  const double wy_ss = (t.along_a ? lowered : 1) / (sum * sb * sb);
  const double slope = wx_c * t.s - wy_s * t.c;
  const double large = std::max(wx_cc, wy_ss), small = std::min(wx_cc, wy_ss);
  const double rest = 1 - t.power * small;
  const double bend = rest == 0 ? small : large * rest + small;
  at.by_angle = at.r * t.turn * slope;
  at.by_angle_twice = at.r * t.turn * t.turn * (slope * slope + bend);
  return at;
}

double radius_at(const LameCurve& curve, double angle) { return terms_of(curve, angle).r(); }

Vec2 lame_point(const LameCurve& curve, double angle) {
  return curve.centre + radius_at(curve, angle) * unit(angle);
}

double curvature_of(const LameRadius& at) {
  const double speed = at.r * at.r + at.by_angle * at.by_angle;
  return (speed + at.by_angle * at.by_angle - at.r * at.by_angle_twice) /
         (speed * std::sqrt(speed));
}

double lame_curvature(const LameCurve& curve, double angle) {
  return curvature_of(lame_radius(curve, angle));
}

namespace {

double quarter_of(const LameCurve& curve) { return 2 * kPi / curve.segments; }

// rad from the rotation on, in order: from one axis over a corner to the next axis. The other
// quarters are its mirror images.
std::vector<double> quarter_angles(const LameCurve& curve) {
  // Corners lie where both axes have an equal share; axes in the middle between those for a = b.
  const double quarter = quarter_of(curve);
  const double corner = std::atan2(curve.b, curve.a) / (kPi / 2) * quarter;
  std::vector<double> angles;
  const auto add_side = [&](double axis, double to_corner) {
    for (int i = 0; i < kEvenSteps; ++i)
      angles.push_back(axis + i * (to_corner - axis) / kEvenSteps);
    double closer = (to_corner - axis) / kEvenSteps;
    for (int i = 0; i < kCornerSteps; ++i) angles.push_back(to_corner - (closer *= kCloser));
  };
  add_side(0, corner);
  angles.push_back(corner);
  add_side(quarter, corner);
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

std::vector<double> lame_angles(const LameCurve& curve) {
  const double quarter = quarter_of(curve);
  const std::vector<double> one = quarter_angles(curve);
  std::vector<double> angles;
  for (int k = 0; k < curve.segments; ++k) {
    const double begin = curve.rotation + k * quarter;
    for (std::size_t i = 0; i + 1 < one.size(); ++i)  // the last is the first of the next quarter
      angles.push_back(begin + (k % 2 == 0 ? one[i] : quarter - one[one.size() - 1 - i]));
  }
  return angles;
}

double least_curvature_radius(const LameCurve& curve) {
  const auto curvature = [&](double angle) {
    return lame_curvature(curve, curve.rotation + angle);
  };
  double best = 0, most = -std::numeric_limits<double>::infinity();
  for (const double angle : quarter_angles(curve))
    if (const double here = curvature(angle); here > most) {
      most = here;
      best = angle;
    }
  const double reach = quarter_of(curve) / kEvenSteps;
  for (double step = reach; step > 1e-6; step /= 2)
    for (const double angle : {best - step, best + step})
      if (const double here = curvature(angle); here > most) {
        most = here;
        best = angle;
      }
  return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
}

namespace {

// The integral of f over a full turn, by Simpson's rule between the angles of a quarter.
template <typename F>
double over_a_turn(const LameCurve& curve, F f) {
  const std::vector<double> angles = quarter_angles(curve);
  double sum = 0, f_low = f(curve.rotation + angles.front());
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const double low = curve.rotation + angles[i], high = curve.rotation + angles[i + 1];
    const double f_high = f(high);
    sum += (high - low) / 6 * (f_low + 4 * f(0.5 * (low + high)) + f_high);
    f_low = f_high;
  }
  return curve.segments * sum;
}

}  // namespace

double lame_area(const LameCurve& curve) {
  return over_a_turn(curve, [&](double angle) {
    const double r = radius_at(curve, angle);
    return 0.5 * r * r;
  });
}

double lame_length(const LameCurve& curve) {
  return over_a_turn(curve, [&](double angle) {
    const LameRadius at = lame_radius(curve, angle);
    return std::hypot(at.r, at.by_angle);
  });
}

double grown_lame_area(const LameCurve& curve, double by) {
  return lame_area(curve) + by * lame_length(curve) + kPi * by * by;
}

double least_lame_radius(const LameCurve& curve) {
  double least = std::numeric_limits<double>::infinity();
  for (const double angle : quarter_angles(curve))
    least = std::min(least, radius_at(curve, curve.rotation + angle));
  return least;
}

double largest_lame_radius(const LameCurve& curve) {
  double most = 0;
  for (const double angle : quarter_angles(curve))
    most = std::max(most, radius_at(curve, curve.rotation + angle));
  return most;
}

}  // namespace evenload
