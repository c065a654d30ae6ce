// Oscillators under a force that is linear in their displacement, velocity and displacements of
// before, with coefficients that repeat: what milling is to vibration.
//
//   modes driven by F(t) = -stiffness(t) q - damping(t) q' + sum over delays of delayed_j(t)
//   q(t - tau_j),   q = sum of the modes' displacements along their directions.
//
// Only q, of one or two components, enters the force: any number of modes costs hardly more than
// two do.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "dynamics/milling.h"

namespace evenload {

// A mode and its direction in the components of q.
struct Oscillator {
  double mass, frequency, damping_ratio;
  Eigen::Vector2d direction;
};

struct Coefficients {
  Eigen::Matrix2d stiffness, damping;
  std::vector<Eigen::Matrix2d> delayed;  // one for each delay
};

// A part of the period in which the coefficients are smooth.
struct PeriodPiece {
  double start, end;
  bool active;  // else all coefficients are 0
};

struct PeriodicSystem {
  std::vector<Oscillator> modes;
  int width = 2;  // components of q: 1 where all modes share a direction
  double period = 0;
  std::vector<PeriodPiece> pieces;  // from 0 to the period
  std::vector<double> delays;       // above 0, at most the period
  std::function<void(double, Coefficients&)> coefficients;
  // rad/s of the fastest vibration to be followed: the modes', raised by the force's stiffness.
  double fastest = 0;
};

// The linear milling process at a spindle speed in rad/s and a depth in m. Its period is the
// passing of a tooth where the pitch is even, else a revolution. Condition: what check() demands.
PeriodicSystem milling_system(const Milling& milling, double speed, double depth);

// The modes in components of q, and the direction of these in the frame: the columns of the matrix.
struct Components {
  std::vector<Oscillator> modes;
  Eigen::Matrix2d basis;  // frame = basis * q; its second column counts only where width is 2
  int width;
};
Components components_of(const std::vector<Mode>& modes);

// The pieces of a period between sorted or unsorted instants, which may lie in other periods.
std::vector<PeriodPiece> pieces_between(std::vector<double> instants, double period);

}  // namespace evenload
