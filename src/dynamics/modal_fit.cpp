#include "dynamics/modal_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/complex.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kFirstDamping = 0.02;
constexpr double kLeastDamping = 1e-5, kMostDamping = 0.5;
constexpr int kSteps = 80;
constexpr double kSettled = 1e-10;    // relative, of the sum of squares
constexpr double kDifference = 1e-6;  // of a parameter
constexpr int kSmooth = 2;            // lines on either side whose mean tells a peak

class Fitter {
 public:
  Fitter(const std::vector<double>& frequencies, const std::vector<Complex>& values)
      : w_(frequencies), count_(static_cast<Eigen::Index>(frequencies.size())), data_(2 * count_) {
    for (Eigen::Index i = 0; i < count_; ++i) {
      const Complex value = values[static_cast<std::size_t>(i)];
      data_[2 * i] = value.real();
      data_[2 * i + 1] = value.imag();
    }
  }

  // ln of each frequency and damping ratio: neither can become negative.
  Eigen::VectorXd parameters() const { return parameters_; }

  // What is left of the response with the best masses for these parameters.
  Eigen::VectorXd left(const Eigen::VectorXd& p, Eigen::VectorXd* shares = nullptr) const {
    const Eigen::Index modes = p.size() / 2;
    Eigen::MatrixXd columns(2 * count_, modes + 2);
    for (Eigen::Index i = 0; i < count_; ++i) {
      const double w = w_[static_cast<std::size_t>(i)];
      for (Eigen::Index r = 0; r < modes; ++r) {
        const double own = std::exp(p[2 * r]), damping = std::exp(p[2 * r + 1]);
        const Complex value = 1.0 / Complex(own * own - w * w, 2 * damping * own * w);
        columns(2 * i, r) = value.real();
        columns(2 * i + 1, r) = value.imag();
      }
      columns(2 * i, modes) = 1;
      columns(2 * i + 1, modes) = 0;
      columns(2 * i, modes + 1) = -1 / std::max(w * w, w_[1] * w_[1]);
      columns(2 * i + 1, modes + 1) = 0;
    }
    const Eigen::VectorXd sizes = columns.colwise().norm();
    for (Eigen::Index c = 0; c < columns.cols(); ++c) columns.col(c) /= sizes[c];
    const Eigen::VectorXd solved = least_squares(columns, data_);
    if (shares) *shares = solved.cwiseQuotient(sizes);
    return data_ - columns * solved;
  }

  void add_mode() {
    const Eigen::VectorXd rest = parameters_.size() > 0 ? left(parameters_) : data_;
    Eigen::Index best = 0;
    double largest = -1;
    for (Eigen::Index i = kSmooth; i + kSmooth < count_; ++i) {
      double size = 0;
      for (Eigen::Index k = i - kSmooth; k <= i + kSmooth; ++k)
        size += std::hypot(rest[2 * k], rest[2 * k + 1]);
      if (size <= largest) continue;
      largest = size;
      best = i;
    }
    Eigen::VectorXd more(parameters_.size() + 2);
    more << parameters_, std::log(w_[static_cast<std::size_t>(best)]), std::log(kFirstDamping);
    parameters_ = more;
  }

  // Levenberg's and Marquardt's method.
  void improve() {
    double damping = 1e-3;
    Eigen::VectorXd rest = left(parameters_);
    for (int step = 0; step < kSteps; ++step) {
      Eigen::MatrixXd slopes(2 * count_, parameters_.size());
      for (Eigen::Index k = 0; k < parameters_.size(); ++k) {
        Eigen::VectorXd more = parameters_, less = parameters_;
        more[k] += kDifference;
        less[k] -= kDifference;
        slopes.col(k) = (left(more) - left(less)) / (2 * kDifference);
      }
      Eigen::MatrixXd square = slopes.transpose() * slopes;
      const Eigen::VectorXd gradient = slopes.transpose() * rest;
      bool is_better = false;
      double gain = 0;
      for (int attempt = 0; attempt < 12 && !is_better; ++attempt) {
        Eigen::MatrixXd lhs = square;
        lhs.diagonal() *= 1 + damping;
        Eigen::VectorXd change = -solved_symmetric(lhs, gradient);
        change = change.cwiseMax(-0.7).cwiseMin(0.7);
        const Eigen::VectorXd trial = bounded(parameters_ + change);
        const Eigen::VectorXd after = left(trial);
        gain = 1 - after.squaredNorm() / rest.squaredNorm();
        is_better = gain > 0;
        damping *= is_better ? 0.2 : 5;
        if (!is_better) continue;
        parameters_ = trial;
        rest = after;
      }
      if (!is_better || gain < kSettled) return;
    }
  }

  double size() const { return data_.norm(); }

 private:
  Eigen::VectorXd bounded(Eigen::VectorXd p) const {
    for (Eigen::Index r = 0; r < p.size(); r += 2) {
      p[r] = std::clamp(p[r], std::log(0.5 * std::max(w_.front(), 1e-3 * w_.back())),
                        std::log(2 * w_.back()));
      p[r + 1] = std::clamp(p[r + 1], std::log(kLeastDamping), std::log(kMostDamping));
    }
    return p;
  }

  std::vector<double> w_;
  Eigen::Index count_;
  Eigen::VectorXd data_, parameters_;
};

}  // namespace

Complex ModalFit::at(double w) const {
  Complex sum = stiffness_above - mass_below / (w * w);
  for (const Mode& mode : modes) sum += receptance(mode, w);
  return sum;
}

ModalFit fit_modes(const std::vector<double>& frequencies, const std::vector<Complex>& values,
                   int modes) {
  if (modes < 1) throw std::invalid_argument("At least one mode must be fitted.");
  if (frequencies.size() != values.size() ||
      frequencies.size() < 4 * static_cast<std::size_t>(modes) + 4)
    throw std::invalid_argument("The frequency response has too few lines for so many modes.");
  Fitter fitter(frequencies, values);
  for (int i = 0; i < modes; ++i) {
    fitter.add_mode();
    fitter.improve();
  }
  const Eigen::VectorXd p = fitter.parameters();
  Eigen::VectorXd shares;
  const double rest = fitter.left(p, &shares).norm();
  ModalFit fit;
  for (Eigen::Index r = 0; 2 * r < p.size(); ++r) {
    if (!(shares[r] > 0))
      throw std::invalid_argument(
          "A mode was found whose mass is not above 0: ask for fewer modes, or turn the sign of "
          "the response.");
    fit.modes.push_back({1 / shares[r], std::exp(p[2 * r]), std::exp(p[2 * r + 1]), 0});
  }
  std::sort(fit.modes.begin(), fit.modes.end(),
            [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  fit.stiffness_above = shares[modes];
  fit.mass_below = shares[modes + 1];
  fit.error = rest / fitter.size();
  return fit;
}

}  // namespace evenload
