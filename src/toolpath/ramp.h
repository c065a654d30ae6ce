// The way of a ramp seen from above: lines round by Descent::ramp_by, or to and fro.
#pragma once

#include <vector>

#include "toolpath/planar.h"

namespace evenload {

// Once round, from Descent::at and back to it.
std::vector<Segment> ramp_round(const Descent& ramp);
// mm
double ramp_length(const Descent& ramp);
// mm^2: of the ground that a tool of `tool_radius` mm clears. Condition: the way round is convex or
// as good as that, and leaves no post in its middle.
double ramp_area(const Descent& ramp, double tool_radius);

}  // namespace evenload
