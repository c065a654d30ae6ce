#include "geometry/monotone_spline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace evenload {

MonotoneSpline::MonotoneSpline(std::vector<double> knots, std::vector<double> values)
    : knots_(std::move(knots)), values_(std::move(values)), slopes_(knots_.size(), 0.0) {
  if (knots_.empty() || knots_.size() != values_.size())
    throw std::invalid_argument("A spline takes one value for each knot.");
  for (std::size_t i = 0; i < knots_.size(); ++i)
    if (!std::isfinite(knots_[i]) || !std::isfinite(values_[i]) ||
        (i > 0 && !(knots_[i] > knots_[i - 1])))
      throw std::invalid_argument("A spline's knots must rise, and its values be finite.");
  const std::size_t last = knots_.size() - 1;
  if (last == 0) return;
  const auto secant = [&](std::size_t i) {
    return (values_[i + 1] - values_[i]) / (knots_[i + 1] - knots_[i]);
  };
  for (std::size_t i = 1; i < last; ++i) {
    const double before = secant(i - 1), after = secant(i);
    if (before * after <= 0) continue;
    const double left = knots_[i] - knots_[i - 1], right = knots_[i + 1] - knots_[i];
    slopes_[i] = 3 * (left + right) / ((2 * right + left) / before + (2 * left + right) / after);
  }
  // Ends continue their piece as a parabola, as far as it stays monotone.
  const auto end_slope = [](double chord, double inner) {
    const double slope = 0.5 * (3 * chord - inner);
    if (slope * chord <= 0) return 0.0;
    return std::abs(slope) > 3 * std::abs(chord) ? 3 * chord : slope;
  };
  slopes_[0] = last == 1 ? secant(0) : end_slope(secant(0), slopes_[1]);
  slopes_[last] = last == 1 ? secant(0) : end_slope(secant(last - 1), slopes_[last - 1]);
}

MonotoneSpline::Place MonotoneSpline::find(double x) const {
  if (knots_.size() == 1 || x < knots_.front()) return {0, 0, 1, true};
  if (x > knots_.back()) return {knots_.size() - 1, 0, 1, true};
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x);
  const auto piece = static_cast<std::size_t>(above - knots_.begin()) - 1;
  const double width = knots_[piece + 1] - knots_[piece];
  return {piece, (x - knots_[piece]) / width, width, false};
}

double MonotoneSpline::value(double x) const {
  const Place at = find(x);
  if (at.outside) return values_[at.piece];
  const double t = at.t, s = 1 - t, i = at.width;
  return s * s * (1 + 2 * t) * values_[at.piece] + t * t * (1 + 2 * s) * values_[at.piece + 1] +
         s * t * i * (s * slopes_[at.piece] - t * slopes_[at.piece + 1]);
}

double MonotoneSpline::slope(double x) const {
  const Place at = find(x);
  if (at.outside) return 0;
  const double t = at.t, s = 1 - t;
  return 6 * s * t * (values_[at.piece + 1] - values_[at.piece]) / at.width +
         s * (s - 2 * t) * slopes_[at.piece] + t * (t - 2 * s) * slopes_[at.piece + 1];
}

}  // namespace evenload
