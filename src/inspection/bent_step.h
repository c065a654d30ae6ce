// The best step where the peak is bent.
//
// Smallest t + step * bends * step / 2 with every |value + gradient * step| <= t. Its dual is to
// find multipliers >= 0 of sum 1; a point that lies outside joins those that touch, and who would
// get a multiplier below 0 leaves (the active set method of quadratic programmes). It finds its
// contacts by itself, also where they are fewer than one more than the degrees of freedom.
#pragma once

#include "inspection/exchange.h"

namespace evenload {

// `bends`: symmetric and positive definite. `rounding` as in best_linear_step.
ExchangeStep best_bent_step(const Rows& rows, bool is_two_sided, const Eigen::MatrixXd& bends,
                            double rounding);

}  // namespace evenload
