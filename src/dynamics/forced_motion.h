// The vibration that the teeth force upon the tool where the cut is stable: periodic, and in closed
// form.
//
// Where the pitch is even the tool moves alike at each tooth's passing, so that the displacement of
// before drops out: Q_k = -fz Phi(k Wb) H_k e_x, k = 0 included, the static deflection. Uneven
// pitch has the period of a revolution, and all harmonics are coupled.
// Laws: it is the steady state of a simulation in time; at the depth p/N nothing but the static
// deflection is left; it is proportional to the feed per tooth.
// Source: [Bachrathy, Insperger & Stepan 2009], [Bachrathy 2013, thesis 2].
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "dynamics/frf.h"
#include "dynamics/milling.h"

namespace evenload {

inline constexpr int kForcedHarmonics = 60;

struct ForcedMotion {
  int order = 1;                            // periods in a turn of the spindle
  std::vector<Eigen::Vector2cd> harmonics;  // of exp(i k order angle), k = 0 on; frame: the feed's

  // m at a spindle angle in rad, and the first and second derivatives by it.
  struct State {
    Eigen::Vector2d value, slope, bend;
  };
  State at(double angle) const;
  // The component `axis`, 0 or 1, at `count` even steps of a period; count: a power of 2, more than
  // twice the harmonics.
  std::vector<double> samples(int axis, std::size_t count) const;
};

// speed in rad/s, depth and mean feed per tooth in m; at least `harmonics` of them. Condition:
// check(milling); its modes are not looked at.
ForcedMotion forced_motion(const Milling& milling, const Receptance& receptance, double speed,
                           double depth, double feed_per_tooth, int harmonics = kForcedHarmonics);

}  // namespace evenload
