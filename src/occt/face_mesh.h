// Triangles of one face, and splitting those of them that leave it by more than wished.
//
// What OpenCASCADE makes of tori and spheres leaves them somewhat further than it was asked for, at
// few places. Making all triangles finer for these took several times as long and as many.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

class BRepAdaptor_Surface;

namespace evenload {

class Progress;

struct FaceMesh {
  using Triangle = std::array<std::uint32_t, 3>;  // numbers of points

  std::vector<std::array<double, 3>> points;  // on the face, mm
  std::vector<std::array<double, 2>> places;  // of these on the surface, by its own parameters
  std::vector<Triangle> triangles;
};

// Halves sides of triangles until none is further off the surface than wished, where that can be.
// Laws: sides on the border of the face stay, so that neighbours share them; triangles keep their
// turn, and none ends within the side of another; new points lie on the surface. Returns mm by
// which the triangles leave the surface then: at their middles and those of their sides. Throws
// Cancelled.
double split_where_off(const BRepAdaptor_Surface& surface, double wished, FaceMesh& mesh,
                       Progress& progress);
// Each round halves a triangle's sides at most once.
inline constexpr int kSplitRounds = 6;

}  // namespace evenload
