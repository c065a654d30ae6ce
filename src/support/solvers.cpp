#include "support/solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace evenload {

Eigen::VectorXd solved(const Eigen::MatrixXd& square, const Eigen::VectorXd& right) {
  return square.partialPivLu().solve(right);
}

Eigen::VectorXcd solved(const Eigen::MatrixXcd& square, const Eigen::VectorXcd& right) {
  return square.partialPivLu().solve(right);
}

Eigen::MatrixXd columns_solved(const Eigen::MatrixXd& square, const Eigen::MatrixXd& right) {
  return square.partialPivLu().solve(right);
}

Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& symmetric, const Eigen::VectorXd& right) {
  return symmetric.ldlt().solve(right);
}

Eigen::VectorXd solved_carefully(const Eigen::MatrixXd& square, const Eigen::VectorXd& right) {
  return square.fullPivLu().solve(right);
}

std::optional<Eigen::VectorXd> solved_if_regular(const Eigen::MatrixXd& square,
                                                 const Eigen::VectorXd& right) {
  const Eigen::FullPivLU<Eigen::MatrixXd> found(square);
  if (!square.allFinite() || !found.isInvertible()) return std::nullopt;
  return found.solve(right);
}

std::complex<double> determinant(const Eigen::MatrixXcd& square) {
  return square.partialPivLu().determinant();
}

bool is_positive_definite(const Eigen::MatrixXd& symmetric) {
  return symmetric.llt().info() == Eigen::Success;
}

Eigen::MatrixXd schur_form(const Eigen::MatrixXd& hessenberg) {
  // A Hessenberg matrix needs no reduction.
  const Eigen::Index size = hessenberg.rows();
  Eigen::RealSchur<Eigen::MatrixXd> found(size);
  found.computeFromHessenberg(hessenberg, Eigen::MatrixXd::Identity(size, size), false);
  return found.matrixT();
}

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
