// Frequency responses and stability in the frequency domain, for Python.
#include <pybind11/complex.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <complex>
#include <functional>
#include <tuple>
#include <vector>

#include "dynamics/frequency_chart.h"
#include "python/clearing_params.h"
#include "python/dynamics_module.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Callback = std::function<bool(double)>;
using Values = std::vector<std::complex<double>>;

// Receptances at angular frequencies: rows of (xx, xy, yx, yy).
Values values_at(const SharedReceptance& receptance, const std::vector<double>& frequencies) {
  Values result;
  for (const double frequency : frequencies) {
    const Eigen::Matrix2cd value = receptance.of(frequency);
    result.insert(result.end(), {value(0, 0), value(0, 1), value(1, 0), value(1, 1)});
  }
  return result;
}

}  // namespace

void bind_frequency(py::module_& m) {
  py::class_<SharedReceptance>(m, "Receptance")
      .def_static(
          "of_modes",
          [](const std::vector<Mode>& modes) {
            check_modes(modes);
            return SharedReceptance{[modes](double w) { return receptance(modes, w); }};
          },
          py::arg("modes"))
      .def_static(
          "of_lines",
          [](const std::vector<double>& frequencies, const Values& xx, const Values& yy,
             const Values& xy) { return SharedReceptance{Frf(frequencies, xx, yy, xy)}; },
          py::arg("frequencies"), py::arg("xx"), py::arg("yy"), py::arg("xy"))
      .def("at", &values_at, py::arg("frequencies"));
  py::class_<FrequencyDomain>(m, "FrequencyDomain")
      .def(py::init([](const Milling& milling, const SharedReceptance& receptance, int harmonics) {
             return FrequencyDomain(milling, receptance.of, harmonics);
           }),
           py::arg("milling"), py::arg("receptance"), py::arg("harmonics"))
      .def("determinant", &FrequencyDomain::determinant, py::arg("speed"), py::arg("depth"),
           py::arg("frequency"))
      .def(
          "find_limit",
          [](const FrequencyDomain& domain, double speed, double depth, double frequency) {
            const bool is_found = domain.find_limit(speed, depth, frequency);
            return std::tuple(is_found, depth, frequency);
          },
          py::arg("speed"), py::arg("depth"), py::arg("frequency"))
      .def("unstable_count", &FrequencyDomain::unstable_count, py::arg("speed"), py::arg("depth"),
           py::arg("highest"), py::call_guard<py::gil_scoped_release>());
  py::class_<FrequencyChart>(m, "FrequencyChart")
      .def(py::init([](const FrequencyDomain& domain, const Axis& speeds, const Axis& depths,
                       double centre, int frequency_cells, int threads) {
             return FrequencyChart(domain, axis_of(speeds), axis_of(depths), centre,
                                   frequency_cells, threads);
           }),
           py::arg("domain"), py::arg("speeds"), py::arg("depths"), py::arg("centre"),
           py::arg("frequency_cells"), py::arg("threads"))
      .def(
          "begin",
          [](FrequencyChart& chart, const Callback& progress) {
            Progress asked = progress_of(progress);
            const py::gil_scoped_release unlocked;
            chart.begin(asked);
          },
          py::arg("progress"))
      .def(
          "halve",
          [](FrequencyChart& chart, const Callback& progress) {
            Progress asked = progress_of(progress);
            const py::gil_scoped_release unlocked;
            chart.halve(asked);
          },
          py::arg("progress"))
      .def("curves", &FrequencyChart::curves)
      .def_property_readonly(
          "evaluations",
          [](const FrequencyChart& chart) { return chart.mdbm().evaluations().back(); })
      .def_property_readonly(
          "efficiency", [](const FrequencyChart& chart) { return efficiency(chart.mdbm(), 1); });
  m.def(
      "zeroth_order",
      [](const Milling& milling, const SharedReceptance& receptance, double frequency) {
        check(milling);
        std::vector<std::tuple<double, double>> result;
        for (const ZerothOrder& limit : zeroth_order(milling, receptance.of, frequency))
          result.emplace_back(limit.depth, limit.phase);
        return result;
      },
      py::arg("milling"), py::arg("receptance"), py::arg("frequency"));
  m.def(
      "zeroth_order_lobes",
      [](const Milling& milling, const SharedReceptance& receptance, const Axis& speeds,
         const Axis& depths, double lowest, double highest, int count) {
        return zeroth_order_lobes(milling, receptance.of, axis_of(speeds), axis_of(depths), lowest,
                                  highest, count);
      },
      py::arg("milling"), py::arg("receptance"), py::arg("speeds"), py::arg("depths"),
      py::arg("lowest"), py::arg("highest"), py::arg("count"));
}

}  // namespace evenload
