// The fewest lines along a curve that may leave it by little, and by less downwards.
//
// Corners of the lines stand over the curve's points at one of a few heights; among those the
// result has the fewest lines there are, found layer by layer: all corners that one line reaches,
// those that two do, ... A line reaches as far as the bounds of all points that it passes leave a
// slope for it [Imai, Iri 1986]. Laws: the lines pass each point within its bounds; the first and
// the last corner lie over the curve's ends; a straight curve stays as it is.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace evenload {

enum class LineEnds { kFree, kFixed };  // within the bounds, or on the curve

// curve: (s, z) with growing s, at least two points. below, above: mm, > 0, across the curve.
std::vector<Vec2> fewest_lines(const std::vector<Vec2>& curve, double below, double above,
                               LineEnds ends = LineEnds::kFree);

// Without the points that lie on the lines between their neighbours, to `tolerance` mm in z.
std::vector<Vec2> without_straight_ones(const std::vector<Vec2>& curve, double tolerance);

}  // namespace evenload
