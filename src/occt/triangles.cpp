#include "occt/triangles.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <atomic>
#include <exception>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <stdexcept>

#include "occt/brep_text.h"
#include "occt/face_mesh.h"
#include "occt/shape_error.h"

namespace evenload {
namespace {

// What the next try is finer by than what was measured.
constexpr double kFiner = 0.7;

// Tells OpenCASCADE, which asks it from many threads, whether to go on. What asking throws may not
// go through OpenCASCADE, and is kept.
class Watch : public Message_ProgressIndicator {
 public:
  explicit Watch(Progress& progress) : progress_(progress) {}
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}
  Standard_Boolean UserBreak() override {
    try {
      if (!is_over_) progress_.step();
    } catch (const Cancelled&) {
      is_over_ = true;
    } catch (...) {  // by the one thread that asks, so that no other writes here
      thrown_ = std::current_exception();
      is_over_ = true;
    }
    return is_over_;
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
    if (is_over_) throw Cancelled();
  }

 private:
  Progress& progress_;
  std::exception_ptr thrown_;
  std::atomic<bool> is_over_ = false;
};

FaceMesh mesh_of(const TopoDS_Face& face, const Poly_Triangulation& found,
                 const gp_Trsf& placement) {
  FaceMesh mesh;
  for (int i = 1; i <= found.NbNodes(); ++i) {
    const gp_Pnt p = found.Node(i).Transformed(placement);
    mesh.points.push_back({p.X(), p.Y(), p.Z()});
    if (found.HasUVNodes()) mesh.places.push_back({found.UVNode(i).X(), found.UVNode(i).Y()});
  }
  for (int i = 1; i <= found.NbTriangles(); ++i) {
    int numbers[3];
    found.Triangle(i).Get(numbers[0], numbers[1], numbers[2]);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(numbers[1], numbers[2]);
    FaceMesh::Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(numbers[k]) - 1;
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

void add_face(const TopoDS_Face& face, std::uint32_t number, double wished, FaceTriangles& result,
              Progress& progress) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& found = BRep_Tool::Triangulation(face, location);
  if (found.IsNull()) return;  // a face without an area
  FaceMesh mesh = mesh_of(face, *found, location.Transformation());
  const BRepAdaptor_Surface surface(face);
  if (surface.GetType() != GeomAbs_Plane && found->HasUVNodes())
    result.deflection =
        std::max(result.deflection, split_where_off(surface, wished, mesh, progress));
  const auto first = static_cast<std::uint32_t>(result.points.size());
  result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
  for (const auto& [a, b, c] : mesh.triangles)
    result.triangles.push_back({first + a, first + b, first + c});
  result.faces.insert(result.faces.end(), mesh.triangles.size(), number);
}

// meshers: what OpenCASCADE is asked for; wished: what triangles are split for.
FaceTriangles triangulated(const TopoDS_Shape& shape, double meshers, double angle, double wished,
                           Progress& progress) {
  BRepTools::Clean(shape);
  IMeshTools_Parameters parameters;
  parameters.Deflection = meshers;
  parameters.Angle = angle;
  // Each face by itself, so that any number of threads makes the same triangles.
  parameters.InParallel = Standard_True;
  const Handle(Watch) watch = new Watch(progress);
  const BRepMesh_IncrementalMesh mesher(shape, parameters, watch->Start());
  watch->rethrow();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  FaceTriangles result;
  for (int i = 1; i <= faces.Extent(); ++i)
    add_face(TopoDS::Face(faces(i)), static_cast<std::uint32_t>(i) - 1, wished, result, progress);
  return result;
}

FaceTriangles fine_enough(const std::string& text, double deflection, double angle,
                          Progress& progress) {
  const TopoDS_Shape shape = shape_from_brep(text);
  FaceTriangles result = triangulated(shape, deflection, angle, deflection, progress);
  double meshers = deflection;
  for (int i = 0; i < kFinerTries && result.deflection > deflection; ++i) {
    meshers *= std::max(0.25, kFiner * deflection / result.deflection);
    result = triangulated(shape, meshers, angle, deflection, progress);
  }
  if (result.triangles.empty()) throw ShapeError(ShapeFault::kEmpty, 0, "The shape has no face.");
  return result;
}

}  // namespace

FaceTriangles triangles_from_brep(const std::string& text, double deflection, double angle,
                                  Progress& progress) {
  if (!(deflection > 0 && angle > 0))
    throw std::invalid_argument("The deflection and the angle must be positive.");
  try {
    return fine_enough(text, deflection, angle, progress);
  } catch (const Standard_Failure& failure) {
    throw ShapeError(ShapeFault::kKernel, 0,
                     std::string("OpenCASCADE could not triangulate the shape: ") +
                         failure.DynamicType()->Name() + " " + failure.GetMessageString() + ".");
  }
}

}  // namespace evenload
