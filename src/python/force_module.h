// Cutting force and machine time for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds ForceCoefficients, ForceModel, CuttingForce, MachineProfile, machine_time and
// programmed_time to the module.
void bind_force(pybind11::module_& module);

}  // namespace evenload
