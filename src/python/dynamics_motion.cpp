// Forced vibration, surfaces, orbits, turning and slender tools, for Python.
#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <complex>
#include <functional>
#include <tuple>
#include <vector>

#include "dynamics/beam.h"
#include "dynamics/exact_chip.h"
#include "dynamics/modal_fit.h"
#include "dynamics/orbit_branch.h"
#include "dynamics/surface.h"
#include "dynamics/turning.h"
#include "python/clearing_params.h"
#include "python/dynamics_module.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Callback = std::function<bool(double)>;

py::tuple tuple_of(const BranchPoint& point) {
  return py::make_tuple(point.depth, point.amplitude, point.multipliers, point.is_fold,
                        point.is_wanted);
}

void bind_surface(py::module_& m) {
  py::class_<Surface>(m, "Surface")
      .def(py::init([](const Milling& milling, const SharedReceptance& receptance, double speed,
                       double depth, double feed_per_tooth) {
             check(milling);
             return Surface(milling, receptance.of, speed, depth, feed_per_tooth);
           }),
           py::arg("milling"), py::arg("receptance"), py::arg("speed"), py::arg("depth"),
           py::arg("feed_per_tooth"))
      .def("figures",
           [](const Surface& surface) {
             const SurfaceFigures f = surface.figures();
             return std::tuple(f.location_error, f.least, f.most, f.roughness, f.waviness);
           })
      .def("location_error", &Surface::location_error, py::arg("z"))
      .def("offset", &Surface::offset, py::arg("z"), py::arg("x"));
  m.def(
      "location_errors",
      [](const Milling& milling, const SharedReceptance& receptance,
         const std::vector<double>& speeds, const std::vector<double>& depths,
         double feed_per_tooth, int threads, const Callback& progress) {
        check(milling);
        Progress asked = progress_of(progress);
        const py::gil_scoped_release unlocked;
        return location_errors(milling, receptance.of, speeds, depths, feed_per_tooth, threads,
                               asked);
      },
      py::arg("milling"), py::arg("receptance"), py::arg("speeds"), py::arg("depths"),
      py::arg("feed_per_tooth"), py::arg("threads"), py::arg("progress"));
}

// Chips by the exact path at the points of the velocity model's branch; those are left out at which
// none is found.
BranchPoint exact_point(const OrbitSolver& solver, Orbit orbit, const BranchPoint& before) {
  BranchPoint point = before;
  point.is_fold = false;
  if (!solve_exactly(solver, orbit)) {
    point.multipliers.clear();
    return point;
  }
  point.amplitude = orbit.amplitude();
  point.multipliers = solver.multipliers(orbit, 1e-6, 4);
  return point;
}

void bind_orbits(py::module_& m) {
  m.def(
      "forced_orbits",
      [](const Milling& milling, double speed, const std::vector<double>& depths,
         double feed_per_tooth, bool velocity, bool exact, const Callback& progress) {
        const EdgeForces forces(milling, speed, feed_per_tooth,
                                velocity ? ChipModel::kVelocity : ChipModel::kCircular);
        const OrbitSolver solver(forces);
        Progress asked = progress_of(progress);
        OrbitBranch branch;
        {
          const py::gil_scoped_release unlocked;
          branch = follow_branch(solver, depths, asked);
          if (exact)
            for (BranchPoint& point : branch.points)
              point = exact_point(solver, point.orbit, point);
        }
        py::list points, boundaries;
        for (const BranchPoint& point : branch.points)
          if (!point.multipliers.empty()) points.append(tuple_of(point));
        for (const BranchPoint& point : branch.boundaries)
          if (!exact) boundaries.append(tuple_of(point));
        return py::make_tuple(points, boundaries);
      },
      py::arg("milling"), py::arg("speed"), py::arg("depths"), py::arg("feed_per_tooth"),
      py::arg("velocity"), py::arg("exact"), py::arg("progress"));
  m.def(
      "thickness_deviation",
      [](const Milling& milling, double speed, double depth, double feed_per_tooth) {
        const EdgeForces forces(milling, speed, feed_per_tooth, ChipModel::kVelocity);
        const OrbitSolver solver(forces);
        Progress asked;
        const OrbitBranch branch = follow_branch(solver, {depth}, asked);
        for (const BranchPoint& point : branch.points)
          if (point.is_wanted) return thickness_deviation(solver, point.orbit);
        throw std::invalid_argument("No periodic motion was found at this depth.");
      },
      py::arg("milling"), py::arg("speed"), py::arg("depth"), py::arg("feed_per_tooth"));
}

void bind_turning(py::module_& m) {
  m.def("interrupted_turning_speeds", &interrupted_turning_speeds, py::arg("slot"),
        py::arg("frequency"), py::arg("damping_ratio"), py::arg("enter"), py::arg("exit"),
        py::arg("count"));
  m.def(
      "turning_limit",
      [](const Mode& mode, double cutting, double flank, double length, double diameter,
         double speed, int order) {
        const TurningLimit found = turning_limit({mode, cutting, flank, length, diameter}, speed,
                                                 static_cast<FlankOrder>(order));
        return std::tuple(found.width, found.frequency);
      },
      py::arg("mode"), py::arg("cutting"), py::arg("flank"), py::arg("length"), py::arg("diameter"),
      py::arg("speed"), py::arg("order"));
}

void bind_beams(py::module_& m) {
  py::class_<BeamSegment>(m, "BeamSegment")
      .def(py::init([](double length, double diameter, double youngs_modulus, double density,
                       double poisson_ratio, double loss_factor) {
             return BeamSegment{
                 length, diameter, {youngs_modulus, density, poisson_ratio, loss_factor}};
           }),
           py::arg("length"), py::arg("diameter"), py::arg("youngs_modulus"), py::arg("density"),
           py::arg("poisson_ratio"), py::arg("loss_factor"));
  m.def(
      "tip_receptances",
      [](const std::vector<BeamSegment>& segments, const std::vector<Eigen::Matrix2cd>& roots,
         const std::vector<double>& frequencies) {
        std::vector<std::complex<double>> result;
        for (std::size_t i = 0; i < frequencies.size(); ++i)
          result.push_back(tip_receptance(segments, roots.at(i), frequencies[i])(0, 0));
        return result;
      },
      py::arg("segments"), py::arg("roots"), py::arg("frequencies"));
  m.def("clamped_frequencies", &clamped_frequencies, py::arg("segments"), py::arg("highest"));
  m.def(
      "fit_modes",
      [](const std::vector<double>& frequencies, const std::vector<std::complex<double>>& values,
         int modes) {
        const ModalFit fit = fit_modes(frequencies, values, modes);
        std::vector<std::tuple<double, double, double>> found;
        for (const Mode& mode : fit.modes)
          found.emplace_back(mode.mass, mode.frequency, mode.damping_ratio);
        std::vector<std::complex<double>> drawn;
        for (const double frequency : frequencies) drawn.push_back(fit.at(frequency));
        return std::tuple(found, fit.error, drawn);
      },
      py::arg("frequencies"), py::arg("values"), py::arg("modes"));
}

}  // namespace

void bind_motion(py::module_& m) {
  bind_surface(m);
  bind_orbits(m);
  bind_turning(m);
  bind_beams(m);
}

}  // namespace evenload
