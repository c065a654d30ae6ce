// Cutting force of an end mill from the arcs of its cylinder that touch material: the mechanistic
// model with edge terms (linear in the chip thickness), summed over the teeth and along the helix.
//
// Feed frame: x along the feed, y to its left, angles counter-clockwise from the feed. The spindle
// turns clockwise seen from above; the flutes are right-handed, so that at height z above the tip
// a tooth is at the angle psi + z tan(helix) / r, where psi is the tip's angle. At the angle a the
// chip is h = f_z cos(a) thick, and a tooth of length dz on the workpiece exerts
//   tangentially  (ktc h + kte) dz  along (sin a, -cos a), the way the tooth moves,
//   radially      (krc h + kre) dz  along (cos a, sin a), outwards.
// The edge terms act wherever the tooth is engaged. Not modelled: the axial force, run-out,
// deflection, a flute that ends below the arc's depth.
//
// Laws: no engagement, no force; arcs that lie side by side are one arc; mean power = mean torque
// times angular speed; the means of x, y and torque do not depend on the helix; where the depth is
// a multiple of pitch / teeth the force is constant [Bachrathy 2013]; straight flutes are the limit
// of a vanishing helix.
// Tolerance: the means of x, y and torque are exact. A peak is never above the true one and lacks
// at most kPeakShare of it; the mean of xy is within kPeakShare, too.
#pragma once

#include <cstddef>
#include <vector>

#include "cutting/engaged_arc.h"

namespace evenload {

// Of one tooth: F = (k_c h + k_e) times the axial depth.
struct ForceCoefficients {
  double ktc = 0, krc = 0;  // N/mm^2: tangential and radial, of the chip
  double kte = 0, kre = 0;  // N/mm: tangential and radial, of the edge
};

// Over one revolution. Forces in N on the workpiece, as a dynamometer under it reads them.
struct CuttingForce {
  double peak_x = 0, peak_y = 0;            // largest absolute values
  double peak_xy = 0;                       // largest hypot(x, y)
  double mean_x = 0, mean_y = 0;            // with their signs
  double mean_xy = 0;                       // of hypot(x, y)
  double peak_torque = 0, mean_torque = 0;  // N m
  double mean_power = 0;                    // W
};

inline constexpr double kPeakShare = 2e-3;

class ForceModel {
 public:
  // radius in mm, helix angle in rad (0 = straight flutes). Throws std::invalid_argument unless
  // radius > 0, teeth >= 1, 0 <= helix_angle < pi/2 and no coefficient is negative.
  ForceModel(const ForceCoefficients& coefficients, double tool_radius, int teeth,
             double helix_angle);

  // The force at `feed_per_tooth` mm and `spindle_speed` rev/min while the tool touches `count`
  // arcs that do not overlap. x and y are the axes of the frame in which the feed points to
  // `feed_angle` rad: 0 gives the feed frame, the feed's direction in the machine the machine's
  // axes. Throws std::invalid_argument for arcs that break EngagedArc's condition and for negative
  // or infinite numbers.
  CuttingForce force(const EngagedArc* arcs, std::size_t count, double feed_per_tooth,
                     double spindle_speed, double feed_angle = 0) const;

 private:
  ForceCoefficients coefficients_;
  double radius_;
  int teeth_;
  double lag_;  // rad of helix lag per mm of height
  struct Turn {
    double c, s;
  };
  std::vector<Turn> half_tooth_angles_;  // cosine and sine of half of every tooth's angle
};

}  // namespace evenload
