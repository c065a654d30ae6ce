// Moves from Python.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

// From a Toolpath, a GCodeProgram, or any sequence of (kind, x, y, z, sweep, cx, cy, feed) as
// Toolpath.moves gives them. Throws std::invalid_argument with the number of a move that is none.
std::vector<Move> moves_from(const pybind11::object& source);

}  // namespace evenload
