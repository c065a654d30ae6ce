// Directions of a step that all weigh alike.
//
// A step of 1 along any column of the whitening changes deviations by 1 in the mean square, so that
// shifts, turns and curvatures, short arcs and long cylinders need no scales of their own.
#pragma once

#include "inspection/deviations.h"

namespace evenload {

// Singular values of gradients that are less than this share of the largest count as none: the
// moments below have no more digits.
inline constexpr double kLeastShare = 3e-8;

// A row for each degree of freedom, a column for each direction that moves the points at all.
Eigen::MatrixXd whitening(const Columns& gradients);

}  // namespace evenload
