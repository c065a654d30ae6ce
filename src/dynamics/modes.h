// Modes of vibration at the tool's tip, and the receptance they add up to.
//
// A mode is a damped oscillator along one direction of the plane: m q'' + 2 m zeta w q' + m w^2 q =
// the force along it. Units in all of dynamics/: kg, m, s, N, rad.
// Laws: receptance(modes, -w) is the conjugate of receptance(modes, w); it is symmetric; at w = 0
// it is the sum of 1/k along the directions.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace evenload {

struct Mode {
  double mass = 0;           // kg, > 0
  double frequency = 0;      // natural, undamped, rad/s, > 0
  double damping_ratio = 0;  // >= 0
  double direction = 0;      // rad, counter-clockwise from x
};

// Throws std::invalid_argument where there is no mode, or one with a number that cannot be.
void check_modes(const std::vector<Mode>& modes);

// m/N, displacement (x, y) by force (x, y) at `angular_frequency` rad/s.
Eigen::Matrix2cd receptance(const std::vector<Mode>& modes, double angular_frequency);

// The same of one mode along its own direction.
std::complex<double> receptance(const Mode& mode, double angular_frequency);

// The modes in a frame that is turned by `angle` rad.
std::vector<Mode> turned(const std::vector<Mode>& modes, double angle);

}  // namespace evenload
