// Milling dynamics for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <tuple>

#include "dynamics/frf.h"
#include "dynamics/mdbm.h"

namespace evenload {

// A receptance as an object of its own: pybind11 would take the function for one of Python's.
struct SharedReceptance {
  Receptance of;
};

// Lowest, highest and the cells of the first grid between them.
using Axis = std::tuple<double, double, int>;

inline MdbmAxis axis_of(const Axis& axis) {
  return {std::get<0>(axis), std::get<1>(axis), std::get<2>(axis)};
}

// Adds the module `dynamics`, in kg, m, s, N and rad: modes and milling, multipliers, charts,
// bisection, frequency response, surfaces, orbits, beams. evenload.dynamics is made from it.
void bind_dynamics(pybind11::module_& module);

// Its parts.
void bind_bisection(pybind11::module_& module);
void bind_frequency(pybind11::module_& module);
void bind_motion(pybind11::module_& module);

}  // namespace evenload
