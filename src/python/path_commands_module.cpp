#include "python/path_commands_module.h"

#include <pybind11/stl.h>

#include <array>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "python/moves_from.h"
#include "toolpath/path_commands.h"

namespace py = pybind11;

namespace evenload {
namespace {

py::list path_commands_for_python(const py::object& toolpath,
                                  const std::optional<std::tuple<double, double, double>>& start,
                                  double left_out_from) {
  std::optional<Position> at;
  if (start) at = Position{std::get<0>(*start), std::get<1>(*start), std::get<2>(*start)};
  const std::vector<PathCommand> commands = path_commands(moves_from(toolpath), at, left_out_from);
  const std::array<py::str, 4> names{py::str("G0"), py::str("G1"), py::str("G2"), py::str("G3")};
  const py::str x("X"), y("Y"), z("Z"), i("I"), j("J"), f("F");
  py::list result(commands.size());
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const PathCommand& command = commands[k];
    py::dict words;
    const auto name = [&words](const py::str& word, const std::optional<double>& value) {
      if (value) words[word] = py::float_(*value);
    };
    name(x, command.x);
    name(y, command.y);
    name(z, command.z);
    name(i, command.i);
    name(j, command.j);
    name(f, command.feed);
    result[k] = py::make_tuple(names[static_cast<std::size_t>(command.code)], std::move(words));
  }
  return result;
}

}  // namespace

void bind_path_commands(py::module_& m) {
  m.def("path_commands", &path_commands_for_python, py::arg("toolpath"),
        py::arg("start") = py::none(),
        py::arg("left_out_from") = std::numeric_limits<double>::infinity(),
        "[(name, {word: value})] of a Toolpath, or of moves as Toolpath.moves gives them, as G0, "
        "G1, G2 and G3 with ends and centres that survive rounding. start: (x, y, z) where the "
        "tool is, None for anywhere above everything; rapids at the end at left_out_from or above "
        "are left out.");
}

}  // namespace evenload
