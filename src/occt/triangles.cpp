#include "occt/triangles.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <stdexcept>

#include "occt/brep_text.h"
#include "occt/shape_error.h"

namespace evenload {
namespace {

// What the next try is finer by than what was measured.
constexpr double kFiner = 0.7;

// mm: how far a face lies from a flat triangle of it, across the triangle, at four places.
double off_face(const BRepAdaptor_Surface& surface, const gp_Pnt (&corners)[3],
                const gp_Pnt2d (&places)[3]) {
  const gp_Vec normal = gp_Vec(corners[0], corners[1]).Crossed(gp_Vec(corners[0], corners[2]));
  const double size = normal.Magnitude();
  if (!(size > 0)) return 0;
  double off = 0;
  constexpr double kPlaces[4][3] = {
      {1. / 3, 1. / 3, 1. / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}};
  for (const auto& share : kPlaces) {
    double u = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
      u += share[k] * places[k].X();
      v += share[k] * places[k].Y();
    }
    off = std::max(off, std::abs(gp_Vec(corners[0], surface.Value(u, v)).Dot(normal)) / size);
  }
  return off;
}

void add_face(const TopoDS_Face& face, std::uint32_t number, FaceTriangles& result) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& found = BRep_Tool::Triangulation(face, location);
  if (found.IsNull()) return;  // a face without an area
  const BRepAdaptor_Surface surface(face);
  const bool is_round = surface.GetType() != GeomAbs_Plane && found->HasUVNodes();
  const auto first = static_cast<std::uint32_t>(result.points.size());
  for (int i = 1; i <= found->NbNodes(); ++i) {
    const gp_Pnt p = found->Node(i).Transformed(location.Transformation());
    result.points.push_back({p.X(), p.Y(), p.Z()});
  }
  for (int i = 1; i <= found->NbTriangles(); ++i) {
    int numbers[3];
    found->Triangle(i).Get(numbers[0], numbers[1], numbers[2]);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(numbers[1], numbers[2]);
    std::array<std::uint32_t, 3> corners{};
    gp_Pnt points[3];
    gp_Pnt2d places[3];
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] = first + static_cast<std::uint32_t>(numbers[k]) - 1;
      points[k] = found->Node(numbers[k]).Transformed(location.Transformation());
      if (is_round) places[k] = found->UVNode(numbers[k]);
    }
    result.triangles.push_back(corners);
    result.faces.push_back(number);
    if (is_round)
      result.deflection = std::max(result.deflection, off_face(surface, points, places));
  }
}

FaceTriangles triangulated(const TopoDS_Shape& shape, double deflection, double angle) {
  BRepTools::Clean(shape);
  const BRepMesh_IncrementalMesh mesher(shape, deflection, false, angle, false);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  FaceTriangles result;
  for (int i = 1; i <= faces.Extent(); ++i)
    add_face(TopoDS::Face(faces(i)), static_cast<std::uint32_t>(i) - 1, result);
  return result;
}

FaceTriangles fine_enough(const std::string& text, double deflection, double angle) {
  const TopoDS_Shape shape = shape_from_brep(text);
  FaceTriangles result = triangulated(shape, deflection, angle);
  double wished = deflection;
  for (int i = 0; i < kFinerTries && result.deflection > deflection; ++i) {
    wished *= std::max(0.25, kFiner * deflection / result.deflection);
    result = triangulated(shape, wished, angle);
  }
  if (result.triangles.empty()) throw ShapeError(ShapeFault::kEmpty, 0, "The shape has no face.");
  return result;
}

}  // namespace

FaceTriangles triangles_from_brep(const std::string& text, double deflection, double angle) {
  if (!(deflection > 0 && angle > 0))
    throw std::invalid_argument("The deflection and the angle must be positive.");
  try {
    return fine_enough(text, deflection, angle);
  } catch (const Standard_Failure& failure) {
    throw ShapeError(ShapeFault::kKernel, 0,
                     std::string("OpenCASCADE could not triangulate the shape: ") +
                         failure.DynamicType()->Name() + " " + failure.GetMessageString() + ".");
  }
}

}  // namespace evenload
