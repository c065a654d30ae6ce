#include "geometry/fine_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/bi_arc.h"
#include "support/errors.h"

namespace evenload {
namespace {

// rad: lines that turn by less are one.
constexpr double kNoCorner = 1e-5;
// Corners at most that a pair of arcs replaces.
constexpr std::size_t kLongestRow = 128;
// rad: of either arc.
constexpr double kMostArc = 0.9 * kPi;
// Places along an arc that are looked at for being inside.
constexpr int kLooksAtArc = 8;
// mm: rounding.
constexpr double kOutside = 1e-7;
// Share of the tolerance: of a single corner's arc, so that rounding does no harm.
constexpr double kOfTolerance = 0.9;

bool is_fine(const Segment& before, const Segment& after) {
  if (before.is_arc() || after.is_arc() || before.open || after.open) return false;
  const Vec2 a = before.tangent(0), b = after.tangent(0);
  const double turn = std::atan2(cross(a, b), dot(a, b));
  return turn > kNoCorner && turn < kFineCorner;
}

// Lines in a row with fine corners between them.
class Row {
 public:
  Row(const std::vector<Segment>& lines, double tolerance) : lines_(lines), tolerance_(tolerance) {}

  // What leads from the row's beginning to its end.
  std::vector<Segment> smooth() {
    at_ = lines_.front().a;
    for (std::size_t i = 0; i + 1 < lines_.size();) i = replace_from(i);
    go_to(lines_.back().b);
    return std::move(made_);
  }

 private:
  struct Arcs {
    Vec2 from, to;
    BiArc pair;
  };

  // Replaces as many corners from the end of the line `i` on as one pair of arcs can; returns the
  // line that it ends on.
  std::size_t replace_from(std::size_t i) {
    Arcs best = arc_at_corner(i);
    std::size_t last = i + 1;
    const std::size_t end = std::min(lines_.size() - 1, i + kLongestRow);
    for (std::size_t step = 1; step > 0;) {
      const std::size_t k = std::min(end, last + step);
      if (std::optional<Arcs> arcs = k > last ? arcs_between(i, k) : std::nullopt) {
        best = *arcs;
        last = k;
        step = 2 * step;
      } else {
        step /= 2;
      }
    }
    go_to(best.from);
    for (const Segment& arc : {best.pair.first, best.pair.second})
      if (arc.length() > kZeroLength) made_.push_back(arc);
    at_ = best.to;
    return last;
  }

  void go_to(Vec2 p) {
    if (distance(at_, p) > kZeroLength) made_.push_back(Segment::line(at_, p));
    at_ = p;
  }

  // Half of each line is left to the rows before and after, and of long ones what a row of equally
  // long ones would not take.
  double reach_at(std::size_t i, std::size_t neighbour) const {
    return 0.5 * std::min(lines_[i].length(), lines_[neighbour].length());
  }

  std::optional<Arcs> arcs_between(std::size_t i, std::size_t k) const {
    const Vec2 ahead = lines_[i].tangent(0), along = lines_[k].tangent(0);
    Arcs arcs;
    arcs.from = lines_[i].b - reach_at(i, i + 1) * ahead;
    arcs.to = lines_[k].a + reach_at(k, k - 1) * along;
    const std::optional<BiArc> pair = bi_arc({arcs.from, ahead}, {arcs.to, along}, kMostArc);
    if (!pair) return std::nullopt;
    arcs.pair = *pair;
    for (std::size_t j = i; j < k; ++j) {
      const Vec2 corner = lines_[j].b;
      if (std::min(pair->first.distance_to(corner), pair->second.distance_to(corner)) > tolerance_)
        return std::nullopt;
    }
    for (const Segment& arc : {pair->first, pair->second})
      for (int look = 1; look <= kLooksAtArc; ++look)
        if (!is_inside(arc.point((look - 0.5) / kLooksAtArc), i, k)) return std::nullopt;
    return arcs;
  }

  bool is_inside(Vec2 p, std::size_t i, std::size_t k) const {
    for (std::size_t j = i; j <= k; ++j)
      if (cross(lines_[j].tangent(0), p - lines_[j].a) < -kOutside) return false;
    return true;
  }

  // The widest arc about the corner at the end of the line `i`.
  Arcs arc_at_corner(std::size_t i) const {
    const Vec2 ahead = lines_[i].tangent(0), along = lines_[i + 1].tangent(0), p = lines_[i].b;
    const double turn = std::atan2(cross(ahead, along), dot(ahead, along));
    const double half = std::tan(0.5 * turn);
    const double widest = kOfTolerance * tolerance_ / (1 / std::cos(0.5 * turn) - 1);
    const double reach = std::min(reach_at(i, i + 1), widest * half);
    Arcs arcs{p - reach * ahead, p + reach * along, {}};
    const double radius = reach / half;
    const Segment arc = Segment::arc(arcs.from + radius * left_normal(ahead), radius,
                                     angle_of(ahead) - kPi / 2, turn);
    arcs.pair = {arc, Segment::line(arc.b, arc.b)};
    return arcs;
  }

  const std::vector<Segment>& lines_;
  double tolerance_;
  std::vector<Segment> made_;
  Vec2 at_;
};

// The pieces, the first of which follows no fine corner; where all are fine the first is a half,
// and the last the other.
std::vector<Segment> rotated_pieces(const Curve& curve) {
  std::vector<Segment> pieces = curve.segments();
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!is_fine(pieces[(i + pieces.size() - 1) % pieces.size()], pieces[i])) {
      std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.end());
      return pieces;
    }
  const Segment whole = pieces.front();
  pieces.front() = whole.part(0.5, 1);
  pieces.push_back(whole.part(0, 0.5));
  return pieces;
}

Curve without_fine_corners(const Curve& curve, double tolerance) {
  const std::vector<Segment> pieces = rotated_pieces(curve);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < pieces.size();) {
    std::vector<Segment> row{pieces[i]};
    while (++i < pieces.size() && is_fine(row.back(), pieces[i])) row.push_back(pieces[i]);
    for (const Segment& s : row.size() > 1 ? Row(row, tolerance).smooth() : row)
      vertices.push_back({s.a, s.bulge(), s.open});
  }
  return Curve(std::move(vertices), true);
}

bool has_fine_corners(const Curve& curve) {
  const std::vector<Segment> pieces = curve.segments();
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (is_fine(pieces[i], pieces[(i + 1) % pieces.size()])) return true;
  return false;
}

}  // namespace

std::vector<Region> without_fine_corners(const std::vector<Region>& regions, double tolerance) {
  std::vector<Region> result;
  for (const Region& region : regions) {
    const std::vector<Curve> curves = region.curves();
    if (std::none_of(curves.begin(), curves.end(), has_fine_corners)) {
      result.push_back(region);
      continue;
    }
    std::vector<Curve> islands;
    for (const Curve& island : region.islands)
      islands.push_back(without_fine_corners(island, tolerance));
    try {
      result.push_back(make_region(without_fine_corners(region.outer, tolerance), islands));
    } catch (const GeometryError&) {  // a neck hardly wider than the tolerance
      result.push_back(region);
    }
  }
  return result;
}

}  // namespace evenload
