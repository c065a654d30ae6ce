// Milling dynamics for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds the module `dynamics`, in kg, m, s, N and rad: modes and milling, multipliers, charts,
// bisection, frequency response, surfaces, orbits, beams. evenload.dynamics is made from it.
void bind_dynamics(pybind11::module_& module);

// Its parts.
void bind_bisection(pybind11::module_& module);
void bind_frequency(pybind11::module_& module);

}  // namespace evenload
