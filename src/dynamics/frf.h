// A measured frequency response of the tool's tip: receptances at rising frequencies.
//
// Between the lines it is a cubic through neighbours. Below the first line it goes on with that
// line's real part, above the last one it falls as a free mass does, with 1/w^2. Negative
// frequencies are the conjugates.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

#include "dynamics/modes.h"

namespace evenload {

// m/N, displacement (x, y) by force (x, y) at an angular frequency in rad/s.
using Receptance = std::function<Eigen::Matrix2cd(double)>;

class Frf {
 public:
  using Values = std::vector<std::complex<double>>;

  // frequencies in rad/s; values of the displacement along x by a force along x, y by y and x by y,
  // in m/N, as many as there are frequencies; those left empty are 0. Throws std::invalid_argument
  // for fewer than four lines, frequencies that do not rise, numbers that are not finite.
  Frf(std::vector<double> frequencies, Values xx, Values yy, Values xy);

  Eigen::Matrix2cd operator()(double angular_frequency) const;
  const std::vector<double>& frequencies() const { return frequencies_; }

 private:
  std::vector<double> frequencies_;
  std::vector<Eigen::Matrix2cd> values_;
};

// The receptance in a frame that is turned by `angle` rad.
Receptance turned(const Receptance& receptance, double angle);

}  // namespace evenload
