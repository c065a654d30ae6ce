// Which arcs can stay arcs in a posted program. Of an arc whose ends span next to no area with its
// centre FreeCAD's simulator and dressups read half a circle, so path_commands writes lines in its
// place, at which the path has corners. The limits here are its own, with a margin for its
// rounding.
#pragma once

#include <cmath>

namespace evenload {

inline constexpr double kLeastSpan = 0.0054;      // mm^2: radius^2 times the sine of the sweep
inline constexpr double kSpanlessSweep = 1.61;    // rad: arcs that turn further stay arcs
inline constexpr double kUnseenTurn = 0.0175;     // rad: no corner of a line is as large as that
inline constexpr double kLeastArcRadius = 0.011;  // mm

// True for an arc of `radius` mm and `sweep` rad that becomes lines with corners above one degree.
inline bool becomes_corners(double radius, double sweep) {
  const double turn = std::abs(sweep);
  if (turn < kUnseenTurn) return false;
  if (radius < kLeastArcRadius) return true;
  return turn < kSpanlessSweep && radius * radius * std::sin(turn) < kLeastSpan;
}

}  // namespace evenload
