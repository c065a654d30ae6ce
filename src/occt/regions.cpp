#include "occt/regions.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gp_Pln.hxx>
#include <limits>
#include <optional>

#include "occt/brep_text.h"
#include "occt/edge_curve.h"
#include "occt/join.h"
#include "occt/shape_error.h"

namespace evenload {
namespace {

// Heights that differ by less than this, in mm, are one: less than any machine holds, more than CAD
// programs are off.
constexpr double kLevel = 1e-3;
// How finely curves are looked at to see which lies within which, in mm: only nearly touching ones
// could fool it.
constexpr double kNestingTolerance = 0.01;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<TopoDS_Shape> members_of(const TopoDS_Shape& shape) {
  if (shape.ShapeType() != TopAbs_COMPOUND) return {shape};
  std::vector<TopoDS_Shape> members;
  for (TopoDS_Iterator child(shape); child.More(); child.Next()) members.push_back(child.Value());
  return members;
}

std::string with_number(const char* format, double value) {
  char text[200];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// The angle between the face and the XY plane, in degrees.
double tilt_of(const TopoDS_Face& face, std::size_t member) {
  const BRepAdaptor_Surface surface(face, false);
  std::optional<gp_Pln> plane;
  if (surface.GetType() == GeomAbs_Plane) {
    plane = surface.Plane();
  } else {
    const GeomLib_IsPlanarSurface test(BRep_Tool::Surface(face), kLevel);
    if (test.IsPlanar()) plane = test.Plan();
  }
  if (!plane) {
    throw ShapeError(ShapeFault::kNotPlanar, member,
                     "The face is not flat: pick a flat face that is parallel to XY.");
  }
  const gp_Dir normal = plane->Axis().Direction();
  return std::atan2(std::hypot(normal.X(), normal.Y()), std::abs(normal.Z())) * 180 / kPi;
}

LevelRegion region_of_face(const TopoDS_Face& face, double tolerance, std::size_t member) {
  const double tilt = tilt_of(face, member);

  // An edge that the face has on both sides, a slit, bounds nothing.
  TopTools_MapOfShape once, twice;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    if (!once.Add(edge.Current())) twice.Add(edge.Current());
  }
  std::vector<Loop> loops;
  double low_z = kInfinity, high_z = -kInfinity;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
    std::vector<Piece> pieces;
    for (TopExp_Explorer explorer(wire.Current(), TopAbs_EDGE); explorer.More(); explorer.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(explorer.Current());
      const bool inner =
          edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL;
      if (inner || twice.Contains(edge) || BRep_Tool::Degenerated(edge)) continue;
      const EdgeCurve read = edge_curve(edge, tolerance, member);
      low_z = std::min(low_z, read.low_z);
      high_z = std::max(high_z, read.high_z);
      pieces.push_back({read.curve, 0, read.end_error, member});
    }
    if (high_z - low_z > kLevel) {
      throw ShapeError(
          ShapeFault::kTilted, member,
          with_number("The face is tilted by %.3g degrees: pick one that is parallel to XY.",
                      tilt));
    }
    const std::vector<Loop> closed = join(pieces);
    loops.insert(loops.end(), closed.begin(), closed.end());
  }
  if (loops.empty())
    throw ShapeError(ShapeFault::kNotFinite, member,
                     "The face has no boundary: pick a finite one.");

  const auto outer = std::max_element(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(a.curve.signed_area()) < std::abs(b.curve.signed_area());
  });
  LevelRegion region{0.5 * (low_z + high_z), outer->curve, {}};
  for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
    if (loop != outer) region.islands.push_back(loop->curve);
  }
  return region;
}

Piece loose_piece(const TopoDS_Edge& edge, double tolerance, std::size_t member) {
  const EdgeCurve read = edge_curve(edge, tolerance, member);
  if (read.high_z - read.low_z > kLevel) {
    throw ShapeError(
        ShapeFault::kTilted, member,
        with_number("An edge climbs by %.3g mm: pick edges and sketches that are parallel to XY.",
                    read.high_z - read.low_z));
  }
  return {read.curve, 0.5 * (read.low_z + read.high_z), read.end_error, member};
}

// A loop as it is looked at for nesting.
struct Outline {
  const Loop* loop;
  double area;               // mm^2, of either sense
  std::vector<Vec2> points;  // along it
  Vec2 low, high;            // the box round the points
};

Outline outline_of(const Loop& loop) {
  Outline outline{&loop,
                  std::abs(loop.curve.signed_area()),
                  loop.curve.flattened(kNestingTolerance),
                  {kInfinity, kInfinity},
                  {-kInfinity, -kInfinity}};
  for (const Vec2 p : outline.points) {
    outline.low = {std::min(outline.low.x, p.x), std::min(outline.low.y, p.y)};
    outline.high = {std::max(outline.high.x, p.x), std::max(outline.high.y, p.y)};
  }
  return outline;
}

// Whether `inner` lies within `outer`. Throws when it lies on both sides.
bool lies_within(const Outline& inner, const Outline& outer) {
  if (std::abs(outer.loop->z - inner.loop->z) > kLevel) return false;
  if (inner.low.x > outer.high.x || inner.high.x < outer.low.x || inner.low.y > outer.high.y ||
      inner.high.y < outer.low.y) {
    return false;
  }
  std::size_t within = 0;
  for (const Vec2 p : inner.points) within += outer.loop->curve.contains(p) ? 1 : 0;
  if (within != 0 && within != inner.points.size()) {
    throw ShapeError(ShapeFault::kCrossing, inner.loop->member,
                     "Two outlines cross or touch: keep them apart, or draw what they enclose "
                     "together as one.");
  }
  return within != 0;
}

std::vector<LevelRegion> nested(const std::vector<Loop>& loops) {
  const std::size_t n = loops.size();
  std::vector<Outline> outlines;
  outlines.reserve(n);
  for (const Loop& loop : loops) outlines.push_back(outline_of(loop));

  // How many loops lie round each, and which of them is the nearest.
  std::vector<std::size_t> depth(n, 0), parent(n, n);
  for (std::size_t inner = 0; inner < n; ++inner) {
    for (std::size_t outer = 0; outer < n; ++outer) {
      const double excess = outlines[outer].area - outlines[inner].area;
      if (excess < 0 || (excess == 0 && outer >= inner)) continue;
      if (!lies_within(outlines[inner], outlines[outer])) continue;
      ++depth[inner];
      if (parent[inner] == n || outlines[outer].area < outlines[parent[inner]].area)
        parent[inner] = outer;
    }
  }
  std::vector<LevelRegion> regions;
  std::vector<std::size_t> region_of(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (depth[i] % 2 != 0) continue;
    region_of[i] = regions.size();
    regions.push_back({loops[i].z, loops[i].curve, {}});
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (depth[i] % 2 != 0) regions[region_of[parent[i]]].islands.push_back(loops[i].curve);
  }
  return regions;
}

// The edges outside of faces.
std::vector<Piece> loose_pieces(const std::vector<TopoDS_Shape>& members, double tolerance) {
  std::vector<Piece> loose;
  TopTools_MapOfShape seen;
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (TopExp_Explorer explorer(members[i], TopAbs_EDGE, TopAbs_FACE); explorer.More();
         explorer.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(explorer.Current());
      if (BRep_Tool::Degenerated(edge) || !seen.Add(edge)) continue;
      loose.push_back(loose_piece(edge, tolerance, i));
    }
  }
  return loose;
}

std::vector<LevelRegion> regions_of(const TopoDS_Shape& shape, double tolerance) {
  const std::vector<TopoDS_Shape> members = members_of(shape);
  std::vector<LevelRegion> regions;
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (TopExp_Explorer face(members[i], TopAbs_FACE); face.More(); face.Next()) {
      regions.push_back(region_of_face(TopoDS::Face(face.Current()), tolerance, i));
    }
  }
  for (LevelRegion& region : nested(join(loose_pieces(members, tolerance))))
    regions.push_back(std::move(region));
  if (regions.empty()) {
    throw ShapeError(ShapeFault::kEmpty, 0,
                     "There is neither a face nor an edge to work on: pick a face or a sketch.");
  }
  return regions;
}

std::vector<LevelCurve> curves_of(const TopoDS_Shape& shape, double tolerance) {
  std::vector<LevelCurve> curves;
  for (Loop& loop : join_chains(loose_pieces(members_of(shape), tolerance)))
    curves.push_back({loop.z, std::move(loop.curve)});
  return curves;
}

// What `work` makes of the shape that the text describes.
template <typename Work>
auto from_brep(const std::string& text, double tolerance, const Work& work) {
  if (!(tolerance > 0)) throw std::invalid_argument("The tolerance must be above 0 mm.");
  try {
    return work(shape_from_brep(text), tolerance);
  } catch (const Standard_Failure& failure) {
    throw ShapeError(ShapeFault::kKernel, 0,
                     std::string("OpenCASCADE could not work on the shape: ") +
                         failure.DynamicType()->Name() + " " + failure.GetMessageString() + ".");
  }
}

}  // namespace

std::vector<LevelRegion> regions_from_brep(const std::string& text, double tolerance) {
  return from_brep(text, tolerance, regions_of);
}

std::vector<LevelCurve> curves_from_brep(const std::string& text, double tolerance) {
  return from_brep(text, tolerance, curves_of);
}

}  // namespace evenload
