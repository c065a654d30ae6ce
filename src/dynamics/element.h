// How oscillators answer within one element of time, without and with forces at its nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/periodic_system.h"

namespace evenload {

// A mode's state is its displacement and its velocity over its frequency, which are of one size:
// the largest eigenvalues of what maps states are found with fewer steps.

// The state after `time`, from that before: exact.
Eigen::Matrix2d free_motion(const Oscillator& mode, double time);

// Displacements q and velocities at the nodes, node by node, and the modes' states mode by mode
// at the end, by the state at the start and by the forces on q at the nodes.
struct ElementResponse {
  Eigen::MatrixXd value_by_state, value_by_force, speed_by_state, speed_by_force;
  Eigen::MatrixXd end_by_state, end_by_force;
  Eigen::MatrixXd value_of_state;  // q at an instant

  ElementResponse(const std::vector<Oscillator>& modes, int width, double length);

 private:
  void add(const Oscillator& mode, int number, int width, double length);
};

}  // namespace evenload
