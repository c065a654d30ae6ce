#include "occt/face_mesh.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <limits>
#include <unordered_map>

#include "support/progress.h"

namespace evenload {
namespace {

using Side = std::uint64_t;
using NewPoints = std::unordered_map<Side, std::uint32_t>;  // in the middles of sides

constexpr double kUnknown = -1;
constexpr std::size_t kTrianglesAStep = 256;  // some milliseconds

Side side_of(std::uint32_t a, std::uint32_t b) {
  return (static_cast<Side>(std::min(a, b)) << 32U) | std::max(a, b);
}

Side side_of(const FaceMesh::Triangle& triangle, std::size_t k) {
  return side_of(triangle[k], triangle[(k + 1) % 3]);
}

gp_Pnt point_of(const FaceMesh& mesh, std::uint32_t number) {
  const auto& [x, y, z] = mesh.points[number];
  return gp_Pnt(x, y, z);
}

gp_XY place_of(const FaceMesh& mesh, std::uint32_t number) {
  const auto& [u, v] = mesh.places[number];
  return gp_XY(u, v);
}

gp_Pnt2d middle_place(const FaceMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return gp_Pnt2d(0.5 * (place_of(mesh, a) + place_of(mesh, b)));
}

gp_Pnt at(const BRepAdaptor_Surface& surface, const gp_Pnt2d& place) {
  return surface.Value(place.X(), place.Y());
}

// mm: how far the surface lies from a flat triangle, across the triangle, at four places.
double off_surface(const BRepAdaptor_Surface& surface, const FaceMesh& mesh,
                   const FaceMesh::Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const gp_Pnt corner = point_of(mesh, a);
  const gp_Vec normal =
      gp_Vec(corner, point_of(mesh, b)).Crossed(gp_Vec(corner, point_of(mesh, c)));
  const double size = normal.Magnitude();
  if (!(size > 0)) return 0;
  const gp_Pnt2d middle((place_of(mesh, a) + place_of(mesh, b) + place_of(mesh, c)) / 3);
  double off = 0;
  for (const gp_Pnt2d& place :
       {middle, middle_place(mesh, a, b), middle_place(mesh, b, c), middle_place(mesh, c, a)})
    off = std::max(off, std::abs(gp_Vec(corner, at(surface, place)).Dot(normal)) / size);
  return off;
}

// Sides of a single triangle: the face's border, where its neighbours are.
std::vector<Side> border_of(const std::vector<FaceMesh::Triangle>& triangles) {
  std::vector<Side> all, single;
  for (const FaceMesh::Triangle& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k) all.push_back(side_of(triangle, k));
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i - 1] != all[i]) && (i + 1 == all.size() || all[i + 1] != all[i]))
      single.push_back(all[i]);
  return single;
}

// The number of the inner side over whose middle the surface stands furthest; 3: there is none.
std::size_t side_to_halve(const BRepAdaptor_Surface& surface, const FaceMesh& mesh,
                          const std::vector<Side>& border, const FaceMesh::Triangle& triangle) {
  std::size_t found = 3;
  double furthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::binary_search(border.begin(), border.end(), side_of(triangle, k))) continue;
    const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
    const gp_Pnt flat(0.5 * (point_of(mesh, a).XYZ() + point_of(mesh, b).XYZ()));
    const double off = flat.Distance(at(surface, middle_place(mesh, a, b)));
    if (off <= furthest) continue;
    furthest = off;
    found = k;
  }
  return found;
}

void halve(const BRepAdaptor_Surface& surface, FaceMesh& mesh, const FaceMesh::Triangle& triangle,
           std::size_t side, NewPoints& halved) {
  const auto number = static_cast<std::uint32_t>(mesh.points.size());
  if (!halved.emplace(side_of(triangle, side), number).second) return;
  const gp_Pnt2d place = middle_place(mesh, triangle[side], triangle[(side + 1) % 3]);
  const gp_Pnt point = at(surface, place);
  mesh.places.push_back({place.X(), place.Y()});
  mesh.points.push_back({point.X(), point.Y(), point.Z()});
}

// What becomes of a triangle whose sides are halved: one side after the other, each cuts off a
// part.
void add_parts(const FaceMesh::Triangle& triangle, const NewPoints& halved,
               std::vector<FaceMesh::Triangle>& parts) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = halved.find(side_of(triangle, k));
    if (found == halved.end()) continue;
    const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
    add_parts({a, found->second, c}, halved, parts);
    add_parts({found->second, b, c}, halved, parts);
    return;
  }
  parts.push_back(triangle);
}

// Splits triangles along halved sides; `off`, what each leaves the surface, is not known of new
// ones.
void split(const NewPoints& halved, std::vector<FaceMesh::Triangle>& triangles,
           std::vector<double>& off) {
  std::vector<FaceMesh::Triangle> parts;
  std::vector<double> parts_off;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t before = parts.size();
    add_parts(triangles[i], halved, parts);
    const std::size_t count = parts.size() - before;
    parts_off.insert(parts_off.end(), count, count == 1 ? off[i] : kUnknown);
  }
  triangles = std::move(parts);
  off = std::move(parts_off);
}

}  // namespace

double split_where_off(const BRepAdaptor_Surface& surface, double wished, FaceMesh& mesh,
                       Progress& progress) {
  std::vector<double> off(mesh.triangles.size(), kUnknown);
  std::vector<Side> border;
  for (int round = 0;; ++round) {
    double deflection = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
      if (i % kTrianglesAStep == 0) progress.step();
      if (off[i] == kUnknown) off[i] = off_surface(surface, mesh, mesh.triangles[i]);
      deflection = std::max(deflection, off[i]);
    }
    if (deflection <= wished || round == kSplitRounds) return deflection;
    if (round == 0) border = border_of(mesh.triangles);
    NewPoints halved;
    for (std::size_t i = 0; i < off.size(); ++i) {
      if (off[i] <= wished) continue;
      const std::size_t side = side_to_halve(surface, mesh, border, mesh.triangles[i]);
      if (side < 3) halve(surface, mesh, mesh.triangles[i], side, halved);
    }
    if (halved.empty()) return deflection;
    split(halved, mesh.triangles, off);
  }
}

}  // namespace evenload
