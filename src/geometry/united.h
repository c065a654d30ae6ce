// Many overlapping polygons as one set of outlines: united by Boost.Polygon, simplified by
// Boost.Geometry.
//
// Laws: outlines are nested, so that what they enclose by the even-odd rule is the union, to
// `tolerance`; with a tolerance of 0, to kUnitedGrid. Slivers as thin as that come and go.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace evenload {

// mm: the raster of the corners. Coordinates reach 20 m to all sides on it.
inline constexpr double kUnitedGrid = 1e-5;

// tolerance: mm by which corners that are left out lie beside the lines in their place, at the
// most. Throws std::invalid_argument for coordinates off that raster's range.
std::vector<std::vector<Vec2>> united(const std::vector<std::vector<Vec2>>& polygons,
                                      double tolerance);

// What is bounded by an outline, but for the holes in it. The ground lies to the left of each.
struct Patch {
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> holes;
};

// What patches, which may overlap, leave of others. Tolerance and raster as above; outlines may
// turn either way.
std::vector<Patch> cut_from(const std::vector<Patch>& patches, const std::vector<Patch>& cut,
                            double tolerance);

}  // namespace evenload
