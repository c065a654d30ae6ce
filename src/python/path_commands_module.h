// The commands of a toolpath for Python: path_commands.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_path_commands(pybind11::module_& m);

}  // namespace evenload
