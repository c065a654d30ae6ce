#include "dynamics/forced_motion.h"

#include <Eigen/Core>
#include <cmath>

#include "dynamics/complex.h"
#include "dynamics/frequency_domain.h"
#include "support/solvers.h"

namespace evenload {

namespace {

std::vector<Eigen::Vector2cd> even_pitch(const Milling& m, const Receptance& phi, double speed,
                                         double depth, double feed, int harmonics) {
  std::vector<Eigen::Vector2cd> result;
  for (int k = 0; k <= harmonics; ++k) {
    const Eigen::Vector2cd force = -feed * m.teeth * force_harmonic(m, depth, k * m.teeth).col(0);
    result.emplace_back(phi(k * m.teeth * speed) * force);
  }
  return result;
}

// (I + Phi sum over teeth of H (1 - exp(-i w tau))) Q = Phi F, for all harmonics at once.
std::vector<Eigen::Vector2cd> uneven_pitch(const Milling& m, const Receptance& phi, double speed,
                                           double depth, double feed, int harmonics) {
  const int count = 2 * harmonics + 1;
  const std::vector<double> positions = m.positions();
  std::vector<Eigen::Matrix2cd> force;
  for (int order = -2 * harmonics; order <= 2 * harmonics; ++order)
    force.push_back(force_harmonic(m, depth, order));
  Eigen::MatrixXcd lhs = Eigen::MatrixXcd::Identity(2 * count, 2 * count);
  Eigen::VectorXcd rhs = Eigen::VectorXcd::Zero(2 * count);
  for (int k = -harmonics; k <= harmonics; ++k) {
    const Eigen::Matrix2cd receptance = phi(k * speed);
    const int row = 2 * (k + harmonics);
    for (int j = 0; j < m.teeth; ++j) {
      const double own_feed = feed * m.teeth * m.pitch(j) / (2 * M_PI);
      const Complex turn = std::exp(kI * (k * positions[static_cast<std::size_t>(j)]));
      rhs.segment<2>(row) -=
          own_feed * turn *
          (receptance * force[static_cast<std::size_t>(k + 2 * harmonics)].col(0));
    }
    for (int r = -harmonics; r <= harmonics; ++r) {
      Complex teeth = 0;
      for (int j = 0; j < m.teeth; ++j)
        teeth += std::exp(kI * ((k - r) * positions[static_cast<std::size_t>(j)])) *
                 (1.0 - std::exp(-kI * (r * m.pitch(j))));
      lhs.block<2, 2>(row, 2 * (r + harmonics)) +=
          receptance * force[static_cast<std::size_t>(k - r + 2 * harmonics)] * teeth;
    }
  }
  const Eigen::VectorXcd found = solved(lhs, rhs);
  std::vector<Eigen::Vector2cd> result;
  for (int k = 0; k <= harmonics; ++k) result.emplace_back(found.segment<2>(2 * (k + harmonics)));
  return result;
}

// The sum of values_k exp(2 pi i k n/count) for each n, in place; count a power of 2.
void transform(std::vector<Complex>& values) {
  const std::size_t count = values.size();
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count >> 1U;
    for (; j & bit; bit >>= 1U) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
  for (std::size_t length = 2; length <= count; length *= 2) {
    const double angle = 2 * M_PI / static_cast<double>(length);
    const Complex root(std::cos(angle), std::sin(angle));
    Complex turn = 1;
    for (std::size_t k = 0; k < length / 2; ++k) {
      for (std::size_t i = k; i < count; i += length) {
        const Complex a = values[i], b = values[i + length / 2];
        const Complex turned(b.real() * turn.real() - b.imag() * turn.imag(),
                             b.real() * turn.imag() + b.imag() * turn.real());
        values[i] = a + turned;
        values[i + length / 2] = a - turned;
      }
      turn = Complex(turn.real() * root.real() - turn.imag() * root.imag(),
                     turn.real() * root.imag() + turn.imag() * root.real());
    }
  }
}

}  // namespace

ForcedMotion::State ForcedMotion::at(double angle) const {
  State state{harmonics[0].real(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  const Complex step = std::exp(kI * (order * angle));
  Complex turn = 1;
  for (std::size_t k = 1; k < harmonics.size(); ++k) {
    turn *= step;
    const double n = static_cast<double>(k) * order;
    for (int a = 0; a < 2; ++a) {
      const Complex part = 2.0 * harmonics[k][a] * turn;
      state.value[a] += part.real();
      state.slope[a] -= n * part.imag();
      state.bend[a] -= n * n * part.real();
    }
  }
  return state;
}

std::vector<double> ForcedMotion::samples(int axis, std::size_t count) const {
  std::vector<Complex> values(count, 0);
  for (std::size_t k = 0; k < harmonics.size(); ++k)
    values[k] = (k == 0 ? 1.0 : 2.0) * harmonics[k][axis];
  transform(values);
  std::vector<double> result;
  result.reserve(count);
  for (const Complex& value : values) result.push_back(value.real());
  return result;
}

ForcedMotion forced_motion(const Milling& m, const Receptance& receptance, double speed,
                           double depth, double feed_per_tooth, int harmonics) {
  const Receptance phi = m.feed_direction == 0 ? receptance : turned(receptance, m.feed_direction);
  if (m.even()) return {m.teeth, even_pitch(m, phi, speed, depth, feed_per_tooth, harmonics)};
  return {1, uneven_pitch(m, phi, speed, depth, feed_per_tooth, harmonics)};
}

}  // namespace evenload
