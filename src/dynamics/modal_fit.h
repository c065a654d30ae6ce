// Modes from a measured frequency response of one axis.
//
// Modes are added where what is left is largest, and each time all frequencies and damping ratios
// are fitted to the complex response by damped least squares; masses and what lies outside of the
// band (a stiffness above, a mass below) enter linearly and are solved for within.
// Law: the response of modes, with noise of a few percent, gives these modes back.
#pragma once

#include <complex>
#include <vector>

#include "dynamics/modes.h"

namespace evenload {

struct ModalFit {
  std::vector<Mode> modes;     // by rising frequency, direction 0
  double stiffness_above = 0;  // 1/k of modes above the band, m/N
  double mass_below = 0;       // 1/m of modes below it, 1/kg
  double error = 0;            // root mean square of what is left over that of the response
  std::complex<double> at(double angular_frequency) const;
};

// frequencies in rad/s, values in m/N along the axis. Throws std::invalid_argument for fewer lines
// than 4 for each mode, and where a mode would have no positive mass.
ModalFit fit_modes(const std::vector<double>& frequencies,
                   const std::vector<std::complex<double>>& values, int modes);

}  // namespace evenload
