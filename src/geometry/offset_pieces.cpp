#include "geometry/offset_pieces.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "geometry/intersect.h"

namespace evenload {

std::uint32_t OffsetNodes::add(Vec2 p) {
  const auto node = static_cast<std::uint32_t>(points_.size());
  points_.push_back(p);
  parents_.push_back(node);
  return node;
}

std::uint32_t OffsetNodes::find(std::uint32_t node) const {
  while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
  return node;
}

void OffsetNodes::merge(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  if (a != b) parents_[std::max(a, b)] = std::min(a, b);
}

void OffsetNodes::merge_near(double reach) {
  // Cells of the size of `reach`: what is near lies in the same cell or a neighbouring one.
  struct Cell {
    std::int64_t x, y;
    bool operator==(const Cell& other) const { return x == other.x && y == other.y; }
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      return static_cast<std::size_t>(c.x) * 0x9E3779B97F4A7C15u ^
             static_cast<std::size_t>(c.y) * 0xC2B2AE3D27D4EB4Fu;
    }
  };
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells;
  cells.reserve(points_.size());
  for (std::uint32_t node = 0; node < points_.size(); ++node) {
    if (find(node) != node) continue;
    const Vec2 p = points_[node];
    const Cell here{static_cast<std::int64_t>(std::floor(p.x / reach)),
                    static_cast<std::int64_t>(std::floor(p.y / reach))};
    for (std::int64_t x = here.x - 1; x <= here.x + 1; ++x) {
      for (std::int64_t y = here.y - 1; y <= here.y + 1; ++y) {
        const auto near = cells.find({x, y});
        if (near == cells.end()) continue;
        for (const std::uint32_t other : near->second)
          if (distance(points_[other], p) <= reach) merge(other, node);
      }
    }
    cells[here].push_back(node);
  }
}

namespace {

// A piece on its way: what is left of it after its corners are settled.
struct Moved {
  Segment segment;
  bool gone = false;  // an arc that shrank to a point or turned inside out
  double t0 = 0, t1 = 1;
  std::uint32_t from = 0, to = 0;
};

Moved moved_by(const Segment& s, double d, double same) {
  Moved m;
  if (s.is_arc()) {
    const double radius = s.radius + (s.sweep > 0 ? d : -d);
    // Inside out, every point is nearer than d to the rest of the arc it comes from.
    m.gone = radius <= same;
    m.segment = Segment::arc(s.centre, radius, s.start_angle, s.sweep);
  } else {
    const Vec2 aside = -d * left_normal(s.tangent(0));
    m.segment = Segment::line(s.a + aside, s.b + aside);
    m.gone = s.a == s.b;
  }
  m.segment.open = s.open;
  return m;
}

// Where the end of `before` and the start of `after` cross at a corner they turn towards, if what
// lies beyond is too near the other's source all along.
std::optional<Meeting> trimming(const Moved& before, const Moved& after,
                                const Segment& source_before, const Segment& source_after,
                                double d) {
  const Meetings met = meetings(before.segment, after.segment, kTouch);
  const Meeting* best = nullptr;
  for (const Meeting& m : met)
    if (best == nullptr || m.ta > best->ta) best = &m;
  for (const Meeting& m : met)
    if (best != nullptr && m.tb < best->tb) return std::nullopt;
  if (best == nullptr) return std::nullopt;
  for (const double share : {0.1, 0.5, 0.9}) {
    const Vec2 p = before.segment.point(best->ta + share * (1 - best->ta));
    const Vec2 q = after.segment.point(best->tb * (1 - share));
    if (source_after.distance_to(p) > d || source_before.distance_to(q) > d) return std::nullopt;
  }
  return *best;
}

class Collector {
 public:
  Collector(const BoundaryIndex& boundary, double d, const OffsetTolerances& tolerances,
            OffsetNodes& nodes, std::vector<OffsetPiece>& pieces)
      : boundary_(boundary), d_(d), tolerances_(tolerances), nodes_(nodes), pieces_(pieces) {}

  void add_curve(const Curve& curve);

 private:
  void add(const Segment& s, std::uint32_t from, std::uint32_t to, bool doubtful_side);
  void settle_corner(const Segment& before, const Segment& after, Moved& moved_before,
                     Moved& moved_after);

  const BoundaryIndex& boundary_;
  const double d_;
  const OffsetTolerances& tolerances_;
  OffsetNodes& nodes_;
  std::vector<OffsetPiece>& pieces_;
};

void Collector::add(const Segment& s, std::uint32_t from, std::uint32_t to, bool doubtful_side) {
  const double length = s.length();
  if (length <= tolerances_.same) {
    nodes_.merge(from, to);
    return;
  }
  // From the middle no point of the piece is farther than half its length, so none can be far
  // enough from the boundary.
  const double enough = std::abs(d_) - 0.5 * length - tolerances_.depth;
  if (enough > 0 && boundary_.distance_below(s.point(0.5), enough) < enough) return;
  if (std::abs(s.sweep) > kPi) {  // halves: no later bulge is above 1, which rounding would spoil
    const std::uint32_t middle = nodes_.add(s.point(0.5));
    pieces_.push_back({s.part(0, 0.5), from, middle, doubtful_side});
    pieces_.push_back({s.part(0.5, 1), middle, to, doubtful_side});
  } else {
    pieces_.push_back({s, from, to, doubtful_side});
  }
}

void Collector::settle_corner(const Segment& before, const Segment& after, Moved& moved_before,
                              Moved& moved_after) {
  const Vec2 u = before.tangent(1), v = after.tangent(0);
  double turn = std::atan2(cross(u, v), dot(u, v));
  moved_before.to = nodes_.add(moved_before.segment.b);
  moved_after.from = nodes_.add(moved_after.segment.a);
  const double size = std::abs(d_);
  if (size * std::abs(turn) <= tolerances_.whole) {
    nodes_.merge(moved_before.to, moved_after.from);
    return;
  }
  // At a cusp rounding may turn the sign of the turn; an arc too many does no harm, one too few
  // would leave a gap.
  constexpr double kCusp = 1e-6;  // rad
  const bool cusp = kPi - std::abs(turn) < kCusp;
  if (cusp && (turn > 0) != (d_ > 0)) turn += turn > 0 ? -2 * kPi : 2 * kPi;
  if ((turn > 0) == (d_ > 0)) {
    const Vec2 aside = -d_ * left_normal(u);
    Segment join = Segment::arc(before.b, size, angle_of(aside), turn);
    join.open = before.open && after.open;
    add(join, moved_before.to, moved_after.from, cusp);
    return;
  }
  if (moved_before.gone || moved_after.gone) return;
  const std::optional<Meeting> met = trimming(moved_before, moved_after, before, after, size);
  if (!met) return;
  moved_before.t1 = met->ta;
  moved_after.t0 = met->tb;
  moved_before.to = moved_after.from = nodes_.add(met->p);
}

void Collector::add_curve(const Curve& curve) {
  const std::vector<Segment> sources = curve.segments();
  const std::size_t n = sources.size();
  std::vector<Moved> all;
  all.reserve(n);
  for (const Segment& s : sources) all.push_back(moved_by(s, d_, tolerances_.same));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    settle_corner(sources[i], sources[next], all[i], all[next]);
  }
  for (const Moved& m : all) {
    if (m.gone || m.t0 >= m.t1)
      continue;  // cut off from both ends: all of it is too near its neighbours
    Segment s = m.t0 == 0 && m.t1 == 1 ? m.segment : m.segment.part(m.t0, m.t1);
    add(s, m.from, m.to, false);
  }
}

}  // namespace

std::vector<OffsetPiece> offset_pieces(const std::vector<Curve>& curves,
                                       const BoundaryIndex& boundary, double d,
                                       const OffsetTolerances& tolerances, OffsetNodes& nodes) {
  std::vector<OffsetPiece> pieces;
  Collector collector(boundary, d, tolerances, nodes, pieces);
  for (const Curve& curve : curves) collector.add_curve(curve);
  return pieces;
}

}  // namespace evenload
