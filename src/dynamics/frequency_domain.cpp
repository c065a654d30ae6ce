#include "dynamics/frequency_domain.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "dynamics/complex.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kNothing = 1e-12;  // of the axial lag times the order
constexpr int kNewtonSteps = 60;
constexpr double kNewtonStep = 1e-7;     // relative, of differences
constexpr double kSumConverged = 1e-12;  // relative
constexpr double kLargestTurn = 0.6;     // rad of the determinant between two frequencies
constexpr int kMostSplits = 14;          // of the distance between two frequencies

// (1/2 pi) integral of exp(i order phi) from entry to exit.
Complex arc_harmonic(const Milling& m, int order) {
  if (order == 0) return (m.exit() - m.entry()) / (2 * M_PI);
  const Complex factor = kI * static_cast<double>(order);
  return (std::exp(factor * m.exit()) - std::exp(factor * m.entry())) / (2 * M_PI * factor);
}

Eigen::Matrix2cd per_depth(const Milling& m, int order) {
  const Complex one = arc_harmonic(m, -order), up = arc_harmonic(m, 2 - order);
  const Complex down = arc_harmonic(m, -2 - order);
  const Complex sine = (up - down) / (2.0 * kI), cosine = 0.5 * (up + down);
  const Eigen::Matrix2cd by_real =
      force_matrix(m.tangential, m.normal, {one.real(), sine.real(), cosine.real()})
          .cast<Complex>();
  const Eigen::Matrix2cd by_imaginary =
      force_matrix(m.tangential, m.normal, {one.imag(), sine.imag(), cosine.imag()})
          .cast<Complex>();
  return by_real + kI * by_imaginary;
}

// The roots of z^2 - trace z + determinant: the one that is farther from 0 without cancellation,
// the other from their product.
std::array<Complex, 2> eigenvalues(const Eigen::Matrix2cd& matrix) {
  const Complex middle = 0.5 * matrix.trace(), product = matrix.determinant();
  const Complex apart = std::sqrt(middle * middle - product);
  const bool is_plus = std::real(std::conj(middle) * apart) >= 0;
  const Complex far = is_plus ? middle + apart : middle - apart;
  return {far, far == 0.0 ? far : product / far};
}

// Unrolled angle of the determinant from `low` to `high`, with as many looks as it turns.
template <typename Function>
double turn(const Function& f, double low, Complex at_low, double high, Complex at_high,
            int splits) {
  const double angle = std::arg(at_high / at_low);
  if (splits == 0 || std::abs(angle) < kLargestTurn) return angle;
  const double middle = 0.5 * (low + high);
  const Complex at_middle = f(middle);
  return turn(f, low, at_low, middle, at_middle, splits - 1) +
         turn(f, middle, at_middle, high, at_high, splits - 1);
}

}  // namespace

Eigen::Matrix2cd force_harmonic(const Milling& m, double depth, int order) {
  const double lag = order * m.twist() * depth;
  const Complex height = std::abs(lag) < kNothing
                             ? Complex(depth)
                             : depth * std::exp(-0.5 * kI * lag) * (2 * std::sin(0.5 * lag) / lag);
  return per_depth(m, order) * height;
}

FrequencyDomain::FrequencyDomain(const Milling& milling, const Receptance& receptance,
                                 int harmonics)
    : milling_(milling),
      receptance_(turned(receptance, milling.feed_direction)),
      harmonics_(harmonics) {
  check(milling);
  if (harmonics < 0) throw std::invalid_argument("The number of harmonics must not be negative.");
}

double FrequencyDomain::base(double speed) const {
  return milling_.even() ? milling_.teeth * speed : speed;
}

Complex FrequencyDomain::determinant(double speed, double depth, double frequency) const {
  const int count = 2 * harmonics_ + 1, stride = milling_.even() ? milling_.teeth : 1;
  std::vector<Eigen::Matrix2cd> force;  // of orders -2K to 2K, of one tooth
  for (int m = -2 * harmonics_; m <= 2 * harmonics_; ++m)
    force.push_back(force_harmonic(milling_, depth, m * stride));
  const std::vector<double> positions = milling_.positions();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(2 * count, 2 * count);
  std::vector<Eigen::Matrix2cd> receptances;
  for (int k = 0; k < count; ++k)
    receptances.push_back(receptance_(frequency + (k - harmonics_) * base(speed)));
  for (int r = 0; r < count; ++r) {
    const double own = frequency + (r - harmonics_) * base(speed);
    for (int k = 0; k < count; ++k) {
      Complex teeth = 0;
      if (milling_.even()) {
        teeth = static_cast<double>(milling_.teeth) *
                (1.0 - std::exp(-kI * (frequency * milling_.period_angle() / speed)));
      } else {
        for (int j = 0; j < milling_.teeth; ++j)
          teeth += std::exp(kI * ((k - r) * positions[static_cast<std::size_t>(j)])) *
                   (1.0 - std::exp(-kI * (own * milling_.pitch(j) / speed)));
      }
      const auto place = static_cast<std::size_t>(k - r + 2 * harmonics_);
      matrix.block<2, 2>(2 * k, 2 * r) +=
          receptances[static_cast<std::size_t>(k)] * force[place] * teeth;
    }
  }
  return evenload::determinant(matrix);
}

bool FrequencyDomain::find_limit(double speed, double& depth, double& frequency) const {
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Complex value = determinant(speed, depth, frequency);
    const double by_depth = kNewtonStep * depth, by_frequency = kNewtonStep * frequency;
    const Complex slope_depth = (determinant(speed, depth + by_depth, frequency) -
                                 determinant(speed, depth - by_depth, frequency)) /
                                (2 * by_depth);
    const Complex slope_frequency = (determinant(speed, depth, frequency + by_frequency) -
                                     determinant(speed, depth, frequency - by_frequency)) /
                                    (2 * by_frequency);
    Eigen::Matrix2d slopes;
    slopes << slope_depth.real(), slope_frequency.real(), slope_depth.imag(),
        slope_frequency.imag();
    const Eigen::Vector2d step = slopes.inverse() * Eigen::Vector2d(-value.real(), -value.imag());
    if (!step.allFinite()) return false;
    // Far steps are shortened: the guess tells which limit is meant.
    const double size =
        std::max(std::abs(step[0]) / (0.2 * depth), std::abs(step[1]) / (0.02 * frequency));
    depth += step[0] / std::max(1.0, size);
    frequency += step[1] / std::max(1.0, size);
    if (std::abs(step[0]) < kSumConverged * depth && std::abs(step[1]) < kSumConverged * frequency)
      return depth > 0;
  }
  const double left = std::abs(determinant(speed, depth, frequency));
  return depth > 0 && left < 1e-8;
}

int FrequencyDomain::unstable_count(double speed, double depth, double highest) const {
  const auto f = [&](double frequency) { return determinant(speed, depth, frequency); };
  const double step = base(speed);
  // All growing vibrations have one frequency within each base; of the zeroth order each its own.
  const double low = harmonics_ > 0 ? -0.5 * step : -highest;
  const double high = harmonics_ > 0 ? 0.5 * step : highest;
  const int parts = harmonics_ > 0 ? 32 : 64 + static_cast<int>(8 * (high - low) / step);
  double sum = 0, before = low;
  Complex at_before = f(low);
  for (int i = 1; i <= parts; ++i) {
    const double here = low + (high - low) * i / parts;
    const Complex at_here = f(here);
    sum += turn(f, before, at_before, here, at_here, kMostSplits);
    before = here;
    at_before = at_here;
  }
  // A root in the right half of the plane turns the determinant backwards.
  return static_cast<int>(std::lround(-sum / (2 * M_PI)));
}

std::vector<ZerothOrder> zeroth_order(const Milling& milling, const Receptance& receptance,
                                      double frequency) {
  if (!milling.even())
    throw std::invalid_argument(
        "The zeroth order knows even pitch alone: take the multi-frequency solution.");
  const Eigen::Matrix2cd oriented = turned(receptance, milling.feed_direction)(frequency) *
                                    per_depth(milling, 0) * static_cast<double>(milling.teeth);
  std::vector<ZerothOrder> result;
  for (const Complex& value : eigenvalues(oriented)) {
    if (!(value.real() < 0)) continue;
    result.push_back({-1 / (2 * value.real()), 2 * std::atan2(1.0, -value.imag() / value.real())});
  }
  std::sort(result.begin(), result.end(),
            [](const ZerothOrder& a, const ZerothOrder& b) { return a.depth < b.depth; });
  return result;
}

}  // namespace evenload
