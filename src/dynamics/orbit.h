// Periodic motions of a tool under forces that depend on its velocity, and their stability.
//
// The motion has the teeth's period, so that no displacement of before is left in its equation: it
// is solved by shooting over Gauss elements, which are cut where teeth enter and leave, and where
// the flank lets go. Multipliers are those of the delayed system linearised along the orbit.
// Law: at a fold of a branch of orbits a multiplier is 1; a process without flank and with circular
// chips has the linear forced motion and its multipliers.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "dynamics/edge_force.h"
#include "dynamics/periodic_system.h"

namespace evenload {

// q and its velocity, within components, over one period.
struct Orbit {
  double depth = 0;
  Eigen::VectorXd start;                        // the modes' states at the instant 0
  std::vector<double> starts, lengths;          // of elements, s
  std::vector<Eigen::MatrixXd> values, speeds;  // of elements: start, nodes, end; columns x and y
  ThicknessCorrection correction;

  Eigen::Vector2d value(double time) const;
  Eigen::Vector2d speed(double time) const;
  // m: half of the width of x or y, whichever is wider.
  double amplitude() const;

 private:
  Eigen::Vector2d interpolated(const std::vector<Eigen::MatrixXd>& of, double time) const;
};

class OrbitSolver {
 public:
  explicit OrbitSolver(const EdgeForces& forces);

  int states() const { return 2 * static_cast<int>(components_.modes.size()); }
  double period() const { return period_; }
  const EdgeForces& forces() const { return forces_; }

  // The end of a period and its derivative by the start, from orbit.start at orbit.depth; fills the
  // rest of the orbit. `switches`: instants at which the flank lets go or takes hold.
  struct End {
    Eigen::VectorXd state;
    Eigen::MatrixXd by_start;
  };
  End run(Orbit& orbit, const std::vector<double>& switches) const;

  // From a guess of orbit.start at orbit.depth. Whether there is one near.
  bool solve(Orbit& orbit) const;

  // The largest first.
  std::vector<std::complex<double>> multipliers(const Orbit& orbit, double accuracy,
                                                int wanted) const;
  // Where the flank of a tooth that cuts changes between pushing and not; s.
  std::vector<double> switches(const Orbit& orbit) const;

 private:
  std::vector<PeriodPiece> pieces(double depth, const std::vector<double>& more) const;
  void pass(const PeriodPiece& piece, Orbit& orbit, End& end) const;

  EdgeForces forces_;
  Components components_;
  double period_, fastest_;
};

}  // namespace evenload
