#include "python/surface_map_module.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "python/clearing_params.h"
#include "python/moves_from.h"
#include "simulate/surface_map.h"

namespace py = pybind11;

namespace evenload {
namespace {

using MapFlags = py::array_t<bool, py::array::c_style | py::array::forcecast>;

// Rows of cells, in numbers of another type where that is wished.
template <typename Shown, typename T>
py::array_t<Shown> cells_of(const std::vector<T>& values, const SurfaceMapParams& params) {
  py::array_t<Shown> result({params.rows, params.columns});
  std::copy(values.begin(), values.end(), result.mutable_data());
  return result;
}

py::dict surface_map_for_python(const HeightMap& part, const MapFlags& picked,
                                const py::object& source, const py::kwargs& arguments) {
  Keywords keywords("surface_map", arguments);
  SurfaceMapParams params;
  double diameter = 0;
  std::array<double, 2> first{};
  std::array<int, 2> cells{};
  std::function<bool(double)> callback;
  keywords.required("tool_diameter", diameter);
  params.cutter.radius = 0.5 * diameter;
  keywords.required("corner_radius", params.cutter.corner);
  keywords.required("first", first);
  keywords.required("spacing", params.spacing);
  keywords.required("cells", cells);
  keywords.required("stock", params.stock);
  keywords.optional("teeth_per_minute", params.teeth_per_minute);
  keywords.optional("threads", params.threads);
  keywords.optional("progress", callback);
  keywords.refuse_others();
  params.first = {first[0], first[1]};
  params.columns = cells[0];
  params.rows = cells[1];
  if (picked.ndim() != 1) throw std::invalid_argument("What is picked is a list.");
  const std::vector<bool> flags(picked.data(), picked.data() + picked.size());
  const std::vector<Move> moves = moves_from(source);
  Progress watch = progress_of(callback);
  SurfaceMap map;
  {
    const py::gil_scoped_release unlocked;
    map = map_surface(part, flags, moves, params, watch);
  }
  py::dict found;
  found["part"] = cells_of<double>(map.part, params);
  found["lean"] = cells_of<float>(map.lean, params);
  found["is_picked"] = cells_of<bool>(map.is_picked, params);
  found["above"] = cells_of<double>(map.above, params);
  found["move"] = cells_of<std::int32_t>(map.move, params);
  found["along"] = cells_of<double>(map.along, params);
  found["cusp"] = cells_of<double>(map.cusp, params);
  return found;
}

}  // namespace

void bind_surface_map(py::module_& module) {
  module.def(
      "surface_map", &surface_map_for_python, py::arg("part"), py::arg("picked"), py::arg("moves"),
      "What a tool with a rounded end leaves on a HeightMap, of whose triangles some are picked: "
      "arrays of rows of cells by name: part, z in mm, -inf where there is none; lean, z of its "
      "normal; is_picked; above, mm across the surface that stand on it, negative: cut into it; "
      "move, that has cut there, -1: none; along, mm of path up to there; cusp, mm, nan where none "
      "is. tool_diameter, corner_radius, spacing, stock, which stands there before, in mm; first: "
      "(x, y) of the first cell's middle; cells: (along x, along y); teeth_per_minute, 0: without "
      "the marks of teeth; threads; progress: callable(share) -> whether to go on, or Cancelled is "
      "raised.");
}

}  // namespace evenload
