// Stability in the frequency domain, from modes or from a measured frequency response.
//
// A vibration with the frequencies w + k Wb neither grows nor dies when det(I + Phi(w_k) sum over
// teeth of H_(k-r) (1 - exp(-i w_r tau))) = 0, |k|, |r| <= K: the extended multi-frequency
// solution. Wb is the tooth-passing frequency where the pitch is even, else the spindle's; H_m the
// Fourier coefficients of the force matrix, closed forms for any helix. K = 0 is the zeroth order,
// which has a closed form, and cannot see period doubling.
// Laws: K to infinity tends to the multipliers of stability.h; depth p/N of an even helical tool
// gives the same for each K; K = 0 is the closed form.
// Source: [Bachrathy 2013, thesis 7]; zeroth order: [Altintas & Budak 1995].
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "dynamics/frf.h"
#include "dynamics/milling.h"

namespace evenload {

// Fourier coefficients of a tooth's force matrix over the angle of its tip, of any order; in the
// feed's frame, N/m. Times exp(i order psi_j) they are those of tooth j.
Eigen::Matrix2cd force_harmonic(const Milling& milling, double depth, int order);

class FrequencyDomain {
 public:
  // `receptance` in machine axes. Throws std::invalid_argument as check(), and for harmonics < 0.
  FrequencyDomain(const Milling& milling, const Receptance& receptance, int harmonics);

  // rad/s between two neighbouring frequencies of a vibration.
  double base(double speed) const;
  std::complex<double> determinant(double speed, double depth, double frequency) const;

  // The depth and the chatter frequency at which the determinant is 0, from a guess, by Newton's
  // method. Whether it was found.
  bool find_limit(double speed, double& depth, double& frequency) const;

  // How many vibrations grow: turns of the determinant around 0 over one base of frequencies;
  // for K = 0 over all frequencies up to `highest`, rad/s.
  int unstable_count(double speed, double depth, double highest) const;

 private:
  Milling milling_;
  Receptance receptance_;  // in the feed's frame
  int harmonics_;
};

struct ZerothOrder {
  double depth;  // m
  double phase;  // frequency times the teeth's period, 0 to 2 pi
};
// The limits at a chatter frequency, the least depth first. Condition: even pitch.
std::vector<ZerothOrder> zeroth_order(const Milling& milling, const Receptance& receptance,
                                      double frequency);

}  // namespace evenload
