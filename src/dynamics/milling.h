// The milling process as vibration sees it: which tooth cuts when, and the matrix that turns
// displacement into force.
//
// Frame: looking down the spindle, which turns clockwise; x along the feed, y to its left, z up
// the tool from its tip. Tooth j stands at R(sin phi, cos phi), phi_j(t, z) = W t + psi_j - kappa z
// with W the spindle's angular speed and kappa = 2 pi/lead. It cuts while phi (mod 2 pi) lies
// between entry and exit: 0 to theta in conventional milling, pi - theta to pi in climb.
// At a displacement q of the tool the force of tooth j on it changes by -H_j(t) (q(t) - q(t -
// tau_j)), H_j = integral over the depth of (Kt tangent + Kn normal) normal^T, normal = (sin phi,
// cos phi), tangent = (cos phi, -sin phi); tau_j is the time to the tooth ahead, which cut before.
// The flank adds -(C/vc) (normal + mu tangent) normal^T q' per depth.
//
// H is a closed form for any helix, without slices. Laws: depth p/N of an even helical tool makes
// the sum of the H_j constant; lead to infinity tends to straight teeth.
// Source: [Bachrathy 2013], theses 2, 6, 7; the mechanistic force model is Altintas'.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/modes.h"

namespace evenload {

struct Milling {
  std::vector<Mode> modes;           // in machine axes
  int teeth = 2;                     // 1 or more
  double tangential = 0;             // N/m^2, > 0
  double normal = 0;                 // N/m^2, >= 0
  bool climb = true;                 // else conventional
  double engagement = 0;             // rad, above 0 and at most pi
  double radius = 0;                 // m
  double lead = 0;                   // m, axial length of one turn of the helix; 0 = straight teeth
  std::vector<double> tooth_angles;  // rad, to the tooth ahead, sum 2 pi; empty = even
  double feed_direction = 0;         // rad, of the feed in machine axes
  double process_damping = 0;        // N/m, C of the flank
  double flank_friction = 0;         // mu of the flank

  bool even() const { return tooth_angles.empty(); }
  double entry() const;                        // rad
  double exit() const;                         // rad
  double period_angle() const;                 // rad of the spindle after which all repeats
  double twist() const;                        // kappa, rad per m of height
  double pitch(int tooth) const;               // rad to the tooth ahead
  std::vector<double> positions() const;       // psi_j, rad
  std::vector<Mode> modes_along_feed() const;  // in the frame above
};

// Throws std::invalid_argument, in one sentence, for numbers that cannot be.
void check(const Milling& milling);
void check_speed_and_depth(double speed, double depth);

// (integral of 1, of sin 2 phi, of cos 2 phi) over what is engaged.
using Engaged = Eigen::Vector3d;

// Over the depth, in m, of a tooth whose tip is at `angle`.
Engaged engaged_depth(const Milling& milling, double angle, double depth);

// The integral of (tangential t + normal n) n^T with these coefficients.
Eigen::Matrix2d force_matrix(double tangential, double normal, const Engaged& engaged);

// Angles of the tip, 0 to 2 pi, at which a tooth at psi = 0 begins or ends to enter or to leave.
std::vector<double> switching_angles(const Milling& milling, double depth);

}  // namespace evenload
