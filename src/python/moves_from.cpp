#include "python/moves_from.h"

#include <stdexcept>
#include <string>

#include "toolpath/gcode.h"

namespace py = pybind11;

namespace evenload {
namespace {

Move move_from(const py::sequence& values, std::size_t number) {
  try {
    const auto at = [&values](std::size_t i) { return values[i].cast<double>(); };
    const double kind = values.size() == 8 ? at(0) : -1;  // an array has it as a float
    if (kind == 0 || kind == 1 || kind == 2 || kind == 3) {
      const auto known = static_cast<MoveKind>(static_cast<int>(kind));
      return {known, at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }
  } catch (const py::cast_error&) {  // no numbers: refused below
  }
  throw std::invalid_argument(
      "Move " + std::to_string(number) +
      " must be (kind, x, y, z, sweep, cx, cy, feed), kind 0 rapid, 1 link, 2 entry or 3 cut.");
}

std::vector<Move> moves_of(const GCodeProgram& program) {
  if (!program.has_start) return {};
  std::vector<Move> moves{
      {MoveKind::kRapid, program.start_x, program.start_y, program.start_z, 0, 0, 0, 0}};
  moves.insert(moves.end(), program.moves.begin(), program.moves.end());
  return moves;
}

}  // namespace

std::vector<Move> moves_from(const py::object& source) {
  if (py::isinstance<Toolpath>(source)) return source.cast<const Toolpath&>().moves;
  if (py::isinstance<GCodeProgram>(source)) return moves_of(source.cast<const GCodeProgram&>());
  std::vector<Move> moves;
  for (const py::handle& item : py::cast<py::iterable>(source)) {
    if (!py::isinstance<py::sequence>(item))
      throw std::invalid_argument("Move " + std::to_string(moves.size()) + " is no sequence.");
    moves.push_back(move_from(py::cast<py::sequence>(item), moves.size()));
  }
  return moves;
}

}  // namespace evenload
