// Where the search for a feature begins.
//
// Flat features and lines begin in the principal axes of the points. Bent ones begin at an
// algebraic circle or sphere and, since that is wrong for short arcs, at a paraboloid over the
// plane through the points, too. The axis of a cylinder is sought among the principal axes, the
// directions in which that paraboloid is bent most and least, and a grid over all directions: long,
// short and partial cylinders each find theirs among these. Condition: the points are centred and
// their size is about 1.
#pragma once

#include <vector>

#include "inspection/feature.h"

namespace evenload {

// All frames worth a try, the likelier ones first; none where the points lie too ill for any.
std::vector<Frame> starts(Kind kind, const Points& points);

// The points' principal axes in columns, of the least extent first; roots of the mean squares.
struct Principal {
  Eigen::Matrix3d axes;
  Eigen::Vector3d extents;
};
Principal principal_axes(const Points& points);

}  // namespace evenload
