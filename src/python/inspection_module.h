// Inspection of measured points for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace evenload {

// Adds the module `inspection`, in mm and rad; evenload.inspection is made from it.
void bind_inspection(pybind11::module_& module);

}  // namespace evenload
