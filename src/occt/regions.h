// Regions from a shape of FreeCAD's, handed over as BREP text.
#pragma once

#include <string>
#include <vector>

#include "geometry/curve.h"

namespace evenload {

// What lies between an outer boundary and its islands, at one height. The curves are closed, seen
// from above, and of either sense: make_region checks and normalises them.
struct LevelRegion {
  double z = 0;  // mm
  Curve outer;
  std::vector<Curve> islands;
};

// Faces parallel to XY, facing up or down, give a region each. Wires and edges outside of faces (a
// sketch) are joined to closed curves and nested: the outermost bound regions, the next ones within
// are islands, and so on in turns. Faces come first, in the shape's order, then the rest in the
// order of their first edges. Laws: lines and circular arcs exactly; other curves within
// `tolerance` mm, with continuous tangents. Throws std::invalid_argument for a tolerance that is
// not above 0, ShapeError for everything that is wrong with the shape.
std::vector<LevelRegion> regions_from_brep(const std::string& text, double tolerance);

struct LevelCurve {
  double z = 0;  // mm
  Curve curve;   // seen from above, open ones before closed ones
};

// The wires and edges outside of faces, joined end to end where two of them meet; the same laws
// and errors, but that a curve may be open, as it is where more than two meet.
std::vector<LevelCurve> curves_from_brep(const std::string& text, double tolerance);

}  // namespace evenload
