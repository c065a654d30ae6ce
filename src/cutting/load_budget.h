// How much above the engagement angle a path may meet, and who may spend it: what steering,
// patterns and spirals accept above the angle, and by how much what is cleared beside those aims
// below it. Shares that can come together at one place add up to less than what a path is held to.
#pragma once

#include <algorithm>

#include "geometry/vec2.h"

namespace evenload {

// mm of path over which engagement is a mean, in the report and wherever it is held to the limit.
inline constexpr double kMeanLength = 0.1;

namespace load_budget {

// rad, of that mean: what paths are held to, of Adaptive and of Trochoid and Lamé spiral.
inline constexpr double kAllowed = 2 * kDegree, kAllowedOfPatterns = 1 * kDegree;
// rad: what rounding to a program's grid of 0.0001 mm, of a pass and of the one before it, may add.
// A side step a of a tool of radius r meets acos(1 - a / r), which grows by da / (r
// sin(engagement)): 0.2 degrees for a tool of 1 mm at 7 degrees, 0.005 for one of 6 mm at 60.
inline constexpr double kPosted = 0.2 * kDegree;

// rad: at the end of a step that is steered.
inline constexpr double kStepEnd = 0.25 * kDegree;
// rad: at the end of a step along a wall, which the next one begins with.
inline constexpr double kWallStepEnd = 0.2 * kStepEnd;
// rad: between the ends of a step, and as a mean of what takes a smooth path's place.
inline constexpr double kSmooth = 0.9 * kDegree;
static_assert(kStepEnd + kSmooth + kPosted <= kAllowed);

// rad: of a period of a pattern; exceeding the limit by less is not worth a shorter step. In
// proportion for limits below 60 degrees.
inline constexpr double kPattern = 0.75 * kDegree;
static_assert(kPattern + kPosted <= kAllowedOfPatterns);
inline double pattern(double engagement) {
  return kPattern * std::min(1.0, engagement / (kPi / 3));
}

// rad: of a turn of a spiral: by so much its corrections aim below the limit, so much above it they
// accept. Where they do not come down to that, a spiral is still one up to kSpiralMost, which
// leaves nothing for rounding.
inline constexpr double kSpiralAim = 0.2 * kDegree, kSpiral = 0.5 * kDegree,
                        kSpiralMost = 1 * kDegree;
static_assert(kSpiral + kPosted <= kAllowedOfPatterns && kSpiralMost <= kAllowedOfPatterns);

// rad: what is cleared beside patterns, and beside a spiral, is held to kAllowedOfPatterns though
// it is steered, which may spend kStepEnd and kSmooth: so it is steered at an angle that is smaller
// by this. Beside patterns cusps are met, the more the smaller the angle is.
inline double spared_beside_patterns(double engagement) {
  const double share = (kPi / 3) / engagement;
  return std::min(0.3 * kDegree * share * share, 0.05 * engagement);
}
inline double spared_beside_spiral(double engagement) {
  return std::max(0.007 * engagement, std::min(0.42 * kDegree, 0.03 * engagement));
}

}  // namespace load_budget
}  // namespace evenload
