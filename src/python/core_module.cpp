// Module _core: the C++ core for Python. Lengths in mm, angles in rad, feeds in mm/min.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <string>
#include <tuple>

#include "cutting/cleared_ground.h"
#include "cutting/force.h"
#include "feed/load_profile.h"
#include "geometry/medial_axis.h"
#include "geometry/region.h"
#include "python/engagement_profile.h"
#include "python/force_module.h"
#include "python/gcode_module.h"
#include "python/path_commands_module.h"
#include "python/simulate_module.h"
#include "strategy/constant_engagement.h"
#include "strategy/rest_levels.h"
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

template <typename T>
T choice(const std::string& name, const std::string& value,
         const std::map<std::string, T>& choices) {
  const auto found = choices.find(value);
  if (found != choices.end()) return found->second;
  std::string known;
  for (const auto& [word, unused] : choices)
    known += (known.empty() ? "" : ", ") + ("'" + word + "'");
  throw std::invalid_argument(name + " must be one of " + known + ", not '" + value + "'.");
}

const char* name_of(GeometryErrorCode code) {
  switch (code) {
    case GeometryErrorCode::kNotFinite:
      return "not finite";
    case GeometryErrorCode::kTooFewPoints:
      return "too few points";
    case GeometryErrorCode::kOpen:
      return "open";
    case GeometryErrorCode::kSelfCrossing:
      return "self-crossing";
    case GeometryErrorCode::kIslandOutside:
      return "island outside";
    case GeometryErrorCode::kToolTooLarge:
      return "tool too large";
    case GeometryErrorCode::kEntryOutside:
      return "entry outside";
  }
  return "unknown";
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

py::list moves_of(const Toolpath& path) {
  py::list moves;
  for (const Move& m : path.moves)
    moves.append(
        py::make_tuple(static_cast<int>(m.kind), m.x, m.y, m.z, m.sweep, m.cx, m.cy, m.feed));
  return moves;
}

Toolpath clear_pocket_from_python(
    const std::vector<Region>& regions, double tool_diameter, double engagement_angle,
    const std::string& cut_mode, const std::string& feed_control, double feed, double plunge_feed,
    double link_feed, double maximum_feed, double rapid_feed, double roll_radius,
    double minimum_radius, const std::string& entry, double helix_angle, double helix_diameter,
    std::optional<std::tuple<double, double>> entry_point, double hole_diameter,
    double stock_to_leave, bool wall_pass, double tolerance, bool arcs, double link_lift,
    double top, std::vector<double> levels, double safe_height, double clearance_height,
    const std::string& order_by, const std::string& narrow_passages,
    const ForceCoefficients& force_coefficients, int teeth, double tool_helix_angle,
    double spindle_speed, const std::optional<std::vector<std::vector<Region>>>& stock,
    std::function<bool(double)> progress) {
  ClearingParams params;
  params.tool_diameter = tool_diameter;
  params.engagement_angle = engagement_angle;
  params.cut_mode = choice<CutMode>(
      "cut_mode", cut_mode, {{"climb", CutMode::kClimb}, {"conventional", CutMode::kConventional}});
  params.feed_control =
      choice<FeedControl>("feed_control", feed_control,
                          {{"constant feed", FeedControl::kConstantFeed},
                           {"constant removal rate", FeedControl::kConstantRemovalRate},
                           {"constant chip thickness", FeedControl::kConstantChipThickness},
                           {"constant force", FeedControl::kConstantForce}});
  params.feed = feed;
  params.plunge_feed = plunge_feed;
  params.link_feed = link_feed;
  params.maximum_feed = maximum_feed;
  params.rapid_feed = rapid_feed;
  params.roll_radius = roll_radius;
  params.minimum_radius = minimum_radius;
  params.entry = choice<EntryKind>("entry", entry,
                                   {{"automatic", EntryKind::kAutomatic},
                                    {"helix", EntryKind::kHelix},
                                    {"ramp", EntryKind::kRamp},
                                    {"predrilled hole", EntryKind::kPredrilledHole}});
  params.helix_angle = helix_angle;
  params.helix_diameter = helix_diameter;
  if (entry_point) params.entry_point = Vec2{std::get<0>(*entry_point), std::get<1>(*entry_point)};
  params.hole_diameter = hole_diameter;
  params.stock_to_leave = stock_to_leave;
  params.wall_pass = wall_pass;
  params.tolerance = tolerance;
  params.arcs = arcs;
  params.link_lift = link_lift;
  params.top = top;
  params.levels = std::move(levels);
  params.safe_height = safe_height;
  params.clearance_height = clearance_height;
  params.force_coefficients = force_coefficients;
  params.teeth = teeth;
  params.tool_helix_angle = tool_helix_angle;
  params.spindle_speed = spindle_speed;
  params.order_by = choice<OrderBy>("order_by", order_by,
                                    {{"region", OrderBy::kRegion}, {"depth", OrderBy::kDepth}});
  params.narrow_passages =
      choice<NarrowPassages>("narrow_passages", narrow_passages,
                             {{"trochoid with smaller radius", NarrowPassages::kTrochoid},
                              {"cut at reduced feed", NarrowPassages::kReducedFeed},
                              {"skip and report", NarrowPassages::kSkip}});
  Progress watch = progress ? Progress([&progress](double share) {
    const py::gil_scoped_acquire lock;
    return progress(share);
  })
                            : Progress();
  const py::gil_scoped_release unlocked;
  return stock ? clear_rest(regions, *stock, params, watch) : clear_pocket(regions, params, watch);
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
      "Geometry that cannot be worked on. code: what is wrong; where: (x, y) in mm.",
      PyExc_ValueError, nullptr);
  m.attr("GeometryError") = py::reinterpret_borrow<py::object>(geometry_error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const GeometryError& error) {
      const py::object type = py::reinterpret_borrow<py::object>(geometry_error);
      const py::object value = type(error.what());
      value.attr("code") = name_of(error.code());
      value.attr("where") = py::make_tuple(error.where().x, error.where().y);
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
      .def_readonly("notes", &Report::notes);

  py::class_<Toolpath>(m, "Toolpath")
      .def_property_readonly(
          "moves", &moves_of,
          "(kind, x, y, z, sweep, cx, cy, feed); kind 0 rapid, 1 link, 2 entry, 3 cut")
      .def("__len__", [](const Toolpath& toolpath) { return toolpath.moves.size(); })
      .def_readonly("report", &Toolpath::report);

  m.def("offset", &offset, py::arg("regions"), py::arg("distance"),
        "The regions grown (distance > 0) or shrunk by a distance in mm, arcs kept.");
  m.def("largest_tool", &largest_tool, py::arg("regions"),
        "Diameter in mm of the largest tool that fits.");
  bind_force(m);
  const ClearingParams defaults;
  m.def(
      "clear_pocket", &clear_pocket_from_python, py::arg("regions"), py::kw_only(),
      py::arg("tool_diameter"), py::arg("engagement_angle"), py::arg("cut_mode") = "climb",
      py::arg("feed_control") = "constant feed", py::arg("feed"), py::arg("plunge_feed"),
      py::arg("link_feed"), py::arg("maximum_feed"), py::arg("rapid_feed") = defaults.rapid_feed,
      py::arg("roll_radius") = defaults.roll_radius,
      py::arg("minimum_radius") = defaults.minimum_radius, py::arg("entry") = "automatic",
      py::arg("helix_angle") = defaults.helix_angle,
      py::arg("helix_diameter") = defaults.helix_diameter, py::arg("entry_point") = py::none(),
      py::arg("hole_diameter") = 0.0, py::arg("stock_to_leave") = 0.0, py::arg("wall_pass") = true,
      py::arg("tolerance") = defaults.tolerance, py::arg("arcs") = true, py::arg("link_lift") = 0.0,
      py::arg("top") = 0.0, py::arg("levels"), py::arg("safe_height"), py::arg("clearance_height"),
      py::arg("order_by") = "region", py::arg("narrow_passages") = "trochoid with smaller radius",
      py::arg("force_coefficients") = defaults.force_coefficients, py::arg("teeth") = 1,
      py::arg("tool_helix_angle") = defaults.tool_helix_angle, py::arg("spindle_speed") = 0.0,
      py::arg("stock") = py::none(), py::arg("progress") = nullptr,
      "The toolpath that clears the regions level by level at constant engagement. stock: for each "
      "level, or once for all, the Regions in which material stands; None: all over.");
  m.def("reachable_ground", &reachable_ground, py::arg("regions"), py::arg("tool_diameter"),
        py::arg("stock_to_leave") = 0.0, "The Regions that the tool's disc can reach.");
  m.def("engagement_profile", &profile_for_python, py::arg("regions"), py::arg("toolpath"),
        py::arg("tool_diameter"), py::arg("hole") = py::none(),
        "(x, y, engagement in degrees, kind) along the lowest level of a toolpath.");
  bind_simulate(m);
  bind_gcode(m);
  bind_path_commands(m);
}
