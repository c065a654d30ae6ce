// The G-code reader for Python: read_gcode, GCodeProgram and GCodeError.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_gcode(pybind11::module_& m);

}  // namespace evenload
