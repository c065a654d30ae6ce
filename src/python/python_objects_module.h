// Which objects Python knows.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_python_objects(pybind11::module_& module);

}  // namespace evenload
