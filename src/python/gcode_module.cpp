#include "python/gcode_module.h"

#include <pybind11/stl.h>

#include <array>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "toolpath/gcode.h"

namespace py = pybind11;

namespace evenload {
namespace {

// Lists for Python begin with a rapid to the start, so that they stand by themselves: `first` is
// its entry.
template <typename T>
std::vector<T> with_start(const GCodeProgram& program, T first, const std::vector<T>& values) {
  std::vector<T> result;
  if (!program.has_start) return result;
  result.reserve(values.size() + 1);
  result.push_back(first);
  result.insert(result.end(), values.begin(), values.end());
  return result;
}

py::list program_moves(const GCodeProgram& program) {
  Move start;
  start.kind = MoveKind::kRapid;
  start.x = program.start_x;
  start.y = program.start_y;
  start.z = program.start_z;
  py::list moves;
  for (const Move& m : with_start(program, start, program.moves))
    moves.append(
        py::make_tuple(static_cast<int>(m.kind), m.x, m.y, m.z, m.sweep, m.cx, m.cy, m.feed));
  return moves;
}

template <typename T>
T first_of(const std::vector<T>& values) {
  return values.empty() ? T() : values.front();
}

// Programs hold bytes of any encoding: what is no UTF-8 is replaced.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

py::list notes_of(const GCodeProgram& program) {
  py::list notes;
  for (const GCodeNote& note : program.notes)
    notes.append(py::make_tuple(note.line, text_of(note.text)));
  return notes;
}

GCodeProgram read_gcode_from_python(const std::string& text, double arc_tolerance,
                                    bool block_delete, std::optional<std::array<double, 3>> start) {
  const py::gil_scoped_release unlocked;
  return read_gcode(text, {arc_tolerance, block_delete, start});
}

}  // namespace

void bind_gcode(py::module_& m) {
  static PyObject* gcode_error = nullptr;
  gcode_error = PyErr_NewExceptionWithDoc("evenload._core.GCodeError",
                                          "A G-code program that cannot be run. line: from 1.",
                                          PyExc_ValueError, nullptr);
  m.attr("GCodeError") = py::reinterpret_borrow<py::object>(gcode_error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const GCodeError& error) {
      const py::object type = py::reinterpret_borrow<py::object>(gcode_error);
      const py::object value = type(text_of(error.what()));
      value.attr("line") = error.line();
      PyErr_SetObject(type.ptr(), value.ptr());
    }
  });

  py::class_<GCodeProgram>(m, "GCodeProgram",
                           "A program read into moves. Lists have one entry per move; the first is "
                           "a rapid to the start.")
      .def_property_readonly("moves", &program_moves,
                             "(kind, x, y, z, sweep, cx, cy, feed); kind 0 rapid, 3 cut")
      .def_property_readonly(
          "lines", [](const GCodeProgram& p) { return with_start(p, first_of(p.lines), p.lines); },
          "The line of each move, from 1; the start has that of the first move.")
      .def_property_readonly(
          "tools", [](const GCodeProgram& p) { return with_start(p, first_of(p.tools), p.tools); },
          "The tool number of each move, 0 before any.")
      .def_property_readonly(
          "spindle_speeds",
          [](const GCodeProgram& p) {
            return with_start(p, first_of(p.spindle_speeds), p.spindle_speeds);
          },
          "rev/min at each move, 0 when off or unknown.")
      .def_readonly("dwell_s", &GCodeProgram::dwell_s, "s, all dwells together")
      .def_property_readonly("notes", &notes_of,
                             "[(line, sentence)]: what is unknown or not simulated");

  const GCodeOptions defaults;
  m.def(
      "read_gcode", &read_gcode_from_python, py::arg("text"), py::kw_only(),
      py::arg("arc_tolerance") = defaults.arc_tolerance, py::arg("block_delete") = false,
      py::arg("start") = py::none(),
      "A G-code program read into moves. arc_tolerance in mm, of lines in place of arcs in G18 and "
      "G19; block_delete skips lines that begin with '/'; start: (x, y, z) in mm, where the tool "
      "stands before the program. Raises GCodeError.");
}

}  // namespace evenload
