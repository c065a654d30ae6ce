// What a posted program can hold, and what its blocks cost.
//
// Which arcs can stay arcs in it: FreeCAD's simulator and dressups take an arc whose
// end points span an area below 0.005 mm^2 with its centre for half a circle, and fall down over
// some; path_commands writes lines in its place, at which the path has corners. Law: what is not
// becomes_corners here and turns by kUnseenTurn or more stays arcs there.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/curve.h"

namespace evenload {

// The limits of path_commands, below which an arc of at most half a turn becomes lines.
inline constexpr double kLeastSpan = 0.0052;   // mm^2: radius^2 times the sine of the sweep
inline constexpr double kSpanlessSweep = 1.6;  // rad, above a quarter turn: longer ones do no harm
// mm: on the grid of 0.0001 mm that programs are written on, the ends of tighter arcs would turn by
// a degree. Lines leave them by less than twice this.
inline constexpr double kLeastArcRadius = 0.007;
// mm: largest distance of lines from the arc that they stand for, on its inner side.
inline constexpr double kArcSagitta = 0.004;

// By how much the strategy and feed control keep away from them, so that no rounding of radius and
// sweep matters.
inline constexpr double kSpanMargin = 0.0002;   // mm^2
inline constexpr double kSweepMargin = 0.01;    // rad
inline constexpr double kRadiusMargin = 0.001;  // mm

inline constexpr double kUnseenTurn = 0.0175;  // rad: no corner of a line is as large as that
// rad: FreeCAD's simulator and dressups take the wrong side of longer arcs; the margin keeps
// halves.
inline constexpr double kLargestSweep = kPi * (1 + 1e-6);

// Into how many arcs of the same length one is cut: none of more than half a turn, full turns as
// halves.
inline int pieces_of_arc(double sweep) {
  const double turn = std::abs(sweep);
  return static_cast<int>(
      std::max({1.0, std::ceil(turn / kLargestSweep), 2 * std::nearbyint(turn / (2 * kPi))}));
}

// Into how many lines an arc is divided that is not to be posted as one.
inline int lines_of_arc(double radius, double sweep) {
  const double bent = 2 * std::acos(1 - std::min(1.0, kArcSagitta / radius));
  return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / bent)));
}

// The same for an arc of any sweep, which is divided into pieces first.
inline int lines_in_place_of(double radius, double sweep) {
  const int pieces = pieces_of_arc(sweep);
  return radius < kLeastArcRadius ? pieces : pieces * lines_of_arc(radius, sweep / pieces);
}

// For arcs of at most half a turn. Condition: spanless_sweep <= kSpanlessSweep + kSweepMargin.
inline bool spans_next_to_nothing(double radius, double sweep, double least_span,
                                  double spanless_sweep) {
  const double turn = std::abs(sweep), square = radius * radius;
  if (turn >= spanless_sweep) return false;
  // Up to there the sine is more than 0.6 times the angle: most arcs need none.
  return 0.6 * square * turn < least_span && square * std::sin(turn) < least_span;
}

// True for an arc of `radius` mm and `sweep` rad that becomes lines with corners above one degree,
// or comes near to that by the margins.
inline bool becomes_corners(double radius, double sweep) {
  const double turn = std::abs(sweep);
  if (turn < kUnseenTurn) return false;
  if (radius < kLeastArcRadius + kRadiusMargin) return true;
  return spans_next_to_nothing(radius, turn / pieces_of_arc(turn), kLeastSpan + kSpanMargin,
                               kSpanlessSweep + kSweepMargin);
}

inline bool is_tight(const Segment& move) {
  return move.is_arc() && becomes_corners(move.radius, move.sweep);
}

// rad: the least sweep of an arc of `radius` mm that does not become_corners, but for straight
// ones; infinite where there is none.
inline double least_arc_sweep(double radius) {
  if (radius < kLeastArcRadius + kRadiusMargin) return std::numeric_limits<double>::infinity();
  constexpr double kMore = 1 + 1e-6;  // than what rounding takes
  const double sine = kMore * (kLeastSpan + kSpanMargin) / (radius * radius);
  const double spanless = kMore * (kSpanlessSweep + kSweepMargin);
  return sine < 1 ? std::min(std::asin(sine), spanless) : spanless;
}

// mm: a posted program holds no arcs of 0.008 mm and less, to which half turns shrink where a room
// narrows.
inline constexpr double kTightestPosted = 0.012;
// mm, or the share of the tool's radius where that is less: passes that turn more tightly are
// posted as lines, with a corner between each two. Their turns are steered in pieces of a fifth of
// a radian and more, about a third of the engagement angle.
inline constexpr double kTightestArc = 0.16, kTightestArcShare = 0.055;
// The same of trochoids: passes that turn more tightly take away hundredths of a millimetre each,
// so that a slot takes minutes to compute.
inline constexpr double kTightestTrochoid = 0.04, kTightestTrochoidShare = 0.015;
// mm: half the room in which the tool has too little to turn for trochoids.
inline double tightest_trochoid(double tool_radius) {
  return std::min(kTightestTrochoid, kTightestTrochoidShare * tool_radius);
}
// mm: no rest of a move is shorter; rounded to 0.0001 mm it would be turned by half a degree.
inline constexpr double kShortestMove = 0.01;

// What one block more must save, s: controllers take some hundreds of blocks in a second.
namespace block_price {
inline constexpr double kFeed = 0.006;   // for a change of feed within a move
inline constexpr double kMove = 0.025;   // for one more move, to change the feed between two
inline constexpr double kSpiral = 0.02;  // along a curve whose load changes all the time, a little
inline constexpr double kPattern = 0.002;  // within a period that is repeated hundreds of times
// mm that one more block must shorten a link by. At 1500 mm/min that is the time that it must save
// elsewhere, too.
inline constexpr double kLink = 0.9;
}  // namespace block_price
// s: what the stops of a retract, two of them at corners in the air, cost beyond its length;
// staying down is gentler.
inline constexpr double kRetractPrice = 0.3;

}  // namespace evenload
