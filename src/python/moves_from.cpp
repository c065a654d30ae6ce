#include "python/moves_from.h"

#include <stdexcept>
#include <string>

namespace py = pybind11;

namespace evenload {
namespace {

Move move_from(const py::sequence& values, std::size_t number) {
  const int kind = values.size() == 8 ? values[0].cast<int>() : -1;
  if (kind < 0 || kind > 3)
    throw std::invalid_argument(
        "Move " + std::to_string(number) +
        " must be (kind, x, y, z, sweep, cx, cy, feed), kind 0 rapid, 1 link, 2 entry or 3 cut.");
  const auto at = [&values](std::size_t i) { return values[i].cast<double>(); };
  return {static_cast<MoveKind>(kind), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

}  // namespace

std::vector<Move> moves_from(const py::object& source) {
  if (py::isinstance<Toolpath>(source)) return source.cast<const Toolpath&>().moves;
  std::vector<Move> moves;
  for (const py::handle& item : py::cast<py::iterable>(source)) {
    if (!py::isinstance<py::sequence>(item))
      throw std::invalid_argument("Move " + std::to_string(moves.size()) + " is no sequence.");
    moves.push_back(move_from(py::cast<py::sequence>(item), moves.size()));
  }
  return moves;
}

}  // namespace evenload
