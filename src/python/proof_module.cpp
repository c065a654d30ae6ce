#include "python/proof_module.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "python/moves_from.h"
#include "simulate/path_proof.h"

namespace py = pybind11;

namespace evenload {
namespace {

// mm: level cuts nearer in height are at one level.
constexpr double kLevels = 1e-4;

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Triples = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

template <typename Array>
void check_triples(const Array& rows, const char* what) {
  if (rows.size() > 0 && (rows.ndim() != 2 || rows.shape(1) != 3))
    throw std::invalid_argument(std::string(what) + " must be rows of three.");
}

std::vector<Point3> points_from(const Rows& rows) {
  check_triples(rows, "Points");
  std::vector<Point3> points;
  if (rows.size() == 0) return points;
  const auto view = rows.unchecked<2>();
  points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    points.push_back({view(i, 0), view(i, 1), view(i, 2)});
  return points;
}

HeightMap map_from(const Rows& points, const Triples& rows) {
  check_triples(rows, "Triangles");
  std::vector<HeightMap::Triangle> triangles;
  if (rows.size() > 0) {
    const auto view = rows.unchecked<2>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
      triangles.push_back({view(i, 0), view(i, 1), view(i, 2)});
  }
  const std::vector<Point3> corners = points_from(points);
  const py::gil_scoped_release unlocked;  // from here on nothing of Python's is read
  return HeightMap(corners, triangles);
}

const char* name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::kGouge:
      return "gouge";
    case FaultKind::kRapid:
      return "rapid";
    case FaultKind::kPlunge:
      return "plunge";
  }
  return "unknown";
}

// The corners of a path's box, as (x, y, z), and the heights of its level cuts, the highest first;
// no corners for a path without moves.
py::tuple extent_of(const py::object& source) {
  const std::vector<Move> moves = moves_from(source);
  if (moves.empty()) return py::make_tuple(py::none(), py::none(), py::list());
  Point3 low{moves[0].x, moves[0].y, moves[0].z}, high = low;
  std::set<double, std::greater<>> levels;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Move& m = moves[i];
    const Bounds box = segment_of({moves[i - 1].x, moves[i - 1].y, moves[i - 1].z}, m).bounds();
    low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), std::min(low.z, m.z)};
    high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y), std::max(high.z, m.z)};
    if (m.kind != MoveKind::kRapid && m.z == moves[i - 1].z)
      levels.insert(kLevels * std::round(m.z / kLevels));
  }
  return py::make_tuple(py::make_tuple(low.x, low.y, low.z), py::make_tuple(high.x, high.y, high.z),
                        std::vector<double>(levels.begin(), levels.end()));
}

// mm from each of some points, n x 2, to the nearest of lines from `starts` to `ends`, m x 2.
py::array_t<double> distances(const Rows& points, const Rows& starts, const Rows& ends) {
  for (const Rows* rows : {&points, &starts, &ends})
    if (rows->ndim() != 2 || rows->shape(1) != 2)
      throw std::invalid_argument("Points must be rows of two.");
  if (starts.shape(0) != ends.shape(0))
    throw std::invalid_argument("Each line needs a start and an end.");
  const auto from = starts.unchecked<2>(), to = ends.unchecked<2>(), at = points.unchecked<2>();
  std::vector<Segment> lines;
  std::vector<Bounds> boxes;
  for (py::ssize_t i = 0; i < starts.shape(0); ++i) {
    lines.push_back(Segment::line({from(i, 0), from(i, 1)}, {to(i, 0), to(i, 1)}));
    boxes.push_back(lines.back().bounds());
  }
  const BoxTree tree(boxes);
  py::array_t<double> result(points.shape(0));
  auto view = result.mutable_unchecked<1>();
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    const Vec2 p{at(i, 0), at(i, 1)};
    double best = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    tree.nearest(p, best, nearest, [&](std::uint32_t item) {
      const double d = lines[item].distance_to(p);
      return d * d;
    });
    view(i) = std::sqrt(best);
  }
  return result;
}

// Kind, amount, (x, y, z), number of the move.
using FaultTuple = std::tuple<const char*, double, std::tuple<double, double, double>, std::size_t>;

std::vector<FaultTuple> faults_for_python(
    const py::object& path, double tool_diameter, double corner_radius, const Rows& bodies,
    const HeightMap& stock,
    const std::vector<std::tuple<py::object, double, double>>& earlier_paths, double gouge_limit,
    double rim) {
  const std::vector<Move> moves = moves_from(path);
  const std::vector<Point3> points = points_from(bodies);
  std::vector<EarlierPath> earlier;
  for (const auto& [source, diameter, corner] : earlier_paths)
    earlier.push_back({moves_from(source), {diameter, corner}});
  ProofLimits limits;
  limits.gouge = gouge_limit;
  limits.rim = rim;
  std::vector<Fault> faults;
  {
    const py::gil_scoped_release unlocked;
    faults = faults_of(moves, {tool_diameter, corner_radius}, points, stock, earlier, limits);
  }
  std::vector<FaultTuple> result;
  for (const Fault& f : faults)
    result.emplace_back(name_of(f.kind), f.amount, std::make_tuple(f.at.x, f.at.y, f.at.z), f.move);
  return result;
}

}  // namespace

void bind_proof(py::module_& module) {
  py::class_<HeightMap>(module, "HeightMap",
                        "The upper side of a body: points, n x 3 in mm, and triangles, their "
                        "numbers, m x 3.")
      .def(py::init(&map_from), py::arg("points"), py::arg("triangles"))
      .def(
          "top_at",
          [](const HeightMap& map, double x, double y) {
            return map.top_at({x, y});
          },
          py::arg("x"), py::arg("y"), "z of the upper side, -inf where there is none.")
      .def(
          "raster",
          [](const HeightMap& map, double x0, double y0, double x1, double y1, double step) {
            const std::vector<Point3> places = map.raster({{x0, y0}, {x1, y1}}, step);
            py::array_t<double> rows({static_cast<py::ssize_t>(places.size()), py::ssize_t{3}});
            auto view = rows.mutable_unchecked<2>();
            for (std::size_t i = 0; i < places.size(); ++i) {
              const auto row = static_cast<py::ssize_t>(i);
              view(row, 0) = places[i].x;
              view(row, 1) = places[i].y;
              view(row, 2) = places[i].z;
            }
            return rows;
          },
          py::arg("x0"), py::arg("y0"), py::arg("x1"), py::arg("y1"), py::arg("step"),
          "Places of the upper side on a raster between two corners, n x 3, mm.")
      .def(
          "highest_within",
          [](const HeightMap& map, const Region& region, double z, double inset,
             double spacing) -> std::optional<std::tuple<double, double, double>> {
            const auto found = map.highest_within(region, z, inset, spacing);
            if (!found) return std::nullopt;
            return std::make_tuple(found->x, found->y, found->z);
          },
          py::arg("region"), py::arg("z"), py::arg("inset"), py::arg("spacing"),
          "(x, y, z) within a region, `inset` mm off its border, where the body stands higher than "
          "z: the highest of places `spacing` mm apart; None without one.")
      .def_property_readonly("lowest", &HeightMap::lowest, "mm")
      .def_property_readonly("highest", &HeightMap::highest, "mm");

  module.def("distances", &distances, py::arg("points"), py::arg("starts"), py::arg("ends"),
             "mm from points, n x 2, to the nearest of lines between starts and ends, m x 2; inf "
             "without lines.");
  module.def("extent_of", &extent_of, py::arg("path"),
             "((x, y, z) of the lower corner of a path's box, that of the upper one, heights of "
             "its level cuts from the highest) in mm. None, None, [] for a "
             "path without moves.");
  const ProofLimits defaults;
  module.def(
      "faults_of", &faults_for_python, py::arg("path"), py::kw_only(), py::arg("tool_diameter"),
      py::arg("corner_radius") = 0.0, py::arg("bodies"), py::arg("stock"),
      py::arg("earlier") = std::vector<std::tuple<py::object, double, double>>(),
      py::arg("gouge_limit") = defaults.gouge, py::arg("rim") = defaults.rim,
      "[(kind, amount in mm, (x, y, z), number of the move), ...]: where a path, a "
      "GCodeProgram or moves, cuts into bodies, points n x 3 of their surface, and comes "
      "down into stock, a HeightMap. Kinds are 'gouge', 'rapid' and 'plunge'. earlier: "
      "[(path, diameter, corner radius), ...] in mm. Less than gouge_limit mm into bodies is "
      "no gouge; rim: mm of the tool's rim that may touch what stands.");
}

}  // namespace evenload
