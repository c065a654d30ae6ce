// The upper side of a body as heights over the plane, from triangles.
//
// Laws: top_at is the highest triangle over a place, so what lies under an overhang counts as
// filled; upright triangles count for nothing, for what they bound has a top of its own. Exact for
// flat faces; on round ones as far off as the triangles are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/region.h"
#include "simulate/dexel_row.h"

namespace evenload {

struct Point3 {
  double x = 0, y = 0, z = 0;  // mm
};

// What lies highest over a place.
struct Top {
  double z = 0;                // mm
  Point3 normal;               // of length 1, upwards
  std::uint32_t triangle = 0;  // its number
};

class HeightMap {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // numbers of points

  // Throws std::invalid_argument for coordinates that are not finite and points that are not there.
  HeightMap(const std::vector<Point3>& points, const std::vector<Triangle>& triangles);

  bool empty() const { return faces_.empty(); }
  std::size_t triangle_count() const { return triangles_; }  // of those that were given
  const Bounds& bounds() const { return bounds_; }
  double lowest() const { return lowest_; }    // mm, of the upper side; 0 where there is none
  double highest() const { return highest_; }  // mm

  // kNoMaterial where there is nothing.
  double top_at(Vec2 p) const;
  // The highest triangle over a place, and its number as it was given; nothing where there is none.
  std::optional<Top> highest_at(Vec2 p) const;
  // Places of the upper side on a raster between two corners, which lies in their middle.
  std::vector<Point3> raster(const Bounds& corners, double step) const;
  // Fills rows of a stock, at y = first + j * spacing, up to the upper side. A slope becomes steps
  // no longer than the spacing, each as high as the slope's higher end: where in doubt it stands.
  // mirror: columns in place of rows.
  void raise(std::vector<DexelRow>& rows, double first, double spacing, bool mirror) const;
  // A place within `region`, and no nearer to its border than `inset` mm, over which the body
  // stands higher than `z`: the highest of those looked at, which are on a raster of `spacing` mm,
  // along the border, and at the triangles' corners and middles. The raster of a wide region is
  // coarser.
  std::optional<Point3> highest_within(const Region& region, double z, double inset,
                                       double spacing) const;

 private:
  struct Face {
    Point3 a, b, c;
    std::uint32_t number = 0;  // among the triangles that were given
  };
  static std::optional<double> height_on(const Face& face, Vec2 p);

  std::size_t triangles_;
  std::vector<Face> faces_;
  BoxTree tree_;
  Bounds bounds_;
  double lowest_ = 0, highest_ = 0;
};

}  // namespace evenload
