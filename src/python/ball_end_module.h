// Chips of ball-end tools for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds the module `ball_end`, in mm and rad; evenload.ball_end is made from it.
void bind_ball_end(pybind11::module_& module);

}  // namespace evenload
