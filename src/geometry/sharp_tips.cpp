#include "geometry/sharp_tips.h"

#include <cmath>
#include <utility>

namespace evenload {
namespace {

// mm: what is to be had at a tip must be more.
constexpr double kWorthIt = 0.02;
// Share of the lines at a tip that it may be lengthened by.
constexpr double kMostOfLine = 0.25;

bool is_wall(const Segment& piece) { return !piece.is_arc() && !piece.open; }

// mm: by how much the tip between two lines is lengthened.
double missing_at(const Segment& in, const Segment& out, double gap) {
  if (!is_wall(in) || !is_wall(out)) return 0;
  const Vec2 u = in.tangent(1), v = out.tangent(0);
  if (cross(u, v) <= 0 || dot(u, v) >= 0) return 0;
  const double sine = 0.5 * norm(u + v);  // of half the angle between them
  const double missing = gap / sine - gap;
  const double most = kMostOfLine * std::min(in.length(), out.length());
  return missing > kWorthIt && missing < most ? missing : 0;
}

Curve with_sharp_tips(const Curve& curve, double gap) {
  std::vector<Vertex> vertices = curve.vertices();
  const std::vector<Segment> pieces = curve.segments();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Segment& in = pieces[(i + pieces.size() - 1) % pieces.size()];
    const double missing = missing_at(in, pieces[i], gap);
    if (missing > 0)
      vertices[i].p = vertices[i].p + missing * normalized(in.tangent(1) - pieces[i].tangent(0));
  }
  return Curve(std::move(vertices), true);
}

}  // namespace

std::vector<Region> with_sharp_tips(const std::vector<Region>& regions, double gap) {
  std::vector<Region> result = regions;
  for (Region& region : result) {
    region.outer = with_sharp_tips(region.outer, gap);
    for (Curve& island : region.islands) island = with_sharp_tips(island, gap);
  }
  return result;
}

}  // namespace evenload
