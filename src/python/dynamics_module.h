// Milling dynamics for Python.
#pragma once

#include <pybind11/pybind11.h>

#include "dynamics/frf.h"

namespace evenload {

// A receptance as an object of its own: pybind11 would take the function for one of Python's.
struct SharedReceptance {
  Receptance of;
};

// Adds the module `dynamics`, in kg, m, s, N and rad: modes and milling, multipliers, charts,
// bisection, frequency response, surfaces, orbits, beams. evenload.dynamics is made from it.
void bind_dynamics(pybind11::module_& module);

// Its parts.
void bind_bisection(pybind11::module_& module);
void bind_frequency(pybind11::module_& module);
void bind_motion(pybind11::module_& module);

}  // namespace evenload
