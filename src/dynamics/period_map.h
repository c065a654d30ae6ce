// What one period does to the vibration, as a map that is applied to a vector: the matrix of the
// whole is never formed, and nothing is multiplied but small matrices with vectors.
//
// The period's active pieces are cut into elements, each a Gauss collocation; idle ones are passed
// exactly. The vector holds the modes' states at the period's end, and q at
// the elements' nodes. Where a delay is the period its values are those of the period before at
// the same nodes; others are interpolated by the collocation's own polynomial.
// Law: with elements half as long the error of a multiplier falls by about 2^(2 kStages) where the
// only delay is the period.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/periodic_system.h"

namespace evenload {

class PeriodMap {
 public:
  // `accuracy`: the error of multipliers that is aimed at, above 0; `refinement` cuts each element
  // into as many more. Condition: system.delays are above 0 and at most the period.
  PeriodMap(const PeriodicSystem& system, double accuracy, int refinement = 1);

  int size() const { return size_; }
  int elements() const { return static_cast<int>(elements_.size()); }
  // `after` = the map of `before`, both of size(), and not the same.
  void apply(const double* before, double* after) const;

  // Where the vector holds q at a node of an active element: its instant, and its share of time.
  struct Node {
    int place;
    double time, weight;
  };
  std::vector<Node> nodes() const;

 private:
  // Where the displacement of one delay at one node is found.
  struct Look {
    int first;  // place in the vector
    int count;  // of places, width_ apart
    bool now;   // in this period, else in the one before
    double weight[10];
  };
  struct Element {
    int first;  // place of its values in the vector
    bool active;
    Eigen::MatrixXd from;         // (values, state) from (state, delayed force)
    std::vector<double> delayed;  // matrices of delayed forces, for each delay and node
    std::vector<Look> looks;      // the same order
  };

  void add_idle(const PeriodicSystem& system, double length);
  void add_active(const PeriodicSystem& system, double start, double length);
  void find_looks(const PeriodicSystem& system);
  void gather(const Element& element, const double* before, const double* after,
              double* force) const;

  int width_, state_, slots_, size_;
  bool looks_straight_back_;  // the only delay is the period
  std::vector<Element> elements_;
  std::vector<double> starts_, lengths_;  // of the elements
};

}  // namespace evenload
