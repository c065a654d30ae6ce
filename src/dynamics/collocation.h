// Gauss collocation on one element of time, scaled to 0..1.
//
// A function whose second derivative is the polynomial through its values at `node` is determined
// by its start, its first derivative there, and these values; collocated so, a smooth equation's
// ends have the error O(h^(2 kStages)), and all between O(h^(kStages + 2)).
#pragma once

#include <Eigen/Core>

namespace evenload {

inline constexpr int kStages = 6;

struct Collocation {
  using Values = Eigen::Matrix<double, kStages, 1>;
  using Square = Eigen::Matrix<double, kStages, kStages>;

  Values node;          // c
  Values weight;        // integral of each Lagrange polynomial from 0 to 1
  Square once, twice;   // from second derivatives to first ones and to values at the nodes
  Values weight_twice;  // from second derivatives to the value at 1

  // Values at start, nodes and end determine the polynomial; weights of its value at `place`.
  Eigen::Matrix<double, kStages + 2, 1> interpolation(double place) const;
};

const Collocation& collocation();

}  // namespace evenload
