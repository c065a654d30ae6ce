// Whether vibration grows or dies: the Floquet multipliers of the milling process.
//
// The largest modulus rho of a multiplier is what one period does to the vibration: below 1 the cut
// is stable. A multiplier that leaves the unit circle as a complex pair is a Hopf bifurcation,
// quasi-periodic chatter, at -1 a period doubling (flip), found only in interrupted cuts.
// Laws: depth 0 leaves exp(-zeta wn T) of the least damped mode; force coefficients, depth and
// 1/mass scale out without helix; two equal modes at right angles know neither climb nor feed
// direction; equal pitch angles given as uneven ones yield powers.
// Tolerance: `accuracy` is the error of rho that is aimed at, relative where rho is above 1.
// Source: [Insperger & Stepan 2011] for the model; collocation in place of semi-discretisation.
#pragma once

#include <complex>
#include <vector>

#include "dynamics/periodic_system.h"

namespace evenload {

inline constexpr double kAccurate = 1e-5;

// The largest first, at least `wanted` of them accurate where there are so many.
std::vector<std::complex<double>> multipliers(const PeriodicSystem& system, double accuracy,
                                              int wanted = 1, int refinement = 1);

// speed in rad/s, depth in m. Throws std::invalid_argument as check() and for accuracy <= 0.
std::vector<std::complex<double>> multipliers(const Milling& milling, double speed, double depth,
                                              double accuracy, int wanted);
double spectral_radius(const Milling& milling, double speed, double depth, double accuracy);

// The least depth in m, up to `largest`, from which on the cut is unstable; infinite where there is
// none. Islands that are shallower than a 200th of `largest` may be overlooked, unless rho comes
// near 1 in them.
double critical_depth(const Milling& milling, double speed, double largest,
                      double accuracy = kAccurate);

enum class BoundaryKind { kHopf, kFlip, kFold };
// By the angle of the multiplier that is largest.
BoundaryKind kind_of(const std::complex<double>& multiplier);

// The multiplier of largest modulus and the vibration that it belongs to, a sum of parts with the
// frequencies |arg mu|/T + 2 pi r/T and their mirror images: `frequency` is that of the strongest
// part at the tool's tip, in rad/s.
struct Vibration {
  std::complex<double> multiplier;
  double frequency;
};
Vibration strongest_vibration(const PeriodicSystem& system, double accuracy = kAccurate);

}  // namespace evenload
