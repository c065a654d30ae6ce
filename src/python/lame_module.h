// Lamé spirals for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds clear_with_lame_spiral and LameToolpath to the module.
void bind_lame(pybind11::module_& module);

}  // namespace evenload
