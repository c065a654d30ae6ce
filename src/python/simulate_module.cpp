#include "python/simulate_module.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "python/moves_from.h"
#include "simulate/simulate.h"
#include "simulate/standing.h"
#include "simulate/wall_contact.h"

namespace py = pybind11;

namespace evenload {
namespace {

using PrismTuple = std::pair<Region, double>;

std::vector<Prism> prisms_from(const std::vector<PrismTuple>& tuples) {
  std::vector<Prism> prisms;
  for (const auto& [region, top] : tuples) prisms.push_back({region, top});
  return prisms;
}

// The vector becomes the array's memory.
template <typename T>
py::array_t<T> array_of(std::vector<T>&& values) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}

py::tuple tuple_of(const Place& p) { return py::make_tuple(p.x, p.y, p.z); }

py::dict record_of(LoadRecord&& record) {
  py::dict d;
  py::array_t<double> arcs({static_cast<py::ssize_t>(record.arcs.size()), py::ssize_t{3}});
  auto view = arcs.mutable_unchecked<2>();
  for (std::size_t i = 0; i < record.arcs.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    view(row, 0) = record.arcs[i].low;
    view(row, 1) = record.arcs[i].high;
    view(row, 2) = record.arcs[i].depth;
  }
  d["arcs"] = arcs;
  std::vector<std::int64_t> first(record.first_arc.begin(), record.first_arc.end());
  d["first_arc"] = array_of(std::move(first));
  d["move"] = array_of(std::move(record.move));
  d["kind"] = array_of(std::move(record.kind));
  for (auto [name, values] : std::initializer_list<std::pair<const char*, std::vector<double>*>>{
           {"x", &record.x},
           {"y", &record.y},
           {"z", &record.z},
           {"length", &record.length},
           {"time", &record.time},
           {"machine_time", &record.machine_time},
           {"feed", &record.feed},
           {"engagement", &record.engagement},
           {"axial_depth", &record.axial_depth},
           {"removal_rate", &record.removal_rate},
           {"removed_volume", &record.removed_volume},
           {"h_max", &record.h_max},
           {"h_mean", &record.h_mean},
           {"gouge", &record.gouge},
           {"force_peak", &record.force_peak},
           {"force_mean", &record.force_mean},
           {"force_x_peak", &record.force_x_peak},
           {"force_y_peak", &record.force_y_peak},
           {"torque_peak", &record.torque_peak},
           {"torque_mean", &record.torque_mean},
           {"power_mean", &record.power_mean}})
    d[name] = array_of(std::move(*values));
  return d;
}

const char* name_of(IncidentKind kind) {
  switch (kind) {
    case IncidentKind::kGouge:
      return "gouge";
    case IncidentKind::kFixture:
      return "fixture";
    case IncidentKind::kRapidInMaterial:
      return "rapid in material";
    case IncidentKind::kPlungeInMaterial:
      return "plunge in material";
  }
  return "unknown";
}

py::dict figures_of(const LoadFigures& f) {
  py::dict d;
  for (const auto& [name, worst] : std::initializer_list<std::pair<const char*, const Worst*>>{
           {"engagement", &f.engagement},
           {"link_engagement", &f.link_engagement},
           {"entry_engagement", &f.entry_engagement},
           {"removal_rate", &f.removal_rate},
           {"force", &f.force},
           {"gouge", &f.gouge},
           {"fixture", &f.fixture},
           {"rapid_in_material", &f.rapid_in_material},
           {"plunge_in_material", &f.plunge_in_material}})
    d[name] = py::make_tuple(worst->value, tuple_of(worst->at));
  py::list incidents;
  for (const Incident& incident : f.incidents)
    incidents.append(py::make_tuple(name_of(incident.kind), tuple_of(incident.at), incident.move,
                                    incident.amount));
  d["incidents"] = incidents;
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{
           {"cut_length", f.cut_length},
           {"air_length", f.air_length},
           {"link_length", f.link_length},
           {"entry_length", f.entry_length},
           {"rapid_length", f.rapid_length},
           {"time", f.time},
           {"machine_time", f.machine_time},
           {"removed_volume", f.removed_volume},
           {"removed_area", f.removed_area},
           {"rest_area", f.rest.area},
           {"rest_depth", f.rest.depth},
           {"unreachable_area", f.rest.unreachable_area}})
    d[name] = value;
  py::list patches, outlines;
  for (const RestPatch& patch : f.rest.patches)
    patches.append(py::make_tuple(patch.area, patch.at.x, patch.at.y, patch.depth));
  for (const std::vector<Vec2>& outline : f.rest.outlines) {
    py::list points;
    for (const Vec2 p : outline) points.append(py::make_tuple(p.x, p.y));
    outlines.append(points);
  }
  d["rests"] = patches;
  d["rest_outlines"] = outlines;
  return d;
}

py::tuple simulate_from_python(const py::object& source, DexelStock& stock, double tool_diameter,
                               int teeth, double spindle_speed, double rapid_feed, double step,
                               bool infer_kinds, const std::vector<PrismTuple>& part,
                               const std::vector<PrismTuple>& fixtures,
                               const std::optional<ForceCoefficients>& force, double helix_angle,
                               const std::optional<MachineProfile>& machine, bool find_rest,
                               const std::function<bool(double)>& progress) {
  const std::vector<Move> moves = moves_from(source);
  SimulationParams params;
  params.tool_diameter = tool_diameter;
  params.teeth = teeth;
  params.spindle_speed = spindle_speed;
  params.rapid_feed = rapid_feed;
  params.step = step;
  params.infer_kinds = infer_kinds;
  params.part = prisms_from(part);
  params.fixtures = prisms_from(fixtures);
  if (force) params.force = ForceParams{*force, helix_angle};
  params.machine = machine;
  params.find_rest = find_rest;
  Progress watch = progress ? Progress([&progress](double share) {
    const py::gil_scoped_acquire lock;
    return progress(share);
  })
                            : Progress();
  Simulation result;
  {
    const py::gil_scoped_release unlocked;
    result = simulate(moves, stock, params, watch);
  }
  return py::make_tuple(record_of(std::move(result.record)), figures_of(result.figures),
                        result.cancelled);
}

// Rows of (x, y, z, feed angle) of a tool.
py::array_t<bool> stands_beside_from_python(const DexelStock& stock,
                                            const py::array_t<double>& places, double radius) {
  if (places.ndim() != 2 || places.shape(1) != 4)
    throw std::invalid_argument("Places are rows of x, y, z and the feed's angle.");
  const auto rows = places.unchecked<2>();
  std::vector<ToolCircle> tools;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    tools.push_back({{rows(i, 0), rows(i, 1)}, radius, rows(i, 2), rows(i, 3)});
  std::vector<char> found;
  {
    const py::gil_scoped_release unlocked;
    found = stands_beside(stock, tools);
  }
  py::array_t<bool> result(static_cast<py::ssize_t>(found.size()));
  std::transform(found.begin(), found.end(), result.mutable_data(),
                 [](char each) { return each != 0; });
  return result;
}

}  // namespace

void bind_simulate(py::module_& module) {
  py::class_<DexelStock>(module, "DexelStock",
                         "Stock as dexels: prisms (Region, top) down to `bottom`. mm.")
      .def(py::init([](const std::vector<PrismTuple>& prisms, double bottom, double resolution) {
             return DexelStock(prisms_from(prisms), bottom, resolution);
           }),
           py::arg("prisms"), py::arg("bottom"), py::arg("resolution"))
      .def(py::init<const HeightMap&, double, double>(), py::arg("map"), py::arg("bottom"),
           py::arg("resolution"))
      .def("copy", [](const DexelStock& stock) { return DexelStock(stock); })
      .def(
          "drill",
          [](DexelStock& stock, double x, double y, double diameter) {
            stock.cut(Segment::line({x, y}, {x, y}), 0.5 * diameter, stock.bottom());
          },
          py::arg("x"), py::arg("y"), py::arg("diameter"),
          "Takes out a round hole, all the way down.")
      .def(
          "height_at",
          [](const DexelStock& stock, double x, double y) {
            return stock.height_at({x, y});
          },
          py::arg("x"), py::arg("y"), "z of the stock, -inf where there is none.")
      .def(
          "area_lacking",
          [](const DexelStock& stock, const std::vector<PrismTuple>& prisms) {
            return stock.area_lacking(prisms_from(prisms));
          },
          py::arg("prisms"), "mm^2 of prisms where the stock does not stand so high.")
      .def("standing", &standing_regions, py::arg("z"), py::arg("reach"),
           "The Regions of `reach` over which the stock stands higher than z, without slivers.")
      .def("stands_beside", &stands_beside_from_python, py::arg("places"), py::arg("radius"),
           "For each row (x, y, z, feed angle) of an n x 4 array whether the stock stands beside a "
           "tool there, within two spacings of the dexels. mm, rad.")
      .def_property_readonly("area", &DexelStock::area, "mm^2")
      .def_property_readonly("volume", &DexelStock::volume, "mm^3")
      .def_property_readonly("resolution", &DexelStock::resolution, "mm")
      .def_property_readonly("top", &DexelStock::top, "mm")
      .def_property_readonly("bottom", &DexelStock::bottom, "mm");

  module.def("simulate", &simulate_from_python, py::arg("moves"), py::arg("stock"), py::kw_only(),
             py::arg("tool_diameter"), py::arg("teeth") = 1, py::arg("spindle_speed") = 0.0,
             py::arg("rapid_feed") = 5000.0, py::arg("step") = 0.1, py::arg("infer_kinds") = false,
             py::arg("part") = std::vector<PrismTuple>(),
             py::arg("fixtures") = std::vector<PrismTuple>(), py::arg("force") = py::none(),
             py::arg("helix_angle") = 0.0, py::arg("machine") = py::none(),
             py::arg("find_rest") = true, py::arg("progress") = nullptr,
             "Runs moves, or a Toolpath, on the stock, which is cut: (record of arrays, figures, "
             "cancelled). rad, mm, mm/min.");
}

}  // namespace evenload
