#include "strategy/lame/lame_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/region.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

constexpr int kSamples = 72;  // along the outline
// Numbers of segments that are tried where none is wished: with more, curves are nearly circles.
constexpr std::array<int, 6> kSegments = {4, 3, 5, 6, 7, 8};
// How much more what is on the wrong side weighs, from one round to the next.
constexpr std::array<double, 3> kWrongSide = {30, 1e3, 3e4};
constexpr int kSteps = 10;               // of the method, in one round
constexpr double kGoodStep = 1e-4;       // of the sum of squares: less gained ends a round
constexpr double kStepOfRotation = 0.2;  // rad, at most, in one step
constexpr double kFirstExponent = 0.6;   // a rounded polygon
constexpr double kStepOfExponent = 0.2;  // at most, in one step: far off the model is a bad one
constexpr int kMostLooks = 60;           // for an exponent
constexpr double kRadiusPlay = 1e-3;     // of the least radius: the corners may have so much more
// Of all first curves, by their plain least squares. One with a sum so much larger has not been the
// better one in the end, and one with the same sum is the same curve.
constexpr std::size_t kFinalists = 2;
constexpr double kRival = 3;
constexpr double kBetter = 1e-4;       // of the area: less is no reason for more segments
constexpr double kGivenAway = 1e-4;    // mm of room that may be left unused
constexpr int kCorrections = 5;        // of the semi-axes by what still sticks out
constexpr double kNearlyWorst = 5e-3;  // semi-axes: so near to the worst, others are refined
constexpr int kRefinements = 9;        // each halves the step

// The places of the parameters.
enum { kX, kY, kRotation, kA, kB, kExponent, kParameters };
using Vector = Eigen::Matrix<double, kParameters, 1>;
using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
using Free = std::array<bool, kParameters>;

std::vector<Vec2> samples_of(const Curve& outline) {
  const std::vector<Segment> pieces = outline.segments();
  double length = 0;
  for (const Segment& piece : pieces) length += piece.length();
  std::vector<Vec2> points;
  for (const Segment& piece : pieces) {
    const int count = std::max(1, static_cast<int>(kSamples * piece.length() / length));
    for (int i = 0; i < count; ++i) points.push_back(piece.point(static_cast<double>(i) / count));
  }
  return points;
}

// The middle of the area.
Vec2 centroid(const Curve& outline) {
  const std::vector<Vec2> points = outline.flattened(0.01);
  Vec2 sum;
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i] - points[0], q = points[(i + 1) % points.size()] - points[0];
    area += cross(p, q);
    sum += cross(p, q) * (p + q);
  }
  return points[0] + sum / (3 * area);
}

// Where the outline's m-th wave around `centre` has its crests, rad.
double phase_of(const std::vector<Vec2>& points, Vec2 centre, int m) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i] - centre, q = points[(i + 1) % points.size()] - centre;
    if (p == Vec2{} || q == Vec2{}) continue;
    const double turn = std::atan2(cross(p, q), dot(p, q));
    const double angle = angle_of(p) + turn / 2;
    sum += turn * std::log(0.5 * (norm(p) + norm(q))) * std::polar(1.0, -m * angle);
  }
  return -std::arg(sum) / m;
}

class Fit {
 public:
  Fit(const std::vector<Vec2>& points, const LameFitTask& task, LameCurve first)
      : points_(&points), task_(&task), curve_(first), tied_(first.segments != 4 && !both_set()) {
    free_.fill(true);
    const LameWishes& w = task.wishes;
    if (w.centre) free_[kX] = free_[kY] = false;
    if (w.rotation) free_[kRotation] = false;
    if (w.semi_axis_a) free_[kA] = false;
    if (w.semi_axis_b || tied_) free_[kB] = false;
    if (w.exponent) free_[kExponent] = false;
    if (tied_) tie();
  }

  // The plain least squares; returns their sum.
  double start() {
    round(1);
    return sum_of_squares(curve_, 1);
  }

  // Then the curve that keeps to its side as nearly as least squares can.
  LameCurve run() {
    for (const double weight : kWrongSide) round(weight);
    if (free_[kExponent]) {
      // The corners' radius is a bound: with the exponent that keeps it, the others are fitted
      // again, and once more for what that changes.
      for (int i = 0; i < 2; ++i) {
        const double least = exponent_of_least_radius();
        if (curve_.exponent >= least) return curve_;
        curve_.exponent = least;
        free_[kExponent] = false;
        for (const double weight : kWrongSide) round(weight);
      }
      curve_.exponent = std::max(curve_.exponent, exponent_of_least_radius());
    }
    return curve_;
  }

 private:
  bool both_set() const { return task_->wishes.semi_axis_a && task_->wishes.semi_axis_b; }
  void tie() {
    if (task_->wishes.semi_axis_b) {
      curve_.a = curve_.b;
      free_[kA] = false;
    } else {
      curve_.b = curve_.a;
    }
  }

  double exponent_of_least_radius() const {
    LameCurve curve = curve_;
    // Beyond the radius that is aimed at, which lies a little above the least one.
    const auto beyond = [&](double exponent) {
      curve.exponent = exponent;
      return least_curvature_radius(curve) / ((1 + kRadiusPlay) * task_->least_radius) - 1;
    };
    double low = kLeastExponent, high = 1;
    double at_low = beyond(low), at_high = beyond(high);
    if (at_low >= 0) return low;
    if (at_high <= 0) return high;
    // Regula falsi with the Illinois rule: the radius grows smoothly with the exponent.
    for (int i = 0; i < kMostLooks; ++i) {
      const double exponent = low - (high - low) * at_low / (at_high - at_low);
      const double here = beyond(exponent);
      if (std::abs(here) < kRadiusPlay / 2) return exponent;
      if (here < 0) {
        low = exponent;
        at_low = here;
        at_high *= 0.5;
      } else {
        high = exponent;
        at_high = here;
        at_low *= 0.5;
      }
    }
    return high;
  }

  // How far outside the curve a point of the outline lies, as a logarithm; and its derivatives.
  double residual(const LameCurve& curve, Vec2 p, Vector* gradient) const {
    const Vec2 d = p - curve.centre;
    const double square = std::max(squared_norm(d), kSame * kSame);
    const double angle = angle_of(d);
    if (!gradient) return 0.5 * std::log(square) - std::log(radius_at(curve, angle));
    const LameRadius at = lame_radius(curve, angle);
    const double slope = at.by_angle / at.r;
    (*gradient)[kX] = (-d.x - slope * d.y) / square;
    (*gradient)[kY] = (-d.y + slope * d.x) / square;
    (*gradient)[kRotation] = slope;
    (*gradient)[kA] = tied_ ? -1 : -at.log_by_a;
    (*gradient)[kB] = -at.log_by_b;
    (*gradient)[kExponent] = -at.by_exponent / at.r;
    return 0.5 * std::log(square) - std::log(at.r);
  }

  bool is_wrong(double residual) const {
    return task_->side == LameSide::kInside ? residual < 0 : residual > 0;
  }

  double sum_of_squares(const LameCurve& curve, double weight) const {
    double sum = 0;
    for (const Vec2 p : *points_) {
      const double e = residual(curve, p, nullptr);
      sum += (is_wrong(e) ? weight : 1) * e * e;
    }
    return sum;
  }

  LameCurve moved(const Vector& step) const {
    LameCurve curve = curve_;
    curve.centre += Vec2{step[kX], step[kY]};
    curve.rotation += std::clamp(step[kRotation], -kStepOfRotation, kStepOfRotation);
    if (free_[kA]) curve.a *= std::exp(std::clamp(step[kA], -1.0, 1.0));
    if (free_[kB]) curve.b *= std::exp(std::clamp(step[kB], -1.0, 1.0));
    if (tied_) curve.b = curve.a;
    if (free_[kExponent])
      curve.exponent = std::clamp(
          curve.exponent + std::clamp(step[kExponent], -kStepOfExponent, kStepOfExponent),
          kLeastExponent, 1.0);
    return curve;
  }

  void round(double weight) {
    double damping = 1e-3, sum = sum_of_squares(curve_, weight);
    for (int step = 0; step < kSteps; ++step) {
      Matrix normal = Matrix::Zero();
      Vector right = Vector::Zero();
      for (const Vec2 p : *points_) {
        Vector gradient;
        const double e = residual(curve_, p, &gradient);
        for (int i = 0; i < kParameters; ++i)
          if (!free_[i]) gradient[i] = 0;
        const double w = is_wrong(e) ? weight : 1;
        normal += w * gradient * gradient.transpose();
        right -= w * e * gradient;
      }
      const Vector scale = normal.diagonal().cwiseMax(1e-9);
      bool better = false;
      double gained = 0;
      for (int attempt = 0; attempt < 6 && !better; ++attempt) {
        Matrix damped = normal;
        damped.diagonal() += damping * scale;
        const LameCurve next = moved(damped.ldlt().solve(right));
        const double there = sum_of_squares(next, weight);
        better = there < sum;
        damping *= better ? 0.3 : 5;
        if (!better) continue;
        gained = sum - there;
        sum = there;
        curve_ = next;
      }
      if (!better || gained < kGoodStep * sum) return;
    }
  }

  const std::vector<Vec2>* points_;
  const LameFitTask* task_;
  LameCurve curve_;
  bool tied_;  // both semi-axes are one
  Free free_;
};

// mm by which the curve crosses the outline, or comes nearer to it than the margin, at worst.
double sticking_out(const LameCurve& curve, const BoundaryIndex& outline, const LameFitTask& task) {
  const auto out = [&](double angle) {
    const Vec2 p = lame_point(curve, angle);
    const double away = outline.nearest(p).distance;
    const bool right = outline.contains(p) == (task.side == LameSide::kInside);
    return task.margin - (right ? away : -away);
  };
  const std::vector<double> angles = lame_angles(curve);
  const std::size_t n = angles.size();
  std::vector<double> found;
  for (const double angle : angles) found.push_back(out(angle));
  double worst = *std::max_element(found.begin(), found.end());
  // Between the looks it may be worse: around each that is worse than its neighbours.
  const double nearly = worst - kNearlyWorst * std::max(curve.a, curve.b);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    if (found[i] < std::max({found[before], found[after], nearly})) continue;
    double best = angles[i], most = found[i];
    double step = std::max(wrap_positive(angles[after] - angles[i]),
                           wrap_positive(angles[i] - angles[before]));
    for (int k = 0; k < kRefinements; ++k) {
      step *= 0.5;
      for (const double angle : {best - step, best + step})
        if (const double here = out(angle); here > most) {
          most = here;
          best = angle;
        }
    }
    worst = std::max(worst, most);
  }
  return worst;
}

// The curve with its semi-axes such that it just keeps its side of the outline; nothing where they
// are wished, or none are left.
std::optional<LameCurve> on_its_side(LameCurve curve, const BoundaryIndex& outline,
                                     const LameFitTask& task) {
  const LameWishes& w = task.wishes;
  const double sign = task.side == LameSide::kInside ? -1 : 1;
  const bool fixed_a = w.semi_axis_a || (w.semi_axis_b && curve.segments != 4);
  const bool fixed_b = w.semi_axis_b || (w.semi_axis_a && curve.segments != 4);
  for (int i = 0; i < kCorrections; ++i) {
    const double out = sticking_out(curve, outline, task);
    if (out <= 0 && (out > -kGivenAway || i + 1 == kCorrections)) return curve;
    if (fixed_a && fixed_b) return out <= 0 ? std::optional(curve) : std::nullopt;
    // The last corrections only go away from the outline.
    const double step =
        sign * (i + 2 < kCorrections ? out : std::max(0.0, 1.5 * out)) + sign * kSame / 2;
    if (!fixed_a) curve.a += step;
    if (!fixed_b) curve.b += step;
    if (!(curve.a > 10 * kSame) || !(curve.b > 10 * kSame)) return std::nullopt;
  }
  return sticking_out(curve, outline, task) <= 0 ? std::optional(curve) : std::nullopt;
}

// Curves to begin with: one for every way to lay an m-fold shape over the outline.
std::vector<LameCurve> first_curves(const std::vector<Vec2>& points, Vec2 centre, int m,
                                    const LameWishes& w) {
  std::vector<double> rotations;
  if (w.rotation) {
    rotations = {*w.rotation};
  } else {
    rotations = {phase_of(points, centre, m) - kPi / m};
    if (m == 4) rotations.push_back(phase_of(points, centre, 2));
  }
  std::vector<LameCurve> result;
  for (const double rotation : rotations) {
    LameCurve curve{centre, 0, 0, w.exponent.value_or(kFirstExponent), m, rotation};
    double mean = 0;
    for (const Vec2 p : points) {
      const Vec2 local = rotated(p - centre, -rotation);
      curve.a = std::max(curve.a, std::abs(local.x));
      curve.b = std::max(curve.b, std::abs(local.y));
      mean += norm(local) / static_cast<double>(points.size());
    }
    if (m != 4) curve.a = curve.b = mean;
    curve.a = w.semi_axis_a.value_or(curve.a);
    curve.b = w.semi_axis_b.value_or(curve.b);
    result.push_back(curve);
  }
  return result;
}

}  // namespace

std::optional<LameCurve> fit_lame_curve(const Curve& outline, const LameFitTask& task) {
  const LameWishes& w = task.wishes;
  LameCurve wished{w.centre.value_or(Vec2{}), w.semi_axis_a.value_or(1), 0,
                   w.exponent.value_or(1),    w.segments.value_or(4),    w.rotation.value_or(0)};
  wished.b = w.semi_axis_b.value_or(wished.a);
  check_lame_curve(wished);
  const std::vector<Vec2> points = samples_of(outline);
  const Vec2 centre = w.centre.value_or(centroid(outline));
  const BoundaryIndex index({outline});
  std::vector<std::pair<double, Fit>> fits;
  std::vector<int> tried(kSegments.begin(), kSegments.end());
  if (w.segments) tried = {*w.segments};
  for (const int m : tried) {
    if (m % 2 != 0 && wished.a != wished.b && w.semi_axis_a && w.semi_axis_b) continue;
    for (const LameCurve& first : first_curves(points, centre, m, w)) {
      Fit fit(points, task, first);
      const double sum = fit.start();
      fits.emplace_back(sum > kRounding ? sum : 0, fit);
    }
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const auto& p, const auto& q) { return p.first < q.first; });
  std::optional<LameCurve> best;
  double best_area = 0;
  for (std::size_t i = 0; i < std::min(kFinalists, fits.size()); ++i) {
    const double least = fits.front().first, sum = fits[i].first;
    if (best && (sum > kRival * least || sum <= (1 + kSame) * least)) break;
    std::optional<LameCurve> curve = on_its_side(fits[i].second.run(), index, task);
    if (!curve) continue;
    const double area = lame_area(*curve) * (task.side == LameSide::kInside ? 1 : -1);
    if (best && area <= best_area + kBetter * std::abs(best_area)) continue;
    best = curve;
    best_area = area;
  }
  if (best && !w.rotation)
    best->rotation =
        std::remainder(best->rotation, (best->a == best->b ? 4 : 8) * kPi / best->segments);
  return best;
}

}  // namespace evenload
