// The force on a tool that moves as it vibrates: chip thickness and directions may follow the
// edge's own velocity, and the flank pushes only while it moves into the work.
//
//   circular   h = (fz e_x + q - q_before).n, n from the tooth's angle: the linear process
//   velocity   u = R W t + vf e_x + q' is the edge's velocity, n = u/|u| turned by +90 degrees,
//              force -(Kt u/|u| + Kn n) h
//   flank      (C/vc) max(0, n.(q' + vf e_x)) (n + mu t) against the tool, by the tooth's angle
// Over an edge with helix the force is integrated by Gauss's rule. Along a periodic motion with the
// teeth's period q - q_before is 0.
// Source: [Bachrathy 2013, theses 5 and 6].
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "dynamics/milling.h"

namespace evenload {

enum class ChipModel { kCircular, kVelocity };

// In the feed's frame, N and N/m: force = value - stiffness (dq - dq_before) - damping dq'.
struct EdgeForce {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero(), damping = Eigen::Matrix2d::Zero();
};

// What is added to h, by tooth, instant and height, where the path of the tooth before is exact.
using ThicknessCorrection = std::function<double(int tooth, double time)>;

class EdgeForces {
 public:
  // speed in rad/s, mean feed per tooth in m. Condition: even pitch.
  EdgeForces(const Milling& milling, double speed, double feed_per_tooth, ChipModel chip);

  // All teeth at an instant of a periodic motion, q' in the frame, m/s.
  EdgeForce at(double time, const Eigen::Vector2d& velocity, double depth,
               const ThicknessCorrection& correction) const;
  // The speed of a tooth's edge into the work at its tip, which the flank feels; m/s.
  double inward_speed(int tooth, double time, const Eigen::Vector2d& velocity) const;
  // h of a tooth's tip, m, and the unit vectors along and across its way.
  struct Chip {
    double thickness;
    Eigen::Vector2d along, across;
    double speed;
  };
  Chip chip(int tooth, double time, const Eigen::Vector2d& velocity) const;
  bool is_engaged(int tooth, double time, double depth) const;

  const Milling& milling() const { return milling_; }
  double speed() const { return speed_; }
  double feed() const { return feed_; }
  double feed_speed() const { return feed_ * milling_.teeth * speed_ / (2 * M_PI); }

 private:
  void add(double angle, double length, const Eigen::Vector2d& velocity, double correction,
           EdgeForce& sum) const;
  Chip chip_at(double angle, const Eigen::Vector2d& velocity) const;

  Milling milling_;
  double speed_, feed_;
  ChipModel chip_;
  std::vector<double> positions_;
};

}  // namespace evenload
