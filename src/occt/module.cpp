// The Python module evenload._occt_X_Y_Z, called after the version of OpenCASCADE that it is linked
// to: the only one that is.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Standard_Version.hxx>
#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <tuple>

#include "occt/regions.h"
#include "occt/shape_error.h"
#include "occt/triangles.h"
#include "support/progress.h"

namespace py = pybind11;

namespace evenload {
namespace {

using VertexTuple = std::tuple<double, double, double, bool>;
using Chain = std::vector<VertexTuple>;

Chain chain_of(const Curve& curve) {
  Chain chain;
  for (const Vertex& v : curve.vertices()) chain.emplace_back(v.p.x, v.p.y, v.bulge, v.open);
  return chain;
}

std::vector<std::tuple<double, Chain, std::vector<Chain>>> regions_as_tuples(
    const std::string& text, double tolerance) {
  std::vector<std::tuple<double, Chain, std::vector<Chain>>> result;
  for (const LevelRegion& region : regions_from_brep(text, tolerance)) {
    std::vector<Chain> islands;
    for (const Curve& island : region.islands) islands.push_back(chain_of(island));
    result.emplace_back(region.z, chain_of(region.outer), std::move(islands));
  }
  return result;
}

std::vector<std::tuple<double, Chain, bool>> curves_as_tuples(const std::string& text,
                                                              double tolerance) {
  std::vector<std::tuple<double, Chain, bool>> result;
  for (const LevelCurve& level : curves_from_brep(text, tolerance))
    result.emplace_back(level.z, chain_of(level.curve), level.curve.closed());
  return result;
}

template <typename T>
py::array_t<T> rows_of(const std::vector<std::array<T, 3>>& rows) {
  py::array_t<T> result({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
  T* into = result.mutable_data();
  for (const std::array<T, 3>& row : rows) into = std::copy(row.begin(), row.end(), into);
  return result;
}

py::object triangles_for_python(const std::string& text, double deflection, double angle,
                                const std::function<bool(double)>& callback) {
  FaceTriangles found;
  try {
    const py::gil_scoped_release unlocked;
    Progress progress(callback);
    found = triangles_from_brep(text, deflection, angle, progress);
  } catch (const Cancelled&) {
    return py::none();
  }
  return py::make_tuple(
      rows_of(found.points), rows_of(found.triangles),
      py::array_t<std::uint32_t>(static_cast<py::ssize_t>(found.faces.size()), found.faces.data()),
      found.deflection);
}

const char* reason(ShapeFault fault) {
  switch (fault) {
    case ShapeFault::kUnreadable:
      return "unreadable";
    case ShapeFault::kEmpty:
      return "empty";
    case ShapeFault::kNotPlanar:
      return "not planar";
    case ShapeFault::kTilted:
      return "tilted";
    case ShapeFault::kNotFinite:
      return "not finite";
    case ShapeFault::kOpen:
      return "open";
    case ShapeFault::kBranching:
      return "branching";
    case ShapeFault::kCrossing:
      return "crossing";
    case ShapeFault::kKernel:
      return "kernel";
  }
  return "";
}

}  // namespace
}  // namespace evenload

// The build names the module. One more step lets the preprocessor put in that name, not the macro's
// own.
#define EVENLOAD_MODULE(name, variable) PYBIND11_MODULE(name, variable)
#define EVENLOAD_TEXT(name) PYBIND11_TOSTRING(name)

EVENLOAD_MODULE(EVENLOAD_OCCT_MODULE, module) {
  using namespace evenload;
  module.doc() = "Regions, curves and triangles from FreeCAD's shapes.";
  module.attr("OCC_VERSION") = OCC_VERSION_COMPLETE;

  // Kept for as long as the process runs: the translator may be asked until the very end.
  static PyObject* const shape_error = PyErr_NewExceptionWithDoc(
      "evenload." EVENLOAD_TEXT(EVENLOAD_OCCT_MODULE) ".ShapeError",
      "A shape that gives no region. `reason` is one word or two ('tilted', 'not planar', "
      "'open', 'branching', 'crossing', 'not finite', 'empty', 'unreadable', 'kernel'), `index` "
      "counts the direct children of the compound that was read, from 0.",
      PyExc_ValueError, nullptr);
  module.attr("ShapeError") = py::reinterpret_borrow<py::object>(shape_error);
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const ShapeError& error) {
      py::object instance = py::reinterpret_borrow<py::object>(shape_error)(error.what());
      instance.attr("reason") = reason(error.fault());
      instance.attr("index") = error.member();
      PyErr_SetObject(shape_error, instance.ptr());
    }
  });

  module.def("regions_from_brep", &regions_as_tuples, py::arg("text"), py::arg("tolerance"),
             py::call_guard<py::gil_scoped_release>(),
             "[(z, outer, islands), ...] of every face parallel to XY and of every closed outline "
             "outside of faces.\n\n"
             "Chains are lists of (x, y, bulge, open) in mm, closed, of either sense; bulge = "
             "tan(included angle / 4) of the\n"
             "piece that starts there, counter-clockwise positive. Curves other than lines and "
             "circles are within\n"
             "`tolerance` mm. Raises ShapeError.");
  module.def(
      "curves_from_brep", &curves_as_tuples, py::arg("text"), py::arg("tolerance"),
      py::call_guard<py::gil_scoped_release>(),
      "[(z, chain, closed), ...] of the edges outside of faces, joined end to end where they "
      "meet, open ones first; chains and errors as for regions_from_brep.");
  module.def(
      "triangles_from_brep", &triangles_for_python, py::arg("text"), py::arg("deflection"),
      py::arg("angle"), py::arg("progress") = py::none(),
      "(points, triangles, faces, deflection): rows of x, y, z in mm, rows of the numbers of "
      "three of them, counter-clockwise seen from outside, the number of each one's face as "
      "the shape counts them, from 0, and how far off they are, measured. deflection in mm, "
      "angle in rad: wished at the most. progress: callable(share), which answers whether to go "
      "on; "
      "None is returned where it does not. Raises ShapeError.");
}
