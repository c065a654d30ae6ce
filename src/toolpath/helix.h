// The way of a helix seen from above: a circle, or where it is stretched two half circles and two
// straight lines. It turns counter-clockwise.
#pragma once

#include <vector>

#include "toolpath/planar.h"

namespace evenload {

// From Descent::at to the opposite place, in an even number of quarters; `second`: from there back.
std::vector<Segment> half_turn(const Descent& helix, bool second);
// Part of a way of as many turns as needed that arrives at Descent::at: from `from` to `to` mm
// before it arrives there, from > to >= 0. Arcs turn by half a circle at most.
std::vector<Segment> way_round(const Descent& helix, double from, double to);
// mm
double half_turn_length(const Descent& helix);
// mm^2: of the ground that a tool of `tool_radius` mm clears, without a post in its middle.
double cleared_area(const Descent& helix, double tool_radius);

}  // namespace evenload
