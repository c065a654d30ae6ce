#include "occt/edge_curve.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GeomAbs_CurveType.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "occt/bi_arcs.h"
#include "occt/shape_error.h"

namespace evenload {
namespace {

// Where the height of an edge is taken: enough to see any edge that leaves its plane.
constexpr int kHeightSamples = 32;
// A derivative shorter than this share of the edge's length per parameter says nothing about the
// direction.
constexpr double kNoDirection = 1e-9;
// The step, as a share of the parameter range, to the neighbour that tells the direction instead.
constexpr double kDirectionStep = 1e-4;

Vec2 plane_point(const gp_Pnt& p) { return {p.X(), p.Y()}; }

Curve circle_chain(const BRepAdaptor_Curve& edge, double from, double to) {
  const int pieces = to - from > kPi * (1 + 1e-9) ? 2 : 1;
  const double turn = edge.Circle().Axis().Direction().Z() > 0 ? to - from : from - to;
  std::vector<Vertex> vertices;
  for (int i = 0; i <= pieces; ++i) {
    const Vec2 p = plane_point(edge.Value(from + (to - from) * i / pieces));
    vertices.push_back({p, i < pieces ? std::tan(turn / pieces / 4) : 0});
  }
  return Curve(std::move(vertices), false);
}

// The chain of a curve that is smooth between `from` and `to`.
Curve smooth_chain(const Adaptor3d_Curve& edge, double tolerance) {
  const double from = edge.FirstParameter();
  const double to = edge.LastParameter();
  const double step = kDirectionStep * (to - from);
  const double shortest =
      kNoDirection * edge.Value(from).Distance(edge.Value(0.5 * (from + to))) / (to - from);
  const auto at = [&](double t) -> PlanePoint {
    gp_Pnt p;
    gp_Vec derivative;
    edge.D1(t, p, derivative);
    Vec2 direction{derivative.X(), derivative.Y()};
    if (!(norm(direction) > shortest)) {
      direction = plane_point(edge.Value(std::min(t + step, to))) -
                  plane_point(edge.Value(std::max(t - step, from)));
    }
    return {plane_point(p), norm(direction) > 0 ? normalized(direction) : Vec2{1, 0}};
  };
  int spans = 1;
  if (edge.GetType() == GeomAbs_BSplineCurve || edge.GetType() == GeomAbs_OffsetCurve ||
      edge.GetType() == GeomAbs_OtherCurve) {
    spans = std::max(1, edge.NbIntervals(GeomAbs_CN));
  }
  return bi_arcs(at, from, to, tolerance, spans);
}

void append(std::vector<Vertex>& vertices, const Curve& chain) {
  if (!vertices.empty()) vertices.pop_back();
  vertices.insert(vertices.end(), chain.vertices().begin(), chain.vertices().end());
}

}  // namespace

EdgeCurve edge_curve(const TopoDS_Edge& shape, double tolerance, std::size_t member) {
  const BRepAdaptor_Curve edge(shape);
  const double from = edge.FirstParameter();
  const double to = edge.LastParameter();
  if (Precision::IsInfinite(from) || Precision::IsInfinite(to)) {
    throw ShapeError(ShapeFault::kNotFinite, member,
                     "An edge has no end: pick edges of finite length.");
  }

  EdgeCurve result;
  result.low_z = result.high_z = edge.Value(from).Z();
  for (int i = 1; i <= kHeightSamples; ++i) {
    const double z = edge.Value(from + (to - from) * i / kHeightSamples).Z();
    result.low_z = std::min(result.low_z, z);
    result.high_z = std::max(result.high_z, z);
  }
  for (const TopoDS_Vertex& end : {TopExp::FirstVertex(shape), TopExp::LastVertex(shape)}) {
    if (!end.IsNull()) result.end_error = std::max(result.end_error, BRep_Tool::Tolerance(end));
  }

  std::vector<Vertex> vertices;
  switch (edge.GetType()) {
    case GeomAbs_Line:
      vertices = {{plane_point(edge.Value(from))}, {plane_point(edge.Value(to))}};
      break;
    case GeomAbs_Circle:
      append(vertices, circle_chain(edge, from, to));
      break;
    default: {
      const int smooth_parts = std::max(1, edge.NbIntervals(GeomAbs_C1));
      TColStd_Array1OfReal bounds(1, smooth_parts + 1);
      edge.Intervals(bounds, GeomAbs_C1);
      for (int i = 1; i <= smooth_parts; ++i) {
        // Trimmed, so that a corner between two parts has the direction of the part that is looked
        // at.
        const auto part = edge.Trim(bounds.Value(i), bounds.Value(i + 1), Precision::PConfusion());
        append(vertices, smooth_chain(*part, tolerance));
      }
    }
  }
  result.curve = Curve(std::move(vertices), false);
  return result;
}

}  // namespace evenload
