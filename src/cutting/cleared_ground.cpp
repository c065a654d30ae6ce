#include "cutting/cleared_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Buckets are not made finer than this many in all, so that memory stays bounded for large, sparse
// work.
constexpr double kMaximumBuckets = 4e6;

// A place where the border of a swept area crosses the circle: unit vector from the circle's
// centre.
struct Crossing {
  Vec2 direction;
  double angle = 0;
};

// rad: arcs are looked at in parts no shorter than this,
constexpr double kDiscAngle = kPi / 36;
// and in no more parts than this.
constexpr int kMostDiscs = 8;

// A few arise per move at most: four circles or two circles and two lines, two crossings each.
struct Crossings {
  std::array<Crossing, 8> at;
  int count = 0;
  void push(Vec2 direction) { at[static_cast<std::size_t>(count++)].direction = direction; }
};

// Removes [low, high] from the ordered set. False when the set stays as it was.
bool cut(std::vector<AngularInterval>& set, double low, double high) {
  std::size_t keep = 0;
  const std::size_t n = set.size();
  AngularInterval extra;
  bool has_extra = false, changed = false;
  std::size_t extra_at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const AngularInterval piece = set[i];
    if (high <= piece.low || low >= piece.high) {
      set[keep++] = piece;
    } else {
      changed = true;
      const bool left = low > piece.low, right = high < piece.high;
      if (left) set[keep++] = {piece.low, low};
      if (right) {
        if (left) {
          extra = {high, piece.high};
          extra_at = keep;
          has_extra = true;
          for (std::size_t j = i + 1; j < n; ++j) set[keep++] = set[j];
          break;
        }
        set[keep++] = {high, piece.high};
      }
    }
  }
  set.resize(keep);
  if (has_extra) set.insert(set.begin() + static_cast<std::ptrdiff_t>(extra_at), extra);
  return changed;
}

// Removes the arc [low, high], given in any turn, from a set that lies within [set_low, set_low + 2
// pi].
bool cut_wrapped(std::vector<AngularInterval>& set, double low, double high) {
  if (set.empty()) return false;
  const double width = high - low;
  const double base = set.front().low;
  const double start = base + wrap_positive(low - base);
  bool changed = cut(set, start, start + width);
  if (!set.empty() && start + width > base + 2 * kPi)
    changed = cut(set, start - 2 * kPi, start - 2 * kPi + width) || changed;
  return changed;
}

// `v` turned counter-clockwise by the angle of unit vector `turn`.
Vec2 rotated(Vec2 v, Vec2 turn) {
  return {v.x * turn.x - v.y * turn.y, v.x * turn.y + v.y * turn.x};
}

// The middle of the arc that runs counter-clockwise from unit vector `from` to unit vector `to`.
Vec2 between(Vec2 from, Vec2 to) {
  const Vec2 chord = to - from;
  const double length = norm(chord);
  return length > 1e-12 ? Vec2{chord.y / length, -chord.x / length} : from;
}

}  // namespace

ClearedGround::ClearedGround(const Bounds& bounds, double tool_radius,
                             const std::vector<Region>* material)
    : tool_radius_(tool_radius) {
  const double margin = 0.5 * tool_radius;
  origin_ = bounds.low - Vec2{margin, margin};
  const double width = bounds.high.x - bounds.low.x + 2 * margin;
  const double height = bounds.high.y - bounds.low.y + 2 * margin;
  cell_ = std::max(0.5 * tool_radius, std::sqrt(width * height / kMaximumBuckets));
  columns_ = static_cast<int>(std::ceil(width / cell_)) + 1;
  rows_ = static_cast<int>(std::ceil(height / cell_)) + 1;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  if (material) {
    limited_ = true;
    material_ = *material;
    for (const Region& region : material_)
      for (const Curve& curve : region.curves())
        for (const Segment& segment : curve.segments())
          if (segment.open) material_edges_.push_back(segment);
  }
}

template <typename Visit>
void ClearedGround::visit_buckets(const Primitive& primitive, Visit visit) {
  // A query at any point of a bucket must find every move that can reach the tool's circle there.
  const double reach = primitive.radius + tool_radius_;
  const Segment& s = primitive.segment;
  Vec2 low{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)};
  Vec2 high{std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)};
  if (s.is_arc()) {
    for (int quarter = 1; quarter < 4; ++quarter) {
      // The arc bulges out of its chord's box by at most what these points show plus a quarter's
      // sagitta.
      const Vec2 q = s.point(quarter / 4.0);
      low = {std::min(low.x, q.x), std::min(low.y, q.y)};
      high = {std::max(high.x, q.x), std::max(high.y, q.y)};
    }
    const double sagitta = s.radius * (1 - std::cos(std::abs(s.sweep) / 8));
    low = low - Vec2{sagitta, sagitta};
    high = high + Vec2{sagitta, sagitta};
  }
  const int i0 = std::max(0, static_cast<int>(std::floor((low.x - reach - origin_.x) / cell_)));
  const int j0 = std::max(0, static_cast<int>(std::floor((low.y - reach - origin_.y) / cell_)));
  const int i1 =
      std::min(columns_ - 1, static_cast<int>(std::floor((high.x + reach - origin_.x) / cell_)));
  const int j1 =
      std::min(rows_ - 1, static_cast<int>(std::floor((high.y + reach - origin_.y) / cell_)));
  const double half_diagonal = cell_ * 0.70710678118654757;
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      const Vec2 centre = origin_ + Vec2{(i + 0.5) * cell_, (j + 0.5) * cell_};
      if (distance(primitive, centre) <= reach + half_diagonal)
        visit(buckets_[static_cast<std::size_t>(j) * columns_ + i]);
    }
}

void ClearedGround::add(const Segment& move, double swept_radius) {
  EVENLOAD_ASSERT(std::isfinite(move.a.x + move.a.y + move.b.x + move.b.y));
  Primitive primitive;
  primitive.segment = move;
  primitive.radius = swept_radius;
  Vec2 middle;
  double half = 0;
  if (move.is_arc()) {
    const Vec2 start = (move.a - move.centre) / move.radius,
               end = (move.b - move.centre) / move.radius;
    primitive.first = move.sweep > 0 ? start : end;
    primitive.last = move.sweep > 0 ? end : start;
    primitive.reflex = std::abs(move.sweep) > kPi;
    if (std::abs(move.sweep) < kPi) {
      middle = 0.5 * (move.a + move.b);
      half = 0.5 * evenload::distance(move.a, move.b);
    } else {
      middle = move.centre;
      half = move.radius;
    }
  } else {
    primitive.length = evenload::distance(move.a, move.b);
    primitive.direction = primitive.length > 0 ? (move.b - move.a) / primitive.length : Vec2{1, 0};
    middle = 0.5 * (move.a + move.b);
    half = 0.5 * primitive.length;
  }
  const auto id = static_cast<std::int32_t>(primitives_.size());
  primitives_.push_back(primitive);
  discs_.push_back({middle, half + swept_radius});
  visit_buckets(primitive, [id](std::vector<std::int32_t>& bucket) { bucket.push_back(id); });
}

void ClearedGround::remove_last() {
  EVENLOAD_ASSERT(!primitives_.empty());
  const Primitive primitive = primitives_.back();
  primitives_.pop_back();
  discs_.pop_back();
  visit_buckets(primitive, [](std::vector<std::int32_t>& bucket) { bucket.pop_back(); });
}

const std::vector<std::int32_t>& ClearedGround::bucket(Vec2 p) const {
  const int i = static_cast<int>(std::floor((p.x - origin_.x) / cell_));
  const int j = static_cast<int>(std::floor((p.y - origin_.y) / cell_));
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return nothing_;
  return buckets_[static_cast<std::size_t>(j) * columns_ + i];
}

double ClearedGround::distance(const Primitive& primitive, Vec2 x) const {
  const Segment& s = primitive.segment;
  if (!s.is_arc()) {
    const Vec2 v = x - s.a;
    const double along = dot(v, primitive.direction);
    if (along <= 0) return norm(v);
    if (along >= primitive.length) return evenload::distance(x, s.b);
    return std::abs(cross(primitive.direction, v));
  }
  const Vec2 v = x - s.centre;
  const bool after_first = cross(primitive.first, v) >= 0,
             before_last = cross(v, primitive.last) >= 0;
  if (primitive.reflex ? after_first || before_last : after_first && before_last)
    return std::abs(norm(v) - s.radius);
  return std::sqrt(std::min(squared_norm(x - s.a), squared_norm(x - s.b)));
}

bool ClearedGround::subtract(const Primitive& primitive, Vec2 p, double radius,
                             std::vector<AngularInterval>& set) const {
  const Segment& s = primitive.segment;
  const double reach = primitive.radius;
  // The border consists of circles about the ends, where an end is the nearest point of the move,
  // and of lines or circles beside it elsewhere. Crossings with the parts that are not border are
  // dropped.
  Crossings crossings;
  const auto cross_circle = [&](Vec2 centre, double r, const auto& on_border) {
    const Vec2 v = centre - p;
    const double d = norm(v);
    if (d < 1e-12) return;
    const double c = (d * d + radius * radius - r * r) / (2 * d * radius);
    if (c <= -1 || c >= 1) return;
    const double h = std::sqrt(1 - c * c);
    const Vec2 towards = v / d, aside = left_normal(towards);
    for (const Vec2 direction : {c * towards - h * aside, c * towards + h * aside})
      if (on_border(p + radius * direction)) crossings.push(direction);
  };
  constexpr double kJoint = 1e-9;  // mm: about the joints of the border's parts both count
  if (s.is_arc()) {
    const auto beside = [&](Vec2 x, double margin) {
      const Vec2 v = x - s.centre;
      const bool after_first = cross(primitive.first, v) >= -margin;
      const bool before_last = cross(v, primitive.last) >= -margin;
      return primitive.reflex ? after_first || before_last : after_first && before_last;
    };
    const auto along = [&](Vec2 x) { return beside(x, kJoint); };
    cross_circle(s.centre, s.radius + reach, along);
    if (s.radius > reach) cross_circle(s.centre, s.radius - reach, along);
    const auto at_end = [&](Vec2 x, Vec2 end, Vec2 other) {
      return !beside(x, -kJoint) && squared_norm(x - end) <= squared_norm(x - other) + kJoint;
    };
    cross_circle(s.a, reach, [&](Vec2 x) { return at_end(x, s.a, s.b); });
    cross_circle(s.b, reach, [&](Vec2 x) { return at_end(x, s.b, s.a); });
  } else if (primitive.length > 0) {
    const auto along = [&](Vec2 x) { return dot(x - s.a, primitive.direction); };
    cross_circle(s.a, reach, [&](Vec2 x) { return along(x) <= kJoint; });
    cross_circle(s.b, reach, [&](Vec2 x) { return along(x) >= primitive.length - kJoint; });
    const double aside = cross(primitive.direction, p - s.a);
    const Vec2 normal = left_normal(primitive.direction);
    for (const double side : {reach, -reach}) {
      const double v = (side - aside) / radius;
      if (v <= -1 || v >= 1) continue;
      const double h = std::sqrt(1 - v * v);
      for (const Vec2 direction :
           {v * normal + h * primitive.direction, v * normal - h * primitive.direction}) {
        const double t = along(p + radius * direction);
        if (t >= -kJoint && t <= primitive.length + kJoint) crossings.push(direction);
      }
    }
  } else {
    cross_circle(s.a, reach, [](Vec2) { return true; });
  }
  const int count = crossings.count;
  if (count == 0) {
    if (distance(primitive, p + Vec2{radius, 0}) > reach) return false;
    set.clear();
    return true;
  }
  for (int i = 0; i < count; ++i)
    crossings.at[static_cast<std::size_t>(i)].angle =
        wrap_positive(angle_of(crossings.at[static_cast<std::size_t>(i)].direction));
  // At most eight: sorted by insertion.
  for (std::size_t i = 1; i < static_cast<std::size_t>(count); ++i)
    for (std::size_t k = i; k > 0 && crossings.at[k].angle < crossings.at[k - 1].angle; --k)
      std::swap(crossings.at[k], crossings.at[k - 1]);
  bool changed = false;
  for (int i = 0; i < count; ++i) {
    const Crossing& from = crossings.at[static_cast<std::size_t>(i)];
    const Crossing& to = crossings.at[static_cast<std::size_t>((i + 1) % count)];
    const double high = i + 1 < count ? to.angle : to.angle + 2 * kPi;
    if (high - from.angle < 1e-12) continue;
    const Vec2 middle = count > 1 ? between(from.direction, to.direction) : -from.direction;
    if (distance(primitive, p + radius * middle) <= reach)
      changed = cut_wrapped(set, from.angle, high) || changed;
  }
  return changed;
}

void ClearedGround::uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out,
                              double shrink, std::size_t last) const {
  const double radius = tool_radius_ - shrink;
  out.clear();
  out.push_back({low, high});
  // Small discs that hold the remaining arcs, piece by piece: moves that reach none of them take
  // nothing away.
  thread_local std::vector<Disc> discs;
  const auto describe = [&] {
    discs.clear();
    for (const AngularInterval& interval : out) {
      const int n = std::min(kMostDiscs, 1 + static_cast<int>(interval.width() / kDiscAngle));
      const double half = 0.5 * interval.width() / n;
      const Vec2 turn = unit(half);
      Vec2 towards = unit(interval.low + half);
      for (int k = 0; k < n; ++k) {
        discs.push_back({p + radius * turn.x * towards, radius * turn.y});
        towards = rotated(rotated(towards, turn), turn);
      }
    }
  };
  describe();
  const std::vector<std::int32_t>& ids = bucket(p);
  for (auto id = ids.rbegin(); id != ids.rend() && !out.empty(); ++id) {
    const auto index = static_cast<std::size_t>(*id);
    if (index >= last) continue;
    const Disc& holds = discs_[index];
    bool near = false;
    for (const Disc& disc : discs) {
      const double far = holds.radius + disc.radius;
      if (squared_norm(disc.centre - holds.centre) >= far * far) continue;
      if (distance(primitives_[index], disc.centre) >= primitives_[index].radius + disc.radius)
        continue;
      near = true;
      break;
    }
    if (near && subtract(primitives_[index], p, radius, out)) describe();
  }
  if (limited_ && !out.empty()) remove_outside_material(p, radius, out);
}

void ClearedGround::remove_outside_material(Vec2 p, double radius,
                                            std::vector<AngularInterval>& set) const {
  std::vector<double> breaks;
  for (const Segment& s : material_edges_) {
    if (s.distance_to(p) > radius) continue;
    const auto keep = [&](double angle) {
      if (s.distance_to(p + radius * unit(angle)) < 1e-7) breaks.push_back(wrap_positive(angle));
    };
    if (s.is_arc()) {
      const Vec2 v = s.centre - p;
      const double d = norm(v);
      if (d < 1e-12) continue;
      const double c = (d * d + radius * radius - s.radius * s.radius) / (2 * d * radius);
      if (std::abs(c) >= 1) continue;
      keep(angle_of(v) - std::acos(c));
      keep(angle_of(v) + std::acos(c));
    } else {
      const Vec2 direction = normalized(s.b - s.a);
      const double v = -cross(direction, p - s.a) / radius;
      if (std::abs(v) >= 1) continue;
      keep(angle_of(direction) + std::asin(v));
      keep(angle_of(direction) + kPi - std::asin(v));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  const auto inside = [&](Vec2 x) {
    return std::any_of(material_.begin(), material_.end(),
                       [x](const Region& region) { return region.contains(x); });
  };
  if (breaks.empty()) {
    const AngularInterval& piece = set.front();
    if (!inside(p + radius * unit(0.5 * (piece.low + piece.high)))) set.clear();
    return;
  }
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const double low = breaks[i];
    const double high = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + 2 * kPi;
    if (high - low > 1e-12 && !inside(p + radius * unit(0.5 * (low + high))))
      cut_wrapped(set, low, high);
  }
}

bool ClearedGround::is_clear(Vec2 p, double shrink) const {
  thread_local std::vector<AngularInterval> scratch;
  uncovered(p, 0, 2 * kPi, scratch, shrink);
  return scratch.empty();
}

bool ClearedGround::is_cleared_since(Vec2 x, std::size_t first) const {
  const std::vector<std::int32_t>& ids = bucket(x);
  for (auto id = ids.rbegin(); id != ids.rend() && static_cast<std::size_t>(*id) >= first; ++id) {
    const Primitive& primitive = primitives_[static_cast<std::size_t>(*id)];
    if (distance(primitive, x) <= primitive.radius) return true;
  }
  return false;
}

bool ClearedGround::is_cleared_point(Vec2 x) const {
  if (limited_ && std::none_of(material_.begin(), material_.end(),
                               [x](const Region& region) { return region.contains(x); }))
    return true;
  return is_cleared_since(x, 0);
}

}  // namespace evenload
