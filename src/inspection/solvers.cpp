#include "inspection/solvers.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace evenload {

Axes axes_of(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(symmetric);
  return {found.eigenvalues(), found.eigenvectors()};
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& goal) {
  return matrix.completeOrthogonalDecomposition().solve(goal);
}

Eigen::MatrixXd complement(const Eigen::MatrixXd& columns, double dependent) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> found;
  found.setThreshold(dependent);
  found.compute(columns);
  const Eigen::MatrixXd all = found.householderQ();
  return all.rightCols(columns.rows() - found.rank());
}

}  // namespace evenload
