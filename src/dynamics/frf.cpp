#include "dynamics/frf.h"

#include <algorithm>
#include <cmath>

#include "support/demand.h"

namespace evenload {

namespace {

bool is_finite(const std::complex<double>& value) {
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

}  // namespace

Frf::Frf(std::vector<double> frequencies, Values xx, Values yy, Values xy)
    : frequencies_(std::move(frequencies)) {
  const std::size_t count = frequencies_.size();
  demand(count >= 4, "The frequency response has too few lines: at least four are needed.");
  for (std::size_t i = 0; i < count; ++i) {
    demand(std::isfinite(frequencies_[i]) && frequencies_[i] >= 0,
           "The frequencies of the frequency response must be numbers from 0 on.");
    demand(i == 0 || frequencies_[i] > frequencies_[i - 1],
           "The frequencies of the frequency response must rise from line to line.");
  }
  for (Values* values : {&xx, &yy, &xy}) {
    if (values->empty()) values->assign(count, 0);
    demand(values->size() == count, "The frequency response needs one value for each frequency.");
    demand(std::all_of(values->begin(), values->end(), is_finite),
           "The frequency response has a value that is no number.");
  }
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Matrix2cd value;
    value << xx[i], xy[i], xy[i], yy[i];
    values_.push_back(value);
  }
}

Eigen::Matrix2cd Frf::operator()(double w) const {
  if (w < 0) return (*this)(-w).conjugate();
  const std::vector<double>& f = frequencies_;
  if (w <= f.front()) return values_.front().real().cast<std::complex<double>>();
  if (w >= f.back()) return values_.back() * (f.back() * f.back() / (w * w));
  const auto above = std::upper_bound(f.begin(), f.end(), w);
  const auto i = static_cast<std::size_t>(above - f.begin()) - 1;
  // The derivative at a line, from the parabola through it and its neighbours.
  const auto slope = [&](std::size_t k) -> Eigen::Matrix2cd {
    const std::size_t middle = std::clamp<std::size_t>(k, 1, f.size() - 2);
    const double left = f[middle] - f[middle - 1], right = f[middle + 1] - f[middle];
    const Eigen::Matrix2cd before = (values_[middle] - values_[middle - 1]) / left;
    const Eigen::Matrix2cd after = (values_[middle + 1] - values_[middle]) / right;
    const Eigen::Matrix2cd bend = (after - before) / (left + right);
    return before + bend * (2 * f[k] - f[middle - 1] - f[middle]);
  };
  const double h = f[i + 1] - f[i], t = (w - f[i]) / h;
  return values_[i] * ((1 + 2 * t) * (1 - t) * (1 - t)) + slope(i) * (h * t * (1 - t) * (1 - t)) +
         values_[i + 1] * (t * t * (3 - 2 * t)) - slope(i + 1) * (h * t * t * (1 - t));
}

Receptance turned(const Receptance& receptance, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return [receptance, turn](double w) -> Eigen::Matrix2cd {
    return turn.transpose() * receptance(w) * turn;
  };
}

}  // namespace evenload
