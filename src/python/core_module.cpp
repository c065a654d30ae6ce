// Module _core: the C++ core for Python. Lengths in mm, angles in rad, feeds in mm/min.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>

#include "cutting/cleared_ground.h"
#include "cutting/force.h"
#include "feed/load_profile.h"
#include "geometry/medial_axis.h"
#include "geometry/region.h"
#include "geometry/united.h"
#include "python/ball_end_module.h"
#include "python/clearing_params.h"
#include "python/dynamics_module.h"
#include "python/engagement_profile.h"
#include "python/findings.h"
#include "python/force_module.h"
#include "python/gcode_module.h"
#include "python/inspection_module.h"
#include "python/lame_module.h"
#include "python/path_commands_module.h"
#include "python/proof_module.h"
#include "python/python_objects_module.h"
#include "python/simulate_module.h"
#include "python/surface_map_module.h"
#include "python/surface_module.h"
#include "python/trochoid_module.h"
#include "strategy/pocket/constant_engagement.h"
#include "strategy/pocket/rest_levels.h"
#include "support/errors.h"

namespace py = pybind11;

namespace evenload {
namespace {

Curve curve_from(const py::iterable& chain) {
  std::vector<Vertex> vertices;
  for (const py::handle& item : chain) {
    const auto point = py::cast<py::sequence>(item);
    if (point.size() != 3 && point.size() != 4)
      throw std::invalid_argument("A chain is a list of (x, y, bulge) or (x, y, bulge, open).");
    vertices.push_back({{point[0].cast<double>(), point[1].cast<double>()},
                        point[2].cast<double>(),
                        point.size() == 4 && point[3].cast<bool>()});
  }
  return Curve(std::move(vertices), true);
}

py::list chain_of(const Curve& curve) {
  py::list chain;
  for (const Vertex& v : curve.vertices())
    chain.append(py::make_tuple(v.p.x, v.p.y, v.bulge, v.open));
  return chain;
}

const char* name_of(Termination termination) {
  switch (termination) {
    case Termination::kComplete:
      return "complete";
    case Termination::kIncomplete:
      return "incomplete";
    case Termination::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

py::list listed_moves(const Toolpath& path) {
  py::list moves;
  for (const Move& m : path.moves)
    moves.append(
        py::make_tuple(static_cast<int>(m.kind), m.x, m.y, m.z, m.sweep, m.cx, m.cy, m.feed));
  return moves;
}

Toolpath clear_pocket_from_python(const std::vector<Region>& regions, const py::kwargs& arguments) {
  Keywords keywords("clear_pocket", arguments);
  const ClearingCall call = clearing_call(keywords);
  std::optional<std::vector<std::vector<Region>>> stock;
  keywords.optional("stock", stock);
  keywords.refuse_others();
  Progress watch = progress_of(call.progress);
  const py::gil_scoped_release unlocked;
  return stock ? clear_rest(regions, *stock, call.params, watch)
               : clear_pocket(regions, call.params, watch);
}

std::vector<std::tuple<double, double, double, int>> profile_for_python(
    const std::vector<Region>& regions, const Toolpath& path, double tool_diameter,
    std::optional<std::tuple<double, double, double>> hole) {
  std::optional<Hole> drilled;
  if (hole) drilled = Hole{{std::get<0>(*hole), std::get<1>(*hole)}, std::get<2>(*hole)};
  std::vector<std::tuple<double, double, double, int>> result;
  for (const ProfilePoint& point : engagement_profile(regions, path, tool_diameter, drilled))
    result.emplace_back(point.p.x, point.p.y, point.engagement * 180 / kPi,
                        static_cast<int>(point.kind));
  return result;
}

}  // namespace
}  // namespace evenload

PYBIND11_MODULE(_core, m) {
  using namespace evenload;  // NOLINT: the module's own body
  m.doc() = "Constant-engagement milling: regions, offsets and toolpaths. mm, rad, mm/min.";

  static PyObject* geometry_error = nullptr;
  geometry_error = PyErr_NewExceptionWithDoc(
      "evenload._core.GeometryError",
      "Geometry that cannot be worked on, in a sentence of evenload.refusals. code: what is wrong; "
      "kind: the same more closely; where: (x, y) in mm; numbers: what comes with the kind.",
      PyExc_ValueError, nullptr);
  m.attr("GeometryError") = py::reinterpret_borrow<py::object>(geometry_error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const GeometryError& error) {
      const py::object type = py::reinterpret_borrow<py::object>(geometry_error);
      const py::tuple where = py::make_tuple(error.where().x, error.where().y);
      const py::tuple numbers = py::tuple(py::cast(error.numbers()));
      const char* kind = name_of(error.refusal());
      const py::object value =
          type(py::module_::import("evenload.refusals")
                   .attr("sentence")(kind, where, numbers, error.is_of_several()));
      value.attr("code") = name_of(error.code());
      value.attr("kind") = kind;
      value.attr("where") = where;
      value.attr("numbers") = numbers;
      PyErr_SetObject(type.ptr(), value.ptr());
    } catch (const InternalError& error) {
      PyErr_SetString(PyExc_RuntimeError, error.what());
    }
  });

  py::class_<Region>(m, "Region",
                     "A pocket's floor: an outer chain and island chains of (x, y, bulge[, open]).")
      .def(py::init([](const py::iterable& outer, const py::iterable& islands) {
             std::vector<Curve> holes;
             for (const py::handle& island : islands)
               holes.push_back(curve_from(py::cast<py::iterable>(island)));
             return make_region(curve_from(outer), std::move(holes));
           }),
           py::arg("outer"), py::arg("islands") = py::list())
      .def_property_readonly("outer", [](const Region& r) { return chain_of(r.outer); })
      .def_property_readonly("islands",
                             [](const Region& r) {
                               py::list islands;
                               for (const Curve& island : r.islands)
                                 islands.append(chain_of(island));
                               return islands;
                             })
      .def_property_readonly("area", &Region::area, "mm^2");

  py::class_<Report>(m, "Report")
      .def_property_readonly("termination", [](const Report& r) { return name_of(r.termination); })
      .def_readonly("max_engagement", &Report::max_engagement, "rad, worst mean over 0.1 mm")
      .def_readonly("cutting_time", &Report::cutting_time, "s")
      .def_readonly("ideal_time", &Report::ideal_time, "s")
      .def_readonly("removed_volume", &Report::removed_volume, "mm^3")
      .def_readonly("uncut_area", &Report::uncut_area, "mm^2")
      .def_readonly("cut_length", &Report::cut_length, "mm")
      .def_readonly("link_length", &Report::link_length, "mm")
      .def_readonly("passes", &Report::passes)
      .def_readonly("links", &Report::links)
      .def_readonly("retracts", &Report::retracts)
      .def_property_readonly(
          "findings", [](const Report& r) { return findings_for_python(r.findings); },
          "what was not done, where and why: (code, (x, y) or None, numbers) each");

  py::class_<Toolpath>(m, "Toolpath")
      .def_property_readonly(
          "moves", &listed_moves,
          "(kind, x, y, z, sweep, cx, cy, feed); kind 0 rapid, 1 link, 2 entry, 3 cut")
      .def("__len__", [](const Toolpath& toolpath) { return toolpath.moves.size(); })
      .def_readonly("report", &Toolpath::report);

  m.def("offset", &offset, py::arg("regions"), py::arg("distance"),
        "The regions grown (distance > 0) or shrunk by a distance in mm, arcs kept.");
  m.def(
      "united",
      [](const std::vector<std::vector<std::array<double, 2>>>& polygons, double tolerance) {
        std::vector<std::vector<Vec2>> points;
        for (const auto& polygon : polygons) {
          points.emplace_back();
          for (const auto& [x, y] : polygon) points.back().push_back({x, y});
        }
        std::vector<std::vector<std::array<double, 2>>> result;
        for (const std::vector<Vec2>& outline : united(points, tolerance)) {
          result.emplace_back();
          for (const Vec2 p : outline) result.back().push_back({p.x, p.y});
        }
        return result;
      },
      py::arg("polygons"), py::arg("tolerance"),
      "Nested outlines of what polygons, lists of (x, y) in mm, cover, to a tolerance in mm.");
  m.def("largest_tool", &largest_tool, py::arg("regions"),
        "Diameter in mm of the largest tool that fits.");
  bind_force(m);
  m.def("clear_pocket", &clear_pocket_from_python, py::arg("regions"),
        (std::string("The toolpath that clears the regions level by level at constant engagement. "
                     "stock: for each level, or once for all, the Regions in which material "
                     "stands; None: all over.\n\n") +
         kClearingArguments)
            .c_str());
  m.def("reachable_ground", &reachable_ground, py::arg("regions"), py::arg("tool_diameter"),
        py::arg("stock_to_leave") = 0.0, "The Regions that the tool's disc can reach.");
  m.def("engagement_profile", &profile_for_python, py::arg("regions"), py::arg("toolpath"),
        py::arg("tool_diameter"), py::arg("hole") = py::none(),
        "(x, y, engagement in degrees, kind) along the lowest level of a toolpath.");
  bind_trochoid(m);
  bind_lame(m);
  bind_proof(m);
  bind_python_objects(m);
  bind_surface_map(m);
  bind_simulate(m);
  bind_gcode(m);
  bind_path_commands(m);
  bind_dynamics(m);
  bind_ball_end(m);
  bind_inspection(m);
  bind_finishing(m);
}
