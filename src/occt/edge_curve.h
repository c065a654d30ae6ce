// One edge of a shape as a chain of lines and arcs.
#pragma once

#include "geometry/curve.h"

class TopoDS_Edge;

namespace evenload {

struct EdgeCurve {
  Curve curve;        // open, both ends included, also where the edge is a closed circle
  double low_z = 0;   // mm
  double high_z = 0;  // mm
  double end_error =
      0;  // mm, how far the edge's ends may lie from the points where it meets its neighbours
};

// Seen from above. Lines and level circles exactly, anything else within `tolerance` mm as
// tangent-continuous arcs. A full circle becomes two halves. Throws ShapeError (kNotFinite,
// kKernel) for `member`.
EdgeCurve edge_curve(const TopoDS_Edge& edge, double tolerance, std::size_t member);

}  // namespace evenload
