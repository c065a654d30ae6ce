#include "python/dynamics_module.h"

#include <pybind11/complex.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "dynamics/chart.h"
#include "dynamics/stability.h"
#include "python/clearing_params.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Callback = std::function<bool(double)>;

void bind_milling(py::module_& m) {
  py::class_<Mode>(m, "Mode", "kg, rad/s, ratio, rad.")
      .def(py::init([](double mass, double frequency, double damping_ratio, double direction) {
             return Mode{mass, frequency, damping_ratio, direction};
           }),
           py::arg("mass"), py::arg("frequency"), py::arg("damping_ratio"), py::arg("direction"));
  m.def(
      "check_modes", [](const std::vector<Mode>& modes) { check_modes(modes); }, py::arg("modes"));
  py::class_<Milling>(m, "Milling", "kg, m, s, N and rad; fields as in dynamics/milling.h.")
      .def(py::init<>())
      .def_readwrite("modes", &Milling::modes)
      .def_readwrite("teeth", &Milling::teeth)
      .def_readwrite("tangential", &Milling::tangential)
      .def_readwrite("normal", &Milling::normal)
      .def_readwrite("climb", &Milling::climb)
      .def_readwrite("engagement", &Milling::engagement)
      .def_readwrite("radius", &Milling::radius)
      .def_readwrite("lead", &Milling::lead)
      .def_readwrite("tooth_angles", &Milling::tooth_angles)
      .def_readwrite("feed_direction", &Milling::feed_direction)
      .def_readwrite("process_damping", &Milling::process_damping)
      .def_readwrite("flank_friction", &Milling::flank_friction)
      .def("check", [](const Milling& milling) { check(milling); });
}

void bind_stability(py::module_& m) {
  m.def(
      "multipliers",
      [](const Milling& milling, double speed, double depth, double accuracy, int wanted) {
        const py::gil_scoped_release unlocked;
        return multipliers(milling, speed, depth, accuracy, wanted);
      },
      py::arg("milling"), py::arg("speed"), py::arg("depth"), py::arg("accuracy"),
      py::arg("wanted"));
  m.def(
      "spectral_radii",
      [](const Milling& milling, const std::vector<double>& speeds,
         const std::vector<double>& depths, double accuracy, int threads,
         const Callback& progress) {
        Progress asked = progress_of(progress);
        const py::gil_scoped_release unlocked;
        return spectral_radii(milling, speeds, depths, accuracy, threads, asked);
      },
      py::arg("milling"), py::arg("speeds"), py::arg("depths"), py::arg("accuracy"),
      py::arg("threads"), py::arg("progress"));
  m.def(
      "critical_depth",
      [](const Milling& milling, double speed, double largest, double accuracy) {
        const py::gil_scoped_release unlocked;
        return critical_depth(milling, speed, largest, accuracy);
      },
      py::arg("milling"), py::arg("speed"), py::arg("largest"), py::arg("accuracy"));
  m.def(
      "strongest_vibration",
      [](const Milling& milling, double speed, double depth) {
        check(milling);
        check_speed_and_depth(speed, depth);
        const Vibration found = strongest_vibration(milling_system(milling, speed, depth));
        return std::tuple(found.multiplier, found.frequency,
                          static_cast<int>(kind_of(found.multiplier)));
      },
      py::arg("milling"), py::arg("speed"), py::arg("depth"));
}

void bind_chart(py::module_& m) {
  py::class_<StabilityChart>(m, "StabilityChart")
      .def(
          py::init([](const Milling& milling, const Axis& speeds, const Axis& depths, int threads) {
            return StabilityChart(milling, axis_of(speeds), axis_of(depths), threads);
          }),
          py::arg("milling"), py::arg("speeds"), py::arg("depths"), py::arg("threads"))
      .def(
          "begin",
          [](StabilityChart& chart, const Callback& progress, int every) {
            Progress asked = progress_of(progress);
            const py::gil_scoped_release unlocked;
            chart.begin(asked, every);
          },
          py::arg("progress"), py::arg("every") = 1)
      .def(
          "halve",
          [](StabilityChart& chart, const Callback& progress) {
            Progress asked = progress_of(progress);
            const py::gil_scoped_release unlocked;
            chart.halve(asked);
          },
          py::arg("progress"))
      .def(
          "curves",
          [](const StabilityChart& chart, const Callback& progress) {
            Progress asked = progress_of(progress);
            std::vector<StabilityChart::Curve> curves;
            {
              const py::gil_scoped_release unlocked;
              curves = chart.curves(asked);
            }
            py::list result;
            for (const StabilityChart::Curve& c : curves) {
              std::vector<int> kinds;
              for (const BoundaryKind kind : c.kinds) kinds.push_back(static_cast<int>(kind));
              result.append(py::make_tuple(c.speeds, c.depths, kinds, c.chatter_frequencies));
            }
            return result;
          },
          py::arg("progress"))
      .def_property_readonly(
          "evaluations",
          [](const StabilityChart& chart) { return chart.mdbm().evaluations().back(); })
      .def_property_readonly(
          "efficiency", [](const StabilityChart& chart) { return efficiency(chart.mdbm(), 1); })
      .def_property_readonly(
          "brute_force", [](const StabilityChart& chart) { return chart.mdbm().brute_force(); });
}

}  // namespace

void bind_dynamics(py::module_& module) {
  py::module_ m = module.def_submodule("dynamics", "Vibration of milling, in kg, m, s, N and rad.");
  py::register_exception<Cancelled>(m, "Cancelled");
  bind_milling(m);
  bind_stability(m);
  bind_chart(m);
  bind_bisection(m);
  bind_frequency(m);
  bind_motion(m);
}

}  // namespace evenload
