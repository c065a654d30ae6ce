#include "python/ball_end_module.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "ball_end/chips.h"
#include "python/clearing_params.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Callback = std::function<bool(double)>;
// Number of the surface, y, ball radius, feed per tooth, stepover, allowance, feed direction,
// uncut.
constexpr py::ssize_t kColumns = 8;
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr py::ssize_t kFigures = 7;

py::array_t<double> chips_for_python(const std::vector<Worked>& surfaces, int steps,
                                     const Rows& rows, int threads, const Callback& callback) {
  if (rows.ndim() != 2 || rows.shape(1) != kColumns)
    throw std::invalid_argument("Chips are told by rows of eight numbers.");
  std::vector<WantedChip> wanted;
  const auto at = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    wanted.push_back({static_cast<std::size_t>(at(i, 0)),
                      at(i, 1),
                      {at(i, 2), at(i, 3), at(i, 4), at(i, 5), at(i, 6),
                       static_cast<Uncut>(static_cast<int>(at(i, 7)))}});
  Progress asked = progress_of(callback);
  std::vector<Chip> found;
  {
    const py::gil_scoped_release unlocked;
    found = chips(surfaces, static_cast<Steps>(steps), wanted, threads, asked);
  }
  py::array_t<double> result({static_cast<py::ssize_t>(found.size()), kFigures});
  double* into = result.mutable_data();
  for (const Chip& c : found)
    for (const double figure : {c.volume, c.tool_face, c.previous_face, c.max_thickness,
                                c.edge_from, c.edge_to, c.tip_share})
      *into++ = figure;
  return result;
}

}  // namespace

void bind_ball_end(py::module_& module) {
  py::module_ m = module.def_submodule("ball_end", "Chips of ball-end tools, in mm and rad.");
  py::class_<PartProfile>(m, "PartProfile", "A section of lines and arcs, in mm and rad.")
      .def_property_readonly("start",
                             [](const PartProfile& p) {
                               return std::array{p.start.x, p.start.y};
                             })
      .def_readonly("lean", &PartProfile::lean)
      .def_property_readonly("pieces", [](const PartProfile& p) {
        std::vector<std::array<double, 2>> result;  // length, curvature
        for (const ProfilePiece& piece : p.pieces)
          result.push_back({piece.length, piece.curvature});
        return result;
      });
  m.def("plane_profile", &plane_profile);
  m.def("cylinder_profile", &cylinder_profile, py::arg("radius"));
  m.def("test_part_profile", &test_part_profile, py::arg("is_convex"));
  py::class_<BentPlace>(m, "BentPlace", "Curvatures in 1/mm, slope and direction in rad.")
      .def(py::init([](double first, double second, double slope, double towards) {
             return BentPlace{first, second, slope, towards};
           }),
           py::arg("first"), py::arg("second"), py::arg("slope"), py::arg("towards"));
  m.def("chips", &chips_for_python, py::arg("surfaces"), py::arg("steps"), py::arg("rows"),
        py::arg("threads"), py::arg("progress"),
        "An array of 7 columns: volume, tool_face, previous_face, max_thickness, edge from, edge "
        "to, tip_share.");
}

}  // namespace evenload
