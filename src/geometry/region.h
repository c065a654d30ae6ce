// A pocket's floor: an outer boundary and the islands that stand in it.
//
// Laws: the outer boundary runs counter-clockwise, islands clockwise, so the inside always lies to
// the left of travel; no curve crosses or touches itself or another; every island lies inside the
// outer boundary.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

struct Region {
  Curve outer;
  std::vector<Curve> islands;

  double area() const;  // mm^2
  bool contains(Vec2 q) const;
  std::vector<Curve> curves() const;  // outer first
};

// Checks and normalises: drops pieces shorter than kZeroLength, closes gaps up to kClosingGap, sets
// the sense of rotation. Throws GeometryError (kNotFinite, kTooFewPoints, kOpen, kSelfCrossing,
// kIslandOutside) with the place.
Region make_region(const Curve& outer, const std::vector<Curve>& islands = {});
// mm: modellers take points this near for one.
inline constexpr double kZeroLength = 1e-7;
// mm: gaps left by rounding in files, far under any drawn gap.
inline constexpr double kClosingGap = 1e-6;
// mm: curves this near touch; rounding at 1e4 mm is a hundred times less.
inline constexpr double kTouch = 1e-9;

// The smallest box around all of them; two zero points for no regions.
Bounds bounds_of(const std::vector<Region>& regions);

// The points at signed distance `d` mm from the regions' boundary (d > 0 grows, d < 0 shrinks),
// arcs kept as arcs; growing rounds convex corners. All regions are offset together, so that grown
// ones which meet merge into one. Tolerance: kOffsetTolerance. Pieces smaller than it may vanish.
// Laws: every point of the result's boundary lies at |d| from the regions' boundary; a shrunken
// then grown region lies inside the original; two steps shrink as much as their sum; the result
// turns, mirrors and shifts with the regions, and make_region accepts it: fronts that just touch
// are parted or merged, whichever the tolerance allows. `open` marks pass on to the moved pieces.
std::vector<Region> offset(const std::vector<Region>& regions, double d);
// mm: well under any machine's resolution, well above rounding at 1e4 mm.
inline constexpr double kOffsetTolerance = 1e-6;

}  // namespace evenload
