#include "python/trochoid_module.h"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/slot_around.h"
#include "python/clearing_params.h"
#include "strategy/pocket/trochoid.h"
#include "strategy/trochoid/trochoid_pattern.h"

namespace py = pybind11;

namespace evenload {
namespace {

const std::map<std::string, TrochoidKind>& patterns() {
  static const std::map<std::string, TrochoidKind> words{
      {"constant engagement", TrochoidKind::kConstantEngagement},
      {"circular", TrochoidKind::kCircular},
      {"cycloid", TrochoidKind::kCycloid}};
  return words;
}

std::pair<Toolpath, TrochoidReport> clear_slot_from_python(const std::vector<Region>& regions,
                                                           const py::kwargs& arguments) {
  Keywords keywords("clear_slot", arguments);
  const ClearingCall call = clearing_call(keywords);
  TrochoidKind kind = TrochoidKind::kConstantEngagement;
  keywords.choice("pattern", patterns(), kind);
  keywords.refuse_others();
  Progress watch = progress_of(call.progress);
  const py::gil_scoped_release unlocked;
  TrochoidalPath result = clear_slot(regions, kind, call.params, watch);
  return {std::move(result.path), result.report};
}

Region slot_around_from_python(const std::vector<std::tuple<double, double, double>>& middle,
                               double width, const std::string& ends, bool closed) {
  static const std::map<std::string, SlotEnds> words{
      {"round", SlotEnds::kRound}, {"square", SlotEnds::kSquare}, {"open", SlotEnds::kOpen}};
  const auto found = words.find(ends);
  if (found == words.end())
    throw std::invalid_argument("ends must be one of 'open', 'round', 'square', not '" + ends +
                                "'.");
  std::vector<Vertex> vertices;
  for (const auto& [x, y, bulge] : middle) vertices.push_back({{x, y}, bulge});
  return slot_around(Curve(std::move(vertices), closed), width, found->second);
}

py::list moves_of(const std::vector<Segment>& moves) {
  py::list list;
  for (const Segment& s : moves) list.append(py::make_tuple(s.a.x, s.a.y, s.b.x, s.b.y, s.bulge()));
  return list;
}

TrochoidParams params_from(Keywords& keywords) {
  TrochoidParams params;
  double diameter = 0;
  keywords.required("tool_diameter", diameter);
  params.tool_radius = 0.5 * diameter;
  keywords.required("width", params.width);
  keywords.required("engagement_angle", params.engagement);
  keywords.optional("curvature", params.curvature);
  keywords.optional("roll_radius", params.turn_radius);
  keywords.required("feed", params.feed);
  params.maximum_feed = params.feed;
  keywords.optional("maximum_feed", params.maximum_feed);
  keywords.required("link_feed", params.link_feed);
  keywords.optional("finish_walls", params.finish_walls);
  return params;
}

py::object pattern_from_python(const py::kwargs& arguments) {
  Keywords keywords("trochoid_pattern", arguments);
  TrochoidKind kind = TrochoidKind::kConstantEngagement;
  keywords.choice("pattern", patterns(), kind);
  const TrochoidParams params = params_from(keywords);
  keywords.refuse_others();
  const std::optional<TrochoidPattern> pattern = make_pattern(kind, params);
  if (!pattern) return py::none();
  const PatternFigures figures = figures_of(*pattern, params);
  py::dict result;
  result["cut"] = moves_of(pattern->cut);
  result["link"] = moves_of(pattern->link);
  result["step"] = pattern->step;
  result["turn_radius"] = pattern->turn_radius;
  result["residuals"] = pattern->residuals;
  result["cut_length"] = figures.cut_length;
  result["link_length"] = figures.link_length;
  result["area_per_length"] = figures.area_per_length;
  result["max_engagement"] = figures.max_engagement;
  result["within"] = figures.within;
  result["time"] = figures.time;
  result["removal"] = figures.removal;
  return result;
}

py::tuple passes_from_python(const py::kwargs& arguments) {
  Keywords keywords("trochoid_passes", arguments);
  const TrochoidParams params = params_from(keywords);
  int most = 10;
  keywords.optional("most", most);
  keywords.refuse_others();
  const PassSequence sequence = iterate_passes(params, params.turn_radius, most);
  py::list passes;
  for (const std::vector<Segment>& pass : sequence.passes) passes.append(moves_of(pass));
  return py::make_tuple(passes, sequence.residuals);
}

}  // namespace

void bind_trochoid(py::module_& m) {
  py::class_<TrochoidReport>(m, "TrochoidReport")
      .def_readonly("step", &TrochoidReport::step, "mm; 0: no pattern was repeated")
      .def_readonly("iterations", &TrochoidReport::iterations)
      .def_readonly("residual", &TrochoidReport::residual, "mm")
      .def_readonly("removal_rate", &TrochoidReport::removal_rate, "mm^3/min")
      .def_readonly("length", &TrochoidReport::length, "mm of slot");
  m.def("clear_slot", &clear_slot_from_python, py::arg("regions"),
        (std::string("(toolpath, trochoid report): the regions cleared by a trochoid along their "
                     "slots. pattern: 'constant engagement', 'circular' or 'cycloid'. ") +
         kClearingArguments)
            .c_str());
  m.def("slot_around", &slot_around_from_python, py::arg("middle"), py::kw_only(), py::arg("width"),
        py::arg("ends") = "round", py::arg("closed") = false,
        "The Region of a slot about a chain of (x, y, bulge). ends: 'round', 'square' or 'open'.");
  m.def("trochoid_pattern", &pattern_from_python,
        "One period of a trochoid along a slot, and its figures; None where the slot is too "
        "narrow. pattern, tool_diameter, width, engagement_angle (rad), curvature (1/mm), "
        "roll_radius, feed, maximum_feed, link_feed, finish_walls.");
  m.def("trochoid_passes", &passes_from_python,
        "(passes, residuals in mm): the passes that settle to the pattern of constant engagement, "
        "at most `most`, with roll_radius as it is; arguments as for trochoid_pattern.");
}

}  // namespace evenload
