// The simulator for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds DexelStock and simulate to the module. Condition: Region, Toolpath and MachineProfile are
// bound.
void bind_simulate(pybind11::module_& module);

}  // namespace evenload
