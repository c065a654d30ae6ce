// What a path's user should know, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include "toolpath/finding.h"

namespace evenload {

// [(code, (x, y) or None, (numbers...)), ...], as evenload.findings takes them.
pybind11::list findings_for_python(const std::vector<Finding>& findings);

}  // namespace evenload
