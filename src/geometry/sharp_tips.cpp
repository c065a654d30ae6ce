#include "geometry/sharp_tips.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/boundary_index.h"

namespace evenload {
namespace {

// mm: what is to be had at a tip must be more.
constexpr double kWorthIt = 0.02;
// Share of the lines at a tip that it may be lengthened by.
constexpr double kMostOfLine = 0.25;
// Places along the axis beyond a tip at which the end is looked for, and mm to which it is found.
constexpr int kLooks = 32;
constexpr double kEnd = 1e-6;

struct Tip {
  Vec2 axis;           // unit vector, from the tip on
  double missing = 0;  // mm: to where it would be as near as the gap to where its walls meet
};

bool is_wall(const Segment& piece) { return !piece.is_arc() && !piece.open; }

std::optional<Tip> tip_between(const Segment& in, const Segment& out, double gap) {
  if (!is_wall(in) || !is_wall(out)) return std::nullopt;
  const Vec2 u = in.tangent(1), v = out.tangent(0);
  if (cross(u, v) <= 0 || dot(u, v) >= 0) return std::nullopt;
  const double sine = 0.5 * norm(u + v);  // of half the angle between them
  const double missing = gap / sine - gap;
  const double most = kMostOfLine * std::min(in.length(), out.length());
  if (missing <= kWorthIt || missing >= most) return std::nullopt;
  return Tip{normalized(u - v), missing};
}

// mm: how far the tip at `p` may be lengthened; 0 where `whole` does not end beyond it.
double length_to_end(Vec2 p, const Tip& tip, double gap, const BoundaryIndex& whole) {
  const double furthest = tip.missing + 2 * gap;  // beyond where its walls meet
  const auto is_inside = [&](double s) { return whole.contains(p + s * tip.axis); };
  if (is_inside(furthest)) return 0;
  double inside = 0, outside = furthest;
  for (int i = 1; i <= kLooks && outside == furthest; ++i) {
    const double s = furthest * i / kLooks;
    (is_inside(s) ? inside : outside) = s;
  }
  while (outside - inside > kEnd) {
    const double middle = 0.5 * (inside + outside);
    (is_inside(middle) ? inside : outside) = middle;
  }
  const double length = std::min(tip.missing, inside - gap);
  return length > kWorthIt ? length : 0;
}

class Tips {
 public:
  Tips(const std::vector<Region>& regions, double distance, double gap)
      : regions_(regions), distance_(distance), gap_(gap) {}

  void lengthen(Curve& curve) {
    const std::vector<Segment> pieces = curve.segments();
    std::vector<Vertex> vertices = curve.vertices();
    bool changed = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Segment& before = pieces[(i + pieces.size() - 1) % pieces.size()];
      const std::optional<Tip> tip = tip_between(before, pieces[i], gap_);
      if (!tip) continue;
      const double more = length_to_end(vertices[i].p, *tip, gap_, whole());
      vertices[i].p = vertices[i].p + more * tip->axis;
      changed |= more > 0;
    }
    if (changed) curve = Curve(std::move(vertices), true);
  }

 private:
  // Without the gap; few regions have tips that ask for it.
  const BoundaryIndex& whole() {
    if (!whole_) {
      std::vector<Curve> curves;
      for (const Region& region : offset(regions_, -distance_))
        for (Curve& curve : region.curves()) curves.push_back(std::move(curve));
      whole_.emplace(curves);
    }
    return *whole_;
  }

  const std::vector<Region>& regions_;
  double distance_, gap_;  // mm
  std::optional<BoundaryIndex> whole_;
};

}  // namespace

std::vector<Region> shrunk_to_tips(const std::vector<Region>& regions, double distance,
                                   double gap) {
  std::vector<Region> result = offset(regions, -(distance + gap));
  Tips tips(regions, distance, gap);
  for (Region& region : result) {
    tips.lengthen(region.outer);
    for (Curve& island : region.islands) tips.lengthen(island);
  }
  return result;
}

}  // namespace evenload
