// The place at which the sum of squared deviations is smallest, from a start near it.
//
// Gauss and Newton's steps along whitened directions, damped where the sum would rise (Levenberg
// and Marquardt). Law: the sum never rises.
#pragma once

#include <memory>

#include "inspection/deviations.h"

namespace evenload {

struct LeastSquares {
  std::unique_ptr<Deviations> at;
  Rows rows;
  double sum;        // of squares
  double imbalance;  // |sum of value * gradient| / sum of |value * gradient|, the largest
};

LeastSquares least_squares(std::unique_ptr<Deviations> start, int most_steps = 100);

}  // namespace evenload
