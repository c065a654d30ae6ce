// The largest eigenvalues of a linear map that is known by its action alone.
//
// Arnoldi's method with full orthogonalisation: the map's matrix is never formed. It ends once the
// residual of the largest eigenvalue is below the tolerance, or the whole space is spanned.
// Deterministic: it starts from a fixed vector.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

namespace evenload {

using Action = std::function<void(const double* before, double* after)>;

// The largest first; those with an imaginary part in conjugate pairs. `wanted`: how many of them
// must be accurate to `tolerance`, relative to the largest; those that follow are rough.
std::vector<std::complex<double>> largest_eigenvalues(const Action& map, int size, double tolerance,
                                                      int wanted = 1);

struct Eigenpair {
  std::complex<double> value;
  Eigen::VectorXcd vector;  // of size 1
};
Eigenpair largest_eigenpair(const Action& map, int size, double tolerance);

}  // namespace evenload
