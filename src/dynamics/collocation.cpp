#include "dynamics/collocation.h"

#include <cmath>
#include <utility>

namespace evenload {

namespace {

// The Legendre polynomial of degree kStages on -1..1 and its derivative.
std::pair<double, double> legendre(double x) {
  double before = 1, value = x;
  for (int n = 2; n <= kStages; ++n) {
    const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
    before = value;
    value = next;
  }
  return {value, kStages * (x * value - before) / (x * x - 1)};
}

double lagrange(const Collocation::Values& node, int j, double place) {
  double value = 1;
  for (int i = 0; i < kStages; ++i)
    if (i != j) value *= (place - node[i]) / (node[j] - node[i]);
  return value;
}

Collocation make() {
  Collocation c;
  for (int i = 0; i < kStages; ++i) {
    double x = -std::cos(M_PI * (i + 0.75) / (kStages + 0.5));
    for (int step = 0; step < 8; ++step) {
      const auto [value, slope] = legendre(x);
      x -= value / slope;
    }
    const double slope = legendre(x).second;
    c.node[i] = 0.5 * (1 + x);
    c.weight[i] = 1 / ((1 - x * x) * slope * slope);
  }
  for (int i = 0; i < kStages; ++i)
    for (int j = 0; j < kStages; ++j) {
      double sum = 0;
      for (int k = 0; k < kStages; ++k)
        sum += c.weight[k] * lagrange(c.node, j, c.node[i] * c.node[k]);
      c.once(i, j) = c.node[i] * sum;
    }
  c.twice = c.once * c.once;
  c.weight_twice = c.once.transpose() * c.weight;
  return c;
}

}  // namespace

Eigen::Matrix<double, kStages + 2, 1> Collocation::interpolation(double place) const {
  Eigen::Matrix<double, kStages + 2, 1> at, result;
  at << 0, node, 1;
  for (int j = 0; j < kStages + 2; ++j) {
    double value = 1;
    for (int i = 0; i < kStages + 2; ++i)
      if (i != j) value *= (place - at[i]) / (at[j] - at[i]);
    result[j] = value;
  }
  return result;
}

const Collocation& collocation() {
  static const Collocation made = make();
  return made;
}

}  // namespace evenload
