// The place of a feature or part at which the largest deviation is smallest.
//
// Each step is the best one where deviations are taken for linear within a reach, found by
// exchange; it is taken where the true peak falls, else the reach shrinks. With as many contacts as
// such a programme has unknowns this converges quadratically, as Newton's method does; with fewer
// Newton's step to the balance of the contacts joins in. Sources: K. Madsen, J. Hald, Combined LP
// and quasi-Newton methods for minimax optimization, 1981; R. Fletcher, E. Sainz de la Maza,
// Nonlinear programming by successive linear programming, 1989. Law: the peak never rises by more
// than rounding, so it ends no higher than it begins.
#pragma once

#include <limits>
#include <memory>

#include "inspection/certificate.h"

namespace evenload {

// Deviations of points whose size is 1 are wrong by some units of their last place.
inline constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

struct Optimum {
  std::unique_ptr<Deviations> at;
  Eigen::VectorXd values;
  double peak;
  Certificate certificate;
};

// `rounding`: by which deviations may be wrong. Lengths are about 1: the points are scaled.
Optimum smallest_peak(std::unique_ptr<Deviations> start, double rounding);

}  // namespace evenload
