// The surface that a ball-end tool works, around one place: where the tool's centre goes, and how
// far a point lies from the surface.
//
// Frame: the tool's axis is z, upwards. The ball touches the surface in each of its places, so that
// its centres form the surface's offset by the ball's radius, and the stock is the offset by the
// allowance. Step coordinates (x, q) say where on the surface the tool stands; equal steps of them
// are what `Steps` names. Source: [Varga 2023, 4.1].
#pragma once

#include <Eigen/Core>

#include "geometry/vec2.h"

namespace evenload {

// What feed per tooth and stepover are measured on: in plan between places of the tool, along the
// surface of its centres, or along the part between points of contact.
enum class Steps { kPlan, kCentre, kSurface };

// A point of a path, with its derivatives by the step coordinate along the path.
struct PathPoint {
  Eigen::Vector3d at, first, second;
};

class WorkedSurface {
 public:
  virtual ~WorkedSurface() = default;
  // The tool's centre at step coordinates, with derivatives in the direction `along`, of length 1.
  virtual PathPoint centre(Vec2 at, Vec2 along) const = 0;
  // Signed distance from the part, > 0 outside.
  virtual double distance(const Eigen::Vector3d& point) const = 0;
  // Of the surface where the tool touches it, out of the part.
  virtual Eigen::Vector3d normal(Vec2 at) const = 0;
};

}  // namespace evenload
