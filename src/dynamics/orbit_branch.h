// A branch of periodic motions, followed in the depth of cut around its folds.
//
// Pseudo-arclength continuation from a shallow cut on: where two motions meet and vanish the branch
// turns back, a fold, at which a multiplier is 1. Between two folds up to three motions exist at
// one depth. It ends where it leaves the range of depths. Source: [Bachrathy 2013, thesis 5];
// continuation: [Keller 1977].
#pragma once

#include <complex>
#include <vector>

#include "dynamics/orbit.h"
#include "support/progress.h"

namespace evenload {

struct BranchPoint {
  double depth = 0, amplitude = 0;                // m
  std::vector<std::complex<double>> multipliers;  // the largest first
  bool is_fold = false;
  bool is_wanted = false;  // at a depth that was asked for
  Orbit orbit;
  double radius() const { return std::abs(multipliers.front()); }
};

struct OrbitBranch {
  std::vector<BranchPoint> points;      // in the branch's order, folds among them
  std::vector<BranchPoint> boundaries;  // where a stable motion loses or gains stability
};

// Depths in m: from the least of `depths` to the largest; each gets points of its own. Throws
// std::invalid_argument for depths that are not above 0.
OrbitBranch follow_branch(const OrbitSolver& solver, std::vector<double> depths,
                          Progress& progress);

}  // namespace evenload
