// What is solved by Eigen, each once: its templates take long to compile, so that none of them is
// used in two files, nor for a second size of matrices that is known beforehand.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>

namespace evenload {

// x of square x = right; by rows that are exchanged for the larger pivot, so that a matrix without
// an inverse gives what is not finite, or not near.
Eigen::VectorXd solved(const Eigen::MatrixXd& square, const Eigen::VectorXd& right);
Eigen::VectorXcd solved(const Eigen::MatrixXcd& square, const Eigen::VectorXcd& right);

// The same for each column of `right`.
Eigen::MatrixXd columns_solved(const Eigen::MatrixXd& square, const Eigen::MatrixXd& right);

// The same of a symmetric matrix.
Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& symmetric, const Eigen::VectorXd& right);

// The same where rows and columns are exchanged for the largest pivot; with a square without an
// inverse one of the solutions, where there is one.
Eigen::VectorXd solved_carefully(const Eigen::MatrixXd& square, const Eigen::VectorXd& right);

// The same; nothing of a square that has no inverse.
std::optional<Eigen::VectorXd> solved_if_regular(const Eigen::MatrixXd& square,
                                                 const Eigen::VectorXd& right);

std::complex<double> determinant(const Eigen::MatrixXcd& square);

bool is_positive_definite(const Eigen::MatrixXd& symmetric);

// The quasi-triangular matrix that is similar to a Hessenberg matrix: its eigenvalues are those of
// the blocks of one and two rows on its diagonal [Golub and Van Loan, real Schur form].
Eigen::MatrixXd schur_form(const Eigen::MatrixXd& hessenberg);

struct Axes {
  Eigen::VectorXd values;   // ascending
  Eigen::MatrixXd vectors;  // in columns, of length 1
};

// Eigenvalues and eigenvectors of a symmetric matrix.
Axes axes_of(const Eigen::MatrixXd& symmetric);

// The shortest x of those for which |matrix x - goal| is least.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& goal);

// What is at right angles to all columns, in columns of length 1 that are at right angles to each
// other. dependent: share of the largest column that is taken for rounding.
Eigen::MatrixXd complement(const Eigen::MatrixXd& columns, double dependent);

}  // namespace evenload
