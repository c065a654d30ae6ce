#include "python/lame_module.h"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/clearing_params.h"
#include "strategy/lame/lame_clearing.h"

namespace py = pybind11;

namespace evenload {
namespace {

LameToolpath clear_from_python(const std::vector<Region>& regions, const py::kwargs& arguments) {
  Keywords keywords("clear_with_lame_spiral", arguments);
  const ClearingCall call = clearing_call(keywords);
  LameParams lame;
  keywords.optional("segments", lame.segments);
  keywords.optional("semi_axis_a", lame.semi_axis_a);
  keywords.optional("semi_axis_b", lame.semi_axis_b);
  keywords.optional("exponent_start", lame.exponent_start);
  keywords.optional("exponent_end", lame.exponent_end);
  keywords.optional("rotation", lame.rotation);
  keywords.optional("pitch", lame.pitch);
  std::optional<std::tuple<double, double>> centre;
  keywords.optional("centre", centre);
  if (centre) lame.centre = Vec2{std::get<0>(*centre), std::get<1>(*centre)};
  const auto course = [&](const char* name, std::vector<double>& target) {
    std::optional<std::vector<double>> given;
    keywords.optional(name, given);
    if (given) target = std::move(*given);
  };
  course("semi_axis_a_course", lame.semi_axis_a_course);
  course("semi_axis_b_course", lame.semi_axis_b_course);
  course("exponent_course", lame.exponent_course);
  keywords.choice("rest", {{"clear", LameRest::kClear}, {"leave", LameRest::kLeave}}, lame.rest);
  keywords.refuse_others();
  Progress watch = progress_of(call.progress);
  const py::gil_scoped_release unlocked;
  return clear_with_lame_spiral(regions, call.params, lame, watch);
}

}  // namespace

void bind_lame(py::module_& module) {
  py::class_<LameFigures>(module, "LameFigures", "The curve in which a spiral ends; mm, rad.")
      .def_property_readonly("segments", [](const LameFigures& f) { return f.last.segments; })
      .def_property_readonly("semi_axis_a", [](const LameFigures& f) { return f.last.a; })
      .def_property_readonly("semi_axis_b", [](const LameFigures& f) { return f.last.b; })
      .def_readonly("exponent_start", &LameFigures::exponent_start)
      .def_property_readonly("exponent_end", [](const LameFigures& f) { return f.last.exponent; })
      .def_property_readonly("rotation", [](const LameFigures& f) { return f.last.rotation; })
      .def_readonly("pitch", &LameFigures::pitch, "the largest step of a turn")
      .def_property_readonly("centre", [](const LameFigures& f) {
        return std::make_tuple(f.last.centre.x, f.last.centre.y);
      });
  py::class_<LameToolpath, Toolpath>(module, "LameToolpath")
      .def_readonly("cleared_share", &LameToolpath::cleared_share,
                    "of the ground within reach, by spirals")
      .def_readonly("figures", &LameToolpath::figures,
                    "of the spiral that clears most; None where none is made");
  module.def("clear_with_lame_spiral", &clear_from_python, py::arg("regions"),
             (std::string("The toolpath that clears the regions with Lamé spirals. Its own keyword "
                          "arguments, fitted where they are missing or None: segments, "
                          "semi_axis_a, semi_axis_b, exponent_start, exponent_end, rotation, "
                          "pitch (mm per turn, at most), centre (x, y); courses from the first "
                          "turn to the last, even where they are missing, None or empty: "
                          "semi_axis_a_course, semi_axis_b_course, exponent_course (shares of the "
                          "change at even steps of the way, as [0, 0.1, 0.4, 1]); and rest "
                          "('clear', 'leave'). They describe the way of the tool's centre.\n\n") +
              kClearingArguments)
                 .c_str());
}

}  // namespace evenload
