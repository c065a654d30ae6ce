#include "inspection/least_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "inspection/whitening.h"

namespace evenload {

namespace {

constexpr double kLeastStep = 1e-16;  // of the size of all
constexpr double kMostDamping = 1e12;

double imbalance_of(const Rows& rows) {
  double worst = 0;
  for (Eigen::Index k = 0; k < rows.gradients.rows(); ++k) {
    const auto terms = rows.gradients.row(k).transpose().cwiseProduct(rows.values);
    const double all = terms.cwiseAbs().sum();
    if (all > 0) worst = std::max(worst, std::abs(terms.sum()) / all);
  }
  return worst;
}

}  // namespace

LeastSquares least_squares(std::unique_ptr<Deviations> start, int most_steps) {
  LeastSquares best{std::move(start), {}, 0, 0};
  best.rows = best.at->rows();
  best.sum = best.rows.values.squaredNorm();
  double damping = 0;
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::MatrixXd directions = whitening(best.rows.gradients);
    // Along these the moments are the unit matrix times the number of points.
    const Eigen::VectorXd step = directions.transpose() * (best.rows.gradients * best.rows.values) /
                                 (-static_cast<double>(best.rows.values.size()) * (1 + damping));
    if (!(step.norm() > kLeastStep) || damping > kMostDamping) break;
    std::unique_ptr<Deviations> at = best.at->moved(directions * step);
    Rows rows = at->rows();
    const double sum = rows.values.squaredNorm();
    if (sum < best.sum) {
      best = {std::move(at), std::move(rows), sum, 0};
      damping = damping > 1e-3 ? damping / 8 : 0;
    } else {
      if (step.norm() < 1e-12) break;
      damping = std::max(0.25, 8 * damping);
    }
  }
  best.imbalance = imbalance_of(best.rows);
  return best;
}

}  // namespace evenload
