// A part as triangles, to be asked from above.
//
// Which way a triangle is turned does not matter, and nothing needs to be closed: what lies highest
// counts. Of an edge between two triangles only what a tool from above can touch is kept: where the
// ground falls away to one side, or folds back. In a valley, and where two triangles lie in one
// plane, a tool that touches the edge touches a triangle as well.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/space_point.h"

namespace evenload {

struct Facet {
  std::array<SpacePoint, 3> corners;  // counter-clockwise, seen from above
  SpacePoint normal;                  // of length 1, upwards; z = 0 where it is upright
  double top = 0;                     // mm
  bool is_picked = false;             // whether it belongs to the faces that are to be machined
  // Of the edges from each corner to the next: whether a tool can touch it alone, which is told by
  // one of its triangles; and whether picked triangles lie to both of its sides. Of the corners:
  // whether only such edges meet there.
  std::array<bool, 3> is_touchable{}, is_within{}, is_corner_within{};
};

// A box around facets, seen from above.
struct FacetNode {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double top = 0;  // mm, of the highest
  // A leaf has `count` facets from `first` on; others have none, their first child follows them and
  // the second is `first`.
  std::uint32_t first = 0, count = 0;
};

class FacetMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // numbers of points

  // `picked`: for each triangle whether it is to be machined. Triangles without an area are left
  // out. Throws std::invalid_argument for coordinates that are not finite, points that are not
  // there, and lists of different lengths.
  FacetMesh(const std::vector<SpacePoint>& points, const std::vector<Triangle>& triangles,
            const std::vector<bool>& picked);

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<FacetNode>& nodes() const { return nodes_; }  // the root first; none if empty

 private:
  void build(std::uint32_t from, std::uint32_t to);

  std::vector<Facet> facets_;
  std::vector<FacetNode> nodes_;
};

// A triangle that is steeper, as the z of its normal, counts as upright: seen from above it is as
// wide as rounding, and its edges tell where it is.
inline constexpr double kUpright = 1e-6;

}  // namespace evenload
