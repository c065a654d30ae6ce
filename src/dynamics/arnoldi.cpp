#include "dynamics/arnoldi.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dynamics/complex.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr int kFirstLook = 10;  // steps before the eigenvalues are looked at
constexpr int kLookAgain = 4;   // steps between two looks
constexpr int kMostSteps = 120;
constexpr int kWatched = 5;           // beside the wanted ones
constexpr double kExhausted = 1e-14;  // relative: what is left of a new vector is rounding

bool by_size(const Complex& a, const Complex& b) {
  const double size_a = std::norm(a), size_b = std::norm(b);
  // Conjugates have the same size to the last bits only.
  if (std::abs(size_a - size_b) > 1e-12 * std::max(size_a, size_b)) return size_a > size_b;
  return a.imag() > b.imag();
}

std::vector<Complex> eigenvalues(const Eigen::MatrixXd& hessenberg) {
  const Eigen::MatrixXd t = schur_form(hessenberg);
  std::vector<Complex> result;
  for (Eigen::Index i = 0; i < t.rows(); ++i) {
    if (i + 1 == t.rows() || t(i + 1, i) == 0) {
      result.emplace_back(t(i, i), 0);
      continue;
    }
    const double half = 0.5 * (t(i, i) - t(i + 1, i + 1));
    const double middle = 0.5 * (t(i, i) + t(i + 1, i + 1));
    const double under = half * half + t(i, i + 1) * t(i + 1, i);
    const double root = std::sqrt(std::abs(under));
    if (under < 0) {
      result.emplace_back(middle, root);
      result.emplace_back(middle, -root);
    } else {
      result.emplace_back(middle + root, 0);
      result.emplace_back(middle - root, 0);
    }
    ++i;
  }
  std::sort(result.begin(), result.end(), by_size);
  return result;
}

// The unit eigenvector of a Hessenberg matrix. Its last component times the next subdiagonal is the
// residual.
Eigen::VectorXcd eigenvector(const Eigen::MatrixXd& h, const Complex& value) {
  const Eigen::Index n = h.rows();
  Eigen::VectorXcd y = Eigen::VectorXcd::Zero(n);
  y[n - 1] = 1;
  for (Eigen::Index i = n - 1; i > 0; --i) {
    Complex sum = -value * y[i];
    for (Eigen::Index j = i; j < n; ++j) sum += h(i, j) * y[j];
    if (h(i, i - 1) == 0) break;
    y[i - 1] = -sum / h(i, i - 1);
  }
  return y.normalized();
}

struct Krylov {
  Eigen::MatrixXd basis, h;
  std::vector<Complex> found;
};

// A new column of the basis, from the one before. Whether there is one.
bool extend(Krylov& k, const Action& map, int step) {
  map(k.basis.col(step).data(), k.basis.col(step + 1).data());
  const double length = k.basis.col(step + 1).norm();
  for (int again = 0; again < 2; ++again) {
    const Eigen::VectorXd along = k.basis.leftCols(step + 1).transpose() * k.basis.col(step + 1);
    k.basis.col(step + 1).noalias() -= k.basis.leftCols(step + 1) * along;
    k.h.col(step).head(step + 1) += along;
  }
  const double left = k.basis.col(step + 1).norm();
  if (left <= kExhausted * length) return false;
  k.h(step + 1, step) = left;
  k.basis.col(step + 1) /= left;
  return true;
}

// Whether the largest eigenvalue cannot be another one, and those wanted are accurate.
bool is_accurate(const Krylov& k, int done, double tolerance, int wanted) {
  const double largest = std::abs(k.found.front());
  for (int i = 0; i < std::min(kWatched + wanted, done); ++i) {
    const Eigen::VectorXcd y = eigenvector(k.h.topLeftCorner(done, done), k.found[i]);
    const double residual = k.h(done, done - 1) * std::abs(y[done - 1]);
    if (residual <= tolerance * largest) continue;
    if (i < wanted || std::abs(k.found[i]) + residual > largest) return false;
  }
  return true;
}

Krylov krylov(const Action& map, int size, double tolerance, int wanted) {
  const int most = std::min(size, kMostSteps);
  Krylov k{Eigen::MatrixXd(size, most + 1), Eigen::MatrixXd::Zero(most + 1, most), {}};
  for (int i = 0; i < size; ++i) k.basis(i, 0) = 1 + 0.5 * std::sin(2.3 * i * i + 0.7 * i);
  k.basis.col(0).normalize();
  for (int step = 0; step < most; ++step) {
    const int done = step + 1;
    const bool is_last = !extend(k, map, step) || done == most;
    if (!is_last && (done < kFirstLook || (done - kFirstLook) % kLookAgain != 0)) continue;
    k.found = eigenvalues(k.h.topLeftCorner(done, done));
    if (is_last || is_accurate(k, done, tolerance, wanted)) break;
  }
  return k;
}

}  // namespace

std::vector<Complex> largest_eigenvalues(const Action& map, int size, double tolerance,
                                         int wanted) {
  return krylov(map, size, tolerance, wanted).found;
}

Eigenpair largest_eigenpair(const Action& map, int size, double tolerance) {
  const Krylov k = krylov(map, size, tolerance, 1);
  const auto done = static_cast<Eigen::Index>(k.found.size());
  const Eigen::VectorXcd y = eigenvector(k.h.topLeftCorner(done, done), k.found.front());
  return {k.found.front(), k.basis.leftCols(done).cast<Complex>() * y};
}

}  // namespace evenload
