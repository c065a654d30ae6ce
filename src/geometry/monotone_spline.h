// Monotone cubic splines: between values that rise or fall they do so too, without overshooting.
// [Fritsch and Carlson, SIAM Journal on Numerical Analysis 17, 1980; slopes after Fritsch and
// Butland 1984]
//
// Laws: passes its values; between two knots it lies between their values and is monotone; value
// and slope are continuous; two knots make a line; outside the knots it keeps the end's value.
#pragma once

#include <cstddef>
#include <vector>

namespace evenload {

class MonotoneSpline {
 public:
  MonotoneSpline() = default;
  // The same value everywhere.
  explicit MonotoneSpline(double value) : knots_{0}, values_{value}, slopes_{0} {}
  // Throws std::invalid_argument unless there are as many values as knots, one at least, all
  // finite, and the knots rise.
  MonotoneSpline(std::vector<double> knots, std::vector<double> values);

  double value(double x) const;
  double slope(double x) const;
  std::size_t pieces() const { return knots_.size() - 1; }

  bool operator==(const MonotoneSpline&) const = default;

 private:
  struct Place {
    std::size_t piece = 0;
    double t = 0, width = 1;  // share of the piece, and its width
    bool outside = false;
  };
  Place find(double x) const;

  std::vector<double> knots_{0}, values_{0}, slopes_{0};
};

}  // namespace evenload
