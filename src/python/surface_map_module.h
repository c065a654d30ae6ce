// The module's binding of surface_map.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_surface_map(pybind11::module_& module);

}  // namespace evenload
