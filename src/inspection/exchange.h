// The best step where all deviations are taken for linear, by exchange.
//
// Smallest t for which every |value + gradient * step| <= t (without the bars where deviations have
// no sign), while no number of the step exceeds `reach`. This is a linear programme in few
// variables: a basis of as many bounds as variables is kept in balance by multipliers >= 0, and the
// point that lies furthest outside takes the place of one of them until none does.
// Sources: E. Stiefel, Über diskrete und lineare Tschebyscheff-Approximationen, 1959; it is the
// dual simplex method. Laws: multipliers are >= 0; they sum to 1, and what their gradients leave is
// balanced by the reach. Points outside the present candidates are looked at by all of them at
// once, so that a million points cost some passes over them.
#pragma once

#include <vector>

#include "inspection/deviations.h"

namespace evenload {

// A point that touches the zone.
struct Contact {
  Eigen::Index point;
  int side;  // 1: where deviations are positive, -1: where they are negative
  double multiplier;
};

struct ExchangeStep {
  Eigen::VectorXd step;
  double level;  // t, or a bound below it where is_solved is false
  std::vector<Contact> contacts;
  bool is_solved;
};

inline constexpr int kMostFreedom = 6;

// `rounding`: by which a point may lie outside. Conditions: at least one point, `reach` > 0, at
// most kMostFreedom degrees of freedom.
ExchangeStep best_linear_step(const Rows& rows, bool is_two_sided, double reach, double rounding);

// Multipliers that balance slopes, a column for each point that touches: above 0 for each point
// that can take part in a balance with them, else 0. Their sum is any; all 0 where no step is held.
Eigen::VectorXd shared_multipliers(const Columns& slopes);

}  // namespace evenload
