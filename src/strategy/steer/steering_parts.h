// What the files of Steering share.
#pragma once

#include <cmath>

#include "geometry/curve.h"
#include "strategy/steer/steering.h"

namespace evenload::steering_parts {

// Lengths as shares of the tool's radius.
inline constexpr double kIdleAfterCut = 0.2;   // without contact for this long: the pass is over
inline constexpr double kIdleBeforeCut = 1.5;  // nothing met for this long: there is nothing
inline constexpr double kCuspLook = 0.03;      // between two looks where the front may have a cusp

inline constexpr double kTurnStep = 10 * kDegree;  // between two looks along a turn
// Share of the tool's radius to which looks close in on a cusp, per rad of the limit: 0.004 at 60
// degrees.
inline constexpr double kCuspWidth = 0.0038;
inline constexpr double kInContact = 0.06 * kDegree;  // less counts as no contact

// `length` mm from a pose on: an arc, or a line where it would hardly bend.
inline Segment move_of(const Pose& from, double curvature, double length) {
  if (std::abs(curvature) * length < 1e-9)
    return Segment::line(from.p, from.p + length * unit(from.heading));
  const double radius = 1 / std::abs(curvature), side = curvature > 0 ? 1 : -1;
  const Vec2 centre = from.p + side * radius * left_normal(unit(from.heading));
  return Segment::arc(centre, radius, from.heading - side * kPi / 2, curvature * length);
}

inline Pose end_of(const Segment& move) { return {move.b, angle_of(move.tangent(1))}; }

}  // namespace evenload::steering_parts
