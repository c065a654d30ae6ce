// Trochoidal clearing of slots for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

void bind_trochoid(pybind11::module_& m);

}  // namespace evenload
