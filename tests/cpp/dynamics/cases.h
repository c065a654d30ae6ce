// The milling processes that the tests of dynamics/ share. Their multipliers, depths and surfaces
// come from an independent computation by two methods (piecewise collocation and time simulation).
#pragma once

#include <cmath>
#include <vector>

#include "dynamics/milling.h"

namespace evenload::dynamics_cases {

inline constexpr double kLead = 0.05441398092702654;  // m: 30 degrees at a diameter of 10 mm

inline double degrees(double angle) { return angle * M_PI / 180; }
inline double hertz(double frequency) { return 2 * M_PI * frequency; }
inline double rpm(double speed) { return speed * M_PI / 30; }

// The mode of the benchmark of [Insperger & Stepan 2004].
inline Mode benchmark_mode(double direction_deg = 0) {
  return {0.03993, 2 * M_PI * 922, 0.011, degrees(direction_deg)};
}
inline std::vector<Mode> isotropic() { return {benchmark_mode(0), benchmark_mode(90)}; }
inline std::vector<Mode> unequal() {
  return {{0.1, 2 * M_PI * 700, 0.02, 0}, {0.05, 2 * M_PI * 1300, 0.015, M_PI / 2}};
}

inline Milling milling(std::vector<Mode> modes, int teeth, bool climb, double immersion,
                       double lead = 0) {
  Milling m;
  m.modes = std::move(modes);
  m.teeth = teeth;
  m.tangential = 6e8;
  m.normal = 2e8;
  m.climb = climb;
  m.engagement = std::acos(1 - 2 * immersion);
  m.radius = 5e-3;
  m.lead = lead;
  return m;
}

inline Milling slot() { return milling({benchmark_mode()}, 2, true, 1.0); }
inline Milling half(bool climb) { return milling({benchmark_mode()}, 2, climb, 0.5); }
inline Milling islands() { return milling({benchmark_mode()}, 2, true, 0.7, 0.01); }
inline Milling unequal_helix() { return milling(unequal(), 4, true, 0.25, kLead); }
inline Milling uneven() {
  Milling m = milling(unequal(), 4, true, 0.5, kLead);
  m.tooth_angles = {degrees(70), degrees(110), degrees(70), degrees(110)};
  return m;
}
inline Milling with_flank() {
  Milling m = milling(isotropic(), 4, true, 0.25);
  m.process_damping = 6e5;
  m.flank_friction = 0.3;
  return m;
}

}  // namespace evenload::dynamics_cases
