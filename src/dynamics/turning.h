// Turning: speeds for interrupted cuts, and process damping by the flank.
//
// Interrupted cuts: a slot of width e is crossed in e/v. The free vibration that the tool's release
// starts should be in phase with its re-entry, so that v = e/(j Tn). A force that falls before the
// edge as 1 - exp(t/T_exit) and comes back after it as 1 - exp(-t/T_enter) shifts the phase:
//   v = e wn/theta,  wd theta = 2 pi j - atan2(wd ex, 1 + xi ex) - atan2(wd en, 1 - xi en),
// ex = wn T_exit, en = wn T_enter, wd = sqrt(1 - xi^2); exact for the phase. Smoothing raises v.
//
// The flank rubs on the wave just cut: force Ksp b A, A = integral of y(t) - y(t - s/v) over the
// contact length. That is a short regenerative effect; its expansion begins with the classical
// damper ell^2 y'/(2v), of order 1, and - ell^3 y''/(6 v^2), of order 2.
// Source: [Bachrathy 2013, theses 1 and 6].
#pragma once

#include <complex>
#include <vector>

#include "dynamics/modes.h"

namespace evenload {

// m/s, the fastest first: j = 1 to `count`. slot in m, frequency in rad/s, enter and exit are the
// products of the time constants with the natural frequency. Throws std::invalid_argument.
std::vector<double> interrupted_turning_speeds(double slot, double frequency, double damping_ratio,
                                               double enter, double exit, int count);

enum class FlankOrder { kNone, kFirst, kSecond, kExact };

struct TurningCut {
  Mode mode;
  double cutting_coefficient = 0;  // N/m^2
  double flank_coefficient = 0;    // N/m^3
  double flank_length = 0;         // m
  double diameter = 0;             // m
};
// A over y at a frequency in rad/s, m: the flank's area by the displacement, at a speed of the work
// in rad/s.
std::complex<double> flank_area(const TurningCut& cut, double speed, double frequency,
                                FlankOrder order);

struct TurningLimit {
  double width;      // m: the least at which the cut is unstable; infinite where there is none
  double frequency;  // rad/s
};
// At a speed of the work in rad/s. Throws std::invalid_argument for numbers that cannot be.
TurningLimit turning_limit(const TurningCut& cut, double speed, FlankOrder order);

}  // namespace evenload
