// Bindings of the path's proof and of heights over the plane.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_proof(pybind11::module_& module);

}  // namespace evenload
