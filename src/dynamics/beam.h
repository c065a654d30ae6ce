// The tip's receptance of a slender tool in a holder: Timoshenko beams and receptance coupling.
//
// A segment has the state (w, theta, V, M): w' = theta + V/(kappa G A), theta' = M/(E I),
// V' = -rho A w^2 w, M' = -V - rho I w^2 theta, with kappa = 6(1 + nu)/(7 + 6 nu); loss makes E and
// G complex. Segments multiply to the transfer matrix from root to tip; free-free receptances
// follow, and are coupled to the holder's, in series with the joint's flexibility:
// G = R11 - R12 (R22 + Rh + 1/Kj)^-1 R21. A rigid holder has Rh = 0.
// Exact in the frequency; signs: forces and moments act on the segment's end.
// Laws: receptances are symmetric; two halves are the whole; the static one is L^3/3EI + L/kappaGA.
// Source: [Bachrathy 2013, thesis 4] for the beam; coupling: [Schmitz & Donaldson 2000].
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace evenload {

struct BeamMaterial {
  double youngs_modulus = 0, density = 0, poisson_ratio = 0;  // N/m^2, kg/m^3
  double loss_factor = 0;
};

// A cylinder; the first segment is at the tip.
struct BeamSegment {
  double length = 0, diameter = 0;  // m
  BeamMaterial material;
};

// Rows: displacement, rotation; columns: by force, by moment; m/N, rad/N, rad/(N m).
using EndReceptance = Eigen::Matrix2cd;

// The tip's, with the holder's at the root (0: rigid) and the joint's flexibility (0: rigid joint),
// at an angular frequency in rad/s from 0 on. Throws std::invalid_argument for segments that are
// none.
EndReceptance tip_receptance(const std::vector<BeamSegment>& segments,
                             const EndReceptance& holder_and_joint, double angular_frequency);

// What holder and joint have at the root, from the tip's receptance of a tool that was measured.
EndReceptance root_receptance(const std::vector<BeamSegment>& segments, const EndReceptance& tip,
                              double angular_frequency);

// Natural frequencies, rad/s, of the clamped segments without loss, below `highest`.
std::vector<double> clamped_frequencies(const std::vector<BeamSegment>& segments, double highest);

}  // namespace evenload
