// What is solved here by Eigen, each once: its templates take long to compile, so that none of them
// is used for a second size of matrices that is known beforehand.
#pragma once

#include <Eigen/Core>

namespace evenload {

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
