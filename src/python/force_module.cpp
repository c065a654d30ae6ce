#include "python/force_module.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "cutting/force.h"
#include "python/moves_from.h"
#include "toolpath/machine_time.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Axes = std::array<double, 3>;
using ArcTuple = std::tuple<double, double, double>;

MachineProfile profile_from(const std::string& name, const Axes& max_feed, const Axes& max_accel,
                            double max_jerk, double centripetal_accel, double junction_deviation,
                            double block_rate, int look_ahead, double rapid_feed) {
  MachineProfile profile;
  profile.name = name;
  for (int axis = 0; axis < 3; ++axis) {
    profile.max_feed[axis] = max_feed[axis];
    profile.max_accel[axis] = max_accel[axis];
  }
  profile.max_jerk = max_jerk;
  profile.centripetal_accel = centripetal_accel;
  profile.junction_deviation = junction_deviation;
  profile.block_rate = block_rate;
  profile.look_ahead = look_ahead;
  profile.rapid_feed = rapid_feed;
  return profile;
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// Peaks of the force and of the torque at every sample of a simulation's record.
std::tuple<Doubles, Doubles> peaks(const ForceModel& model, const Doubles& arcs,
                                   const Indices& first_arc, const Doubles& feed_per_tooth) {
  if (arcs.ndim() != 2 || arcs.shape(1) != 3 || first_arc.ndim() != 1 ||
      feed_per_tooth.ndim() != 1 || first_arc.size() != feed_per_tooth.size() + 1)
    throw std::invalid_argument(
        "arcs must be rows of (low, high, depth), with one feed_per_tooth for each sample and one "
        "more first_arc.");
  const py::ssize_t size = feed_per_tooth.size();
  const auto row = arcs.unchecked<2>();
  const auto first = first_arc.unchecked<1>();
  const auto feed = feed_per_tooth.unchecked<1>();
  for (py::ssize_t i = 0; i < size; ++i)
    if (first(i) < 0 || first(i + 1) < first(i) || first(i + 1) > arcs.shape(0))
      throw std::invalid_argument("first_arc must rise from 0 to the number of arcs.");
  Doubles force(size), torque(size);
  auto force_at = force.mutable_unchecked<1>();
  auto torque_at = torque.mutable_unchecked<1>();
  {
    const py::gil_scoped_release unlocked;
    std::vector<EngagedArc> engaged;
    for (py::ssize_t i = 0; i < size; ++i) {
      engaged.clear();
      for (auto k = static_cast<py::ssize_t>(first(i)); k < first(i + 1); ++k)
        engaged.push_back({row(k, 0), row(k, 1), row(k, 2)});
      const CuttingForce found = model.force(engaged.data(), engaged.size(), feed(i), 0.0);
      force_at(i) = found.peak_xy;
      torque_at(i) = found.peak_torque;
    }
  }
  return {force, torque};
}

}  // namespace

void bind_force(py::module_& m) {
  py::class_<ForceCoefficients>(
      m, "ForceCoefficients", "Tangential and radial: of the chip in N/mm^2, of the edge in N/mm.")
      .def(py::init([](double ktc, double krc, double kte, double kre) {
             return ForceCoefficients{ktc, krc, kte, kre};
           }),
           py::arg("ktc"), py::arg("krc"), py::arg("kte") = 0.0, py::arg("kre") = 0.0)
      .def_readonly("ktc", &ForceCoefficients::ktc)
      .def_readonly("krc", &ForceCoefficients::krc)
      .def_readonly("kte", &ForceCoefficients::kte)
      .def_readonly("kre", &ForceCoefficients::kre);

  py::class_<CuttingForce>(m, "CuttingForce", "Over one revolution, on the workpiece.")
      .def_readonly("peak_x", &CuttingForce::peak_x, "N, largest absolute value")
      .def_readonly("peak_y", &CuttingForce::peak_y, "N, largest absolute value")
      .def_readonly("peak_xy", &CuttingForce::peak_xy, "N")
      .def_readonly("mean_x", &CuttingForce::mean_x, "N, with its sign")
      .def_readonly("mean_y", &CuttingForce::mean_y, "N, with its sign")
      .def_readonly("mean_xy", &CuttingForce::mean_xy, "N")
      .def_readonly("peak_torque", &CuttingForce::peak_torque, "N m")
      .def_readonly("mean_torque", &CuttingForce::mean_torque, "N m")
      .def_readonly("mean_power", &CuttingForce::mean_power, "W");

  py::class_<ForceModel>(m, "ForceModel", "The cutting force of an end mill.")
      .def(py::init<const ForceCoefficients&, double, int, double>(), py::arg("coefficients"),
           py::arg("tool_radius"), py::arg("teeth"), py::arg("helix_angle"))
      .def(
          "force",
          [](const ForceModel& model, const std::vector<ArcTuple>& arcs, double feed_per_tooth,
             double spindle_speed, double feed_angle) {
            std::vector<EngagedArc> engaged;
            for (const auto& [low, high, depth] : arcs) engaged.push_back({low, high, depth});
            return model.force(engaged.data(), engaged.size(), feed_per_tooth, spindle_speed,
                               feed_angle);
          },
          py::arg("arcs"), py::arg("feed_per_tooth"), py::arg("spindle_speed"),
          py::arg("feed_angle") = 0.0,
          "The force while the tool touches arcs of (low, high, depth), rad and mm.")
      .def("peaks", &peaks, py::arg("arcs"), py::arg("first_arc"), py::arg("feed_per_tooth"),
           "(N, N m) at each sample, which touches arcs[first_arc[i]:first_arc[i + 1]].");

  py::class_<MachineProfile>(m, "MachineProfile", "What limits a machine's speed.")
      .def(py::init(&profile_from), py::kw_only(), py::arg("name") = "", py::arg("max_feed"),
           py::arg("max_accel"), py::arg("max_jerk") = 0.0, py::arg("centripetal_accel") = 0.0,
           py::arg("junction_deviation") = 0.0, py::arg("block_rate") = 0.0,
           py::arg("look_ahead") = 0, py::arg("rapid_feed"))
      .def_readonly("name", &MachineProfile::name);

  m.def(
      "machine_time",
      [](const py::object& source, const MachineProfile& profile) {
        const std::vector<Move> moves = moves_from(source);
        std::vector<std::tuple<double, double, double, double, double>> result;
        result.reserve(moves.size());
        for (const MoveTime& t : machine_time(moves, profile))
          result.emplace_back(t.start, t.duration, t.entry, t.peak, t.exit);
        return result;
      },
      py::arg("moves"), py::arg("profile"),
      "(start, duration, entry, peak, exit) of every move, s and mm/s.");
  m.def(
      "programmed_time",
      [](const py::object& source, double rapid_feed) {
        return programmed_time(moves_from(source), rapid_feed);
      },
      py::arg("moves"), py::arg("rapid_feed"), "s of all moves at their programmed feeds.");
}

}  // namespace evenload
