// The way of a ramp seen from above: lines round by Descent::ramp_by, or to and fro.
#pragma once

#include <vector>

#include "toolpath/planar.h"

namespace evenload {

// Once round, from Descent::at and back to it.
std::vector<Segment> ramp_round(const Descent& ramp);
// mm
double ramp_length(const Descent& ramp);
// mm: by which a line of a ramp must descend to do so in a posted program, written to 0.0001 mm,
// also where the way down is a little longer than it must be.
inline constexpr double kLeastDescent = 2.5e-4;
// What each line of the way round has of a round's descent, as mm of a way at the angle, rad, of
// the descent: its length, or what descends by kLeastDescent where it is shorter.
std::vector<double> ramp_shares(const Descent& ramp, double angle);
// mm^2: of the ground that a tool of `tool_radius` mm clears. Condition: the way round is convex or
// as good as that, and leaves no post in its middle.
double ramp_area(const Descent& ramp, double tool_radius);

}  // namespace evenload
