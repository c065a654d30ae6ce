// Multi-dimensional bisection of Python's functions.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <vector>

#include "dynamics/mdbm.h"
#include "dynamics/mdbm_curves.h"
#include "python/clearing_params.h"
#include "python/dynamics_module.h"

namespace py = pybind11;

namespace evenload {

namespace {

using Function = std::function<std::vector<double>(const std::vector<double>&)>;
using Callback = std::function<bool(double)>;

py::array_t<double> rows(const std::vector<double>& numbers, int columns) {
  py::array_t<double> result(
      {static_cast<py::ssize_t>(numbers.size()) / columns, static_cast<py::ssize_t>(columns)});
  std::copy(numbers.begin(), numbers.end(), result.mutable_data());
  return result;
}

// Lowest corners of the cells in numbers of the first grid's cells, and how wide they are.
std::vector<double> corners(const Mdbm& mdbm) {
  std::vector<double> result;
  for (const Mdbm::Index& cell : mdbm.cells())
    for (int a = 0; a < mdbm.axes(); ++a) result.push_back(mdbm.place(cell, a));
  return result;
}

py::dict found(const Mdbm& mdbm, double dimension) {
  py::dict result;
  py::list lines;
  if (mdbm.problem().equations == mdbm.axes() - 1)
    for (const std::vector<double>& line : curves(mdbm)) lines.append(rows(line, mdbm.axes()));
  result["points"] = rows(mdbm.points(), mdbm.axes());
  result["cells"] = rows(corners(mdbm), mdbm.axes());
  result["components"] = mdbm.components();
  result["curves"] = lines;
  result["evaluations_by_level"] = mdbm.evaluations();
  result["brute_force"] = mdbm.brute_force();
  result["efficiency"] = efficiency(mdbm, dimension);
  return result;
}

}  // namespace

void bind_bisection(py::module_& m) {
  m.def(
      "mdbm",
      [](const Function& function, int equations, bool has_constraint,
         const std::vector<std::tuple<double, double, int>>& axes, int iterations, double dimension,
         const Callback& progress) {
        MdbmProblem problem;
        for (const auto& [low, high, cells] : axes) problem.axes.push_back({low, high, cells});
        problem.equations = equations;
        problem.has_constraint = has_constraint;
        const std::size_t count = static_cast<std::size_t>(equations) + (has_constraint ? 1 : 0);
        const std::size_t width = axes.size();
        problem.evaluate = [&function, count, width](const double* at, double* values) {
          const std::vector<double> result = function(std::vector<double>(at, at + width));
          if (result.size() != count)
            throw std::invalid_argument(
                "The function must give the same number of values everywhere.");
          std::copy(result.begin(), result.end(), values);
        };
        Mdbm mdbm(problem);
        double most = 0;
        for (int level = 0; level <= iterations; ++level) {
          // What is told never turns back, though a level looks at its cells in several rounds.
          Progress asked([&](double share) {
            most = std::max(most, (level + share) / (iterations + 1));
            return !progress || progress(most);
          });
          if (level == 0)
            mdbm.begin(asked);
          else
            mdbm.halve(asked);
        }
        return found(mdbm, dimension);
      },
      py::arg("function"), py::arg("equations"), py::arg("has_constraint"), py::arg("axes"),
      py::arg("iterations"), py::arg("dimension"), py::arg("progress"));
}

}  // namespace evenload
