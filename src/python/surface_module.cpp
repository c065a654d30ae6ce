#include "python/surface_module.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "python/clearing_params.h"
#include "surface/drop.h"
#include "surface/earlier.h"
#include "surface/fewest_lines.h"
#include "surface/finish.h"
#include "surface/ground.h"
#include "surface/refeed.h"

namespace py = pybind11;

namespace evenload {

namespace {

using FinishCallback = std::function<bool(double)>;
using MeshNumbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using MeshCounts = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;
using MeshFlags = py::array_t<bool, py::array::c_style | py::array::forcecast>;

constexpr py::ssize_t kContactFigures = 9;
constexpr py::ssize_t kSegmentColumns = 4, kPlaceColumns = 5, kPieceColumns = 3;

void demand_columns(const py::array& rows, py::ssize_t columns, const char* sentence) {
  if (rows.ndim() != 2 || rows.shape(1) != columns) throw std::invalid_argument(sentence);
}

FacetMesh mesh_from(const MeshNumbers& points, const MeshCounts& triangles,
                    const MeshFlags& picked) {
  demand_columns(points, 3, "Points are rows of x, y, z.");
  demand_columns(triangles, 3, "Triangles are rows of the numbers of three points.");
  if (picked.ndim() != 1) throw std::invalid_argument("What is picked is a list.");
  const auto p = points.unchecked<2>();
  const auto t = triangles.unchecked<2>();
  const auto is = picked.unchecked<1>();
  std::vector<SpacePoint> corners;
  for (py::ssize_t i = 0; i < p.shape(0); ++i) corners.push_back({p(i, 0), p(i, 1), p(i, 2)});
  std::vector<FacetMesh::Triangle> numbers;
  for (py::ssize_t i = 0; i < t.shape(0); ++i) numbers.push_back({t(i, 0), t(i, 1), t(i, 2)});
  std::vector<bool> flags;
  for (py::ssize_t i = 0; i < is.shape(0); ++i) flags.push_back(is(i));
  const py::gil_scoped_release unlocked;
  return FacetMesh(corners, numbers, flags);
}

py::array_t<double> contacts_for_python(const FacetMesh& mesh, double tool_diameter,
                                        double corner_radius, const MeshNumbers& places,
                                        double floor, int threads, const FinishCallback& callback) {
  demand_columns(places, 2, "Places are rows of x, y.");
  const Cutter cutter{0.5 * tool_diameter, corner_radius};
  if (!(cutter.radius > 0 && cutter.corner >= 0 && cutter.corner <= cutter.radius))
    throw std::invalid_argument(
        "The tool's diameter must be positive, its corner's radius between 0 and half of it.");
  const auto at = places.unchecked<2>();
  std::vector<Vec2> wanted;
  for (py::ssize_t i = 0; i < at.shape(0); ++i) wanted.push_back({at(i, 0), at(i, 1)});
  Progress asked = progress_of(callback);
  std::vector<ToolContact> found;
  {
    const py::gil_scoped_release unlocked;
    found = drop_all(mesh, cutter, wanted, floor, threads, asked);
  }
  py::array_t<double> result({static_cast<py::ssize_t>(found.size()), kContactFigures});
  double* into = result.mutable_data();
  for (const ToolContact& c : found)
    for (const double figure : {c.z, c.touches ? 1.0 : 0.0, c.is_within ? 1.0 : 0.0, c.point.x,
                                c.point.y, c.point.z, c.normal.x, c.normal.y, c.normal.z})
      *into++ = figure;
  return result;
}

using GuidePoints = std::vector<std::vector<std::array<double, 2>>>;

FinishParams finish_params(Keywords& keywords, double& deflection, const FacetMesh*& fixtures,
                           FinishCallback& callback) {
  FinishParams params;
  double diameter = 0;
  keywords.required("tool_diameter", diameter);
  params.cutter.radius = 0.5 * diameter;
  keywords.required("corner_radius", params.cutter.corner);
  keywords.choice("pattern",
                  {{"zig-zag", Pattern::kZigZag},
                   {"one way", Pattern::kOneWay},
                   {"contours inwards", Pattern::kContoursInwards},
                   {"contours outwards", Pattern::kContoursOutwards},
                   {"spiral inwards", Pattern::kSpiralInwards},
                   {"spiral outwards", Pattern::kSpiralOutwards},
                   {"between guides", Pattern::kBetweenGuides},
                   {"one way between guides", Pattern::kOneWayBetweenGuides}},
                  params.pattern);
  keywords.optional("angle", params.angle);
  keywords.required("stepover", params.stepover);
  keywords.optional("cusp_height", params.cusp_height);
  keywords.choice("boundary", {{"tool contact", true}, {"tool centre", false}}, params.by_contact);
  keywords.optional("allowance", params.allowance);
  keywords.optional("extension", params.extension);
  keywords.optional("lead_radius", params.lead_radius);
  GuidePoints guides;
  keywords.optional("guides", guides);
  for (const auto& guide : guides) {
    params.guides.emplace_back();
    for (const auto& [x, y] : guide) params.guides.back().push_back({x, y});
  }
  keywords.optional("fixtures", fixtures);
  keywords.optional("fixture_clearance", params.fixture_clearance);
  keywords.required("tolerance", params.tolerance);
  keywords.required("deflection", deflection);
  keywords.required("floor", params.floor);
  keywords.required("top", params.top);
  keywords.required("safe_height", params.safe_height);
  keywords.required("clearance_height", params.clearance_height);
  keywords.required("feed", params.feed);
  keywords.required("plunge_feed", params.plunge_feed);
  keywords.required("rapid_feed", params.rapid_feed);
  keywords.choice("cut_mode", {{"climb", true}, {"conventional", false}}, params.is_climb);
  keywords.optional("arcs", params.arcs);
  keywords.optional("threads", params.threads);
  keywords.optional("progress", callback);
  keywords.refuse_others();
  return params;
}

Finish finish_for_python(const FacetMesh& mesh, const py::kwargs& arguments) {
  Keywords keywords("finish", arguments);
  double deflection = 0;
  const FacetMesh* fixtures = nullptr;
  FinishCallback callback;
  const FinishParams params = finish_params(keywords, deflection, fixtures, callback);
  Progress watch = progress_of(callback);
  const py::gil_scoped_release unlocked;
  return finish_surface(mesh, params, deflection, watch, fixtures);
}

py::array_t<double> earlier_for_python(const MeshNumbers& segments, const MeshNumbers& places,
                                       double reach, int threads, const FinishCallback& callback) {
  demand_columns(segments, kSegmentColumns, "Segments are rows of x, y and x, y.");
  demand_columns(places, kPlaceColumns,
                 "Places are rows of x, y, the way's x, y and the number of a segment.");
  if (!(reach > 0)) throw std::invalid_argument("The reach must be positive.");
  const auto s = segments.unchecked<2>();
  const auto p = places.unchecked<2>();
  std::vector<PlanSegment> cut;
  for (py::ssize_t i = 0; i < s.shape(0); ++i)
    cut.push_back({{s(i, 0), s(i, 1)}, {s(i, 2), s(i, 3)}});
  std::vector<PlaceOnPath> wanted;
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    wanted.push_back({{p(i, 0), p(i, 1)}, {p(i, 2), p(i, 3)}, static_cast<std::size_t>(p(i, 4))});
  Progress asked = progress_of(callback);
  std::vector<EarlierBeside> found;
  {
    const py::gil_scoped_release unlocked;
    found = earlier_beside(cut, wanted, reach, threads, asked);
  }
  py::array_t<double> result({static_cast<py::ssize_t>(found.size()), py::ssize_t{2}});
  double* into = result.mutable_data();
  for (const EarlierBeside& each : found) {
    *into++ = each.left;
    *into++ = each.right;
  }
  return result;
}

// The places along a line at which a pass is sampled, s and z.
py::array_t<double> samples_for_python(const FacetMesh& mesh, double tool_diameter,
                                       double corner_radius, std::array<double, 2> from,
                                       std::array<double, 2> to, double floor, double tolerance) {
  const Vec2 start{from[0], from[1]}, way = Vec2{to[0], to[1]} - start;
  if (!(norm(way) > 0 && tolerance > 0))
    throw std::invalid_argument("A line to be sampled has a length, and a positive tolerance.");
  const Ground ground{&mesh, {0.5 * tool_diameter, corner_radius}, 0, floor};
  std::vector<DropSample> samples;
  {
    const py::gil_scoped_release unlocked;
    samples = samples_along(ground, {start, normalized(way)}, 0, norm(way), tolerance);
  }
  py::array_t<double> result({static_cast<py::ssize_t>(samples.size()), py::ssize_t{2}});
  double* into = result.mutable_data();
  for (const DropSample& sample : samples) {
    *into++ = sample.s;
    *into++ = sample.z;
  }
  return result;
}

Toolpath refed_for_python(const Toolpath& path, const MeshNumbers& pieces, double plunge_feed) {
  demand_columns(pieces, kPieceColumns, "Pieces are rows of a move, the share at its end, a feed.");
  const auto p = pieces.unchecked<2>();
  std::vector<FedPiece> wanted;
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    wanted.push_back({static_cast<std::size_t>(p(i, 0)), p(i, 1), p(i, 2)});
  const py::gil_scoped_release unlocked;
  return with_feeds(path, wanted, plunge_feed);
}

std::vector<std::array<double, 2>> lines_for_python(const std::vector<std::array<double, 2>>& curve,
                                                    double below, double above) {
  std::vector<Vec2> points;
  for (const auto& [s, z] : curve) {
    if (!points.empty() && !(s > points.back().x))
      throw std::invalid_argument("The curve must run forwards.");
    points.push_back({s, z});
  }
  if (points.size() < 2 || !(below > 0 && above > 0))
    throw std::invalid_argument("Lines need a curve of two points and positive bounds.");
  std::vector<std::array<double, 2>> lines;
  for (const Vec2 p : fewest_lines(points, below, above)) lines.push_back({p.x, p.y});
  return lines;
}

}  // namespace

void bind_finishing(py::module_& module) {
  py::module_ m = module.def_submodule("surface", "Finishing paths over triangles, in mm, mm/min.");
  py::class_<FacetMesh>(m, "FacetMesh", "A part as triangles, some of which are picked.")
      .def(py::init(&mesh_from), py::arg("points"), py::arg("triangles"), py::arg("picked"))
      .def("__len__", [](const FacetMesh& mesh) { return mesh.facets().size(); });
  py::class_<Finish>(m, "Finish")
      .def_readonly("toolpath", &Finish::toolpath)
      .def_readonly("least_stepover", &Finish::least_stepover, "mm")
      .def_readonly("largest_stepover", &Finish::largest_stepover, "mm");
  m.def("contacts", &contacts_for_python, py::arg("mesh"), py::arg("tool_diameter"),
        py::arg("corner_radius"), py::arg("places"), py::arg("floor"), py::arg("threads") = 0,
        py::arg("progress") = py::none(),
        "An array of 9 columns: the tip's z, whether the tool touches, whether it does so within "
        "what is picked, the contact's x, y, z and its normal.");
  m.def("finish", &finish_for_python, py::arg("mesh"),
        "The Finish of what is picked. tool_diameter, corner_radius, stepover, tolerance, "
        "deflection of the triangles, floor, top, safe_height, clearance_height in mm; feed, "
        "plunge_feed, rapid_feed in mm/min; pattern: zig-zag, one way, contours inwards, contours "
        "outwards, spiral inwards, spiral outwards, or between guides or one way between guides, "
        "with `guides`, two lists of (x, y); angle in rad; cusp_height in mm, 0: constant "
        "stepover; boundary: tool contact or "
        "tool centre; allowance in mm; extension beyond the faces in mm; lead_radius in mm, 0: "
        "straight down and up; fixtures, a FacetMesh that the tool keeps off by fixture_clearance "
        "in mm, "
        "or None; cut_mode; arcs, False: lines only; "
        "threads; progress: callable(share) -> whether to go on.");
  m.def("samples", &samples_for_python, py::arg("mesh"), py::arg("tool_diameter"),
        py::arg("corner_radius"), py::arg("start"), py::arg("end"), py::arg("floor"),
        py::arg("tolerance"),
        "An array of mm along a line and of the tip's z: where a pass over it is sampled.");
  m.def("earlier_beside", &earlier_for_python, py::arg("segments"), py::arg("places"),
        py::arg("reach"), py::arg("threads") = 0, py::arg("progress") = py::none(),
        "An array of mm in plan to where earlier segments have cut, to the left and to the right "
        "of the feed, infinite where none has; segments: rows of x, y, x, y; places: rows of x, y, "
        "the feed's way x, y, and the number of their segment.");
  m.def(
      "with_feeds", &refed_for_python, py::arg("toolpath"), py::arg("pieces"),
      py::arg("plunge_feed"),
      "The Toolpath at other feeds: rows of a move's number, the share of it at which a piece "
      "ends, the piece's feed in mm/min, which downwards is no more than the plunge feed allows.");
  m.def("fewest_lines", &lines_for_python, py::arg("curve"), py::arg("below"), py::arg("above"),
        "The fewest lines along (s, z) that leave it by no more than below and above, in mm.");
}

}  // namespace evenload
