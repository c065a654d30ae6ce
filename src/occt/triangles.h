// Triangles of a shape's faces, nearer to them than a deflection.
//
// The shape is triangulated anew, whatever triangles it brings along, and what comes out is
// measured: at the middles of triangles and of their sides against the surface itself. Where that
// is further off than wished triangles are split; where that does not do, for what is off lies on a
// face's border, all is done again, finer.
// Laws: faces that share an edge share its points; a triangle's corners lie on its face, and turn
// counter-clockwise seen from outside of a solid.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/progress.h"

namespace evenload {

struct FaceTriangles {
  std::vector<std::array<double, 3>> points;  // mm
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> faces;  // for each triangle the number of its face, from 0
  double deflection = 0;             // mm, the largest that was measured, across the triangles
};

// deflection, angle: wished at the most, in mm, and in rad between neighbours on a round face.
// Throws std::invalid_argument unless both are positive; ShapeError for a text that is no shape,
// for one without faces, and where OpenCASCADE fails; Cancelled.
FaceTriangles triangles_from_brep(const std::string& text, double deflection, double angle,
                                  Progress& progress);
// So often it is done finer; after that `deflection` says how far off the triangles are.
inline constexpr int kFinerTries = 4;

}  // namespace evenload
