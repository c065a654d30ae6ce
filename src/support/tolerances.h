// Tolerances that nobody tunes: how near two things are that count as one.
#pragma once

#include <cstddef>

namespace evenload {

// What rounding may leave of a length in mm, an angle in rad or a share.
inline constexpr double kRounding = 1e-9;
// Two places as one, in mm; two areas in mm^2, angles in rad and shares alike. Far above what
// rounding adds up to along a path, and far below what a machine or a post-processor can tell.
inline constexpr double kSame = 1e-6;
// mm: on a wall. Offsets of splines and fits to them lie this near to the wall that they stand for.
inline constexpr double kOnWall = 1e-4;
// Of unit vectors, or rad: tangent to each other.
inline constexpr double kSameDirection = 1e-3;

// No index.
inline constexpr std::size_t kNoIndex = ~std::size_t{0};

}  // namespace evenload
