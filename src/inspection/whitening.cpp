#include "inspection/whitening.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/solvers.h"

namespace evenload {

Eigen::MatrixXd whitening(const Columns& gradients) {
  const Eigen::Index freedom = gradients.rows();
  if (freedom == 0) return Eigen::MatrixXd(0, 0);
  // Units first, so that what is small by its unit alone is not taken for nothing.
  Eigen::VectorXd unit = gradients.rowwise().norm();
  const double largest = unit.maxCoeff();
  for (double& each : unit) each = each > kLeastShare * largest ? 1 / each : 0;
  Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(freedom, freedom);
  moments.selfadjointView<Eigen::Lower>().rankUpdate(gradients);
  moments = moments.selfadjointView<Eigen::Lower>();
  moments = unit.asDiagonal() * moments * unit.asDiagonal();
  const Axes found = axes_of(moments);
  const double least = kLeastShare * kLeastShare * found.values.maxCoeff();
  const double mean = std::sqrt(static_cast<double>(gradients.cols()));
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < freedom; ++k)
    if (found.values[k] > std::max(least, 1e-15 * found.values.maxCoeff())) kept.push_back(k);
  Eigen::MatrixXd result(freedom, static_cast<Eigen::Index>(kept.size()));
  for (Eigen::Index column = 0; column < result.cols(); ++column) {
    const Eigen::Index k = kept[static_cast<std::size_t>(column)];
    result.col(column) =
        mean / std::sqrt(found.values[k]) * (unit.asDiagonal() * found.vectors.col(k));
  }
  return result;
}

}  // namespace evenload
