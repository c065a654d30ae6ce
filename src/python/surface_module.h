// Binding of surface/: finishing paths.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_finishing(pybind11::module_& module);

}  // namespace evenload
