#include "cutting/cleared_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Share of the tool's radius: the side of a cell.
constexpr double kCell = 0.12;
// Share of a cell's side: the length along the circle that one look decides.
constexpr double kWindow = 0.4;
// Cells are not made finer than this many in all, so that memory stays bounded for large, sparse
// work.
constexpr double kMaximumCells = 6e6;
// rad: what rounding may move the end of a window by.
constexpr double kWindowMargin = 1e-9;

// Share of the circle's radius: what turning by a small angle may be out by.
constexpr double kDiscMargin = 1e-9;

// mm: from the border of a swept area to a place on it.
constexpr double kOnBorder = 1e-5;
// Of unit vectors along moves that are tangent to each other.
constexpr double kTangent = 1e-3;
// So many moves that follow each other are looked at for being tangent.
constexpr std::size_t kMostInARow = 20;

// A place where the border of a swept area crosses the circle: unit vector from the circle's
// centre.
struct Crossing {
  Vec2 direction;
  double angle = 0;
};

// A few arise per move at most: four circles or two circles and two lines, two crossings each.
struct Crossings {
  std::array<Crossing, 8> at;
  int count = 0;
  void push(Vec2 direction) { at[static_cast<std::size_t>(count++)].direction = direction; }
};

// Removes [low, high] from the ordered set.
void cut(std::vector<AngularInterval>& set, double low, double high) {
  std::size_t keep = 0;
  const std::size_t n = set.size();
  AngularInterval extra;
  bool has_extra = false;
  std::size_t extra_at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const AngularInterval piece = set[i];
    if (high <= piece.low || low >= piece.high) {
      set[keep++] = piece;
    } else {
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
}

// Removes the arc [low, high], given in any turn, from a set that lies within [set_low, set_low + 2
// pi].
void cut_wrapped(std::vector<AngularInterval>& set, double low, double high) {
  if (set.empty()) return;
  const double width = high - low;
  const double base = set.front().low;
  const double start = base + wrap_positive(low - base);
  cut(set, start, start + width);
  if (!set.empty() && start + width > base + 2 * kPi)
    cut(set, start - 2 * kPi, start - 2 * kPi + width);
}

// The least interval that holds what `set` has within [low, high]; of no width where that is
// nothing.
AngularInterval part_within(const std::vector<AngularInterval>& set, double low, double high) {
  AngularInterval part{high, low};
  for (const AngularInterval& piece : set)
    if (piece.low < high && piece.high > low) {
      part.low = std::min(part.low, std::max(piece.low, low));
      part.high = std::max(part.high, std::min(piece.high, high));
    }
  return part.low < part.high ? part : AngularInterval{low, low};
}

bool overlaps(const std::vector<AngularInterval>& set, double low, double high) {
  return part_within(set, low, high).width() > 0;
}

// `v` turned counter-clockwise by the angle of unit vector `turn`.
Vec2 rotated(Vec2 v, Vec2 turn) {
  return {v.x * turn.x - v.y * turn.y, v.x * turn.y + v.y * turn.x};
}

// `v` turned counter-clockwise by a small `angle`; the error is of its fifth order.
Vec2 rotated_little(Vec2 v, double angle) {
  const double square = angle * angle;
  const double c = 1 - square / 2 * (1 - square / 12), s = angle * (1 - square / 6);
  return rotated(v, {c, s});
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
  // The tool's circle reaches a radius beyond its centre.
  const double margin = 1.5 * tool_radius;
  origin_ = bounds.low - Vec2{margin, margin};
  const double width = bounds.high.x - bounds.low.x + 2 * margin;
  const double height = bounds.high.y - bounds.low.y + 2 * margin;
  cell_ = std::max(kCell * tool_radius, std::sqrt(width * height / kMaximumCells));
  half_window_ = 0.5 * kWindow * cell_;
  reach_ = std::sqrt(0.5) * cell_ + 1.01 * half_window_;
  columns_ = static_cast<int>(std::ceil(width / cell_)) + 1;
  rows_ = static_cast<int>(std::ceil(height / cell_)) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  if (material) {
    limited_ = true;
    std::vector<Curve> curves;
    for (const Region& region : *material)
      for (Curve& curve : region.curves()) curves.push_back(std::move(curve));
    std::vector<Bounds> boxes;
    for (const Curve& curve : curves)
      for (const Segment& segment : curve.segments())
        if (segment.open) {
          material_edges_.push_back(segment);
          boxes.push_back(segment.bounds());
        }
    edge_boxes_ = BoxTree(boxes);
    material_ = BoundaryIndex(curves);
  }
}

template <typename Visit>
void ClearedGround::visit_cells(const Primitive& primitive, Visit visit) {
  const double reach = primitive.radius + reach_;
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
  for (int j = j0; j <= j1; ++j) {
    const double y = origin_.y + (j + 0.5) * cell_;
    int first = i0, last = i1;
    if (!s.is_arc() && std::abs(s.b.y - s.a.y) > reach) {
      // A long slanting line: only where it is near the row.
      const double t0 = (y - reach - s.a.y) / (s.b.y - s.a.y);
      const double t1 = (y + reach - s.a.y) / (s.b.y - s.a.y);
      const double xa = s.a.x + std::clamp(t0, 0.0, 1.0) * (s.b.x - s.a.x);
      const double xb = s.a.x + std::clamp(t1, 0.0, 1.0) * (s.b.x - s.a.x);
      first = std::max(
          i0, static_cast<int>(std::floor((std::min(xa, xb) - reach - origin_.x) / cell_)));
      last = std::min(i1,
                      static_cast<int>(std::floor((std::max(xa, xb) + reach - origin_.x) / cell_)));
    }
    for (int i = first; i <= last; ++i)
      visit(cells_[static_cast<std::size_t>(j) * columns_ + i],
            Vec2{origin_.x + (i + 0.5) * cell_, y});
  }
}

void ClearedGround::add(const Segment& move, double swept_radius) {
  EVENLOAD_ASSERT(std::isfinite(move.a.x + move.a.y + move.b.x + move.b.y));
  Primitive primitive;
  primitive.segment = move;
  primitive.radius = swept_radius;
  if (move.is_arc()) {
    const Vec2 start = (move.a - move.centre) / move.radius,
               end = (move.b - move.centre) / move.radius;
    primitive.first = move.sweep > 0 ? start : end;
    primitive.last = move.sweep > 0 ? end : start;
    primitive.reflex = std::abs(move.sweep) > kPi;
  } else {
    primitive.length = evenload::distance(move.a, move.b);
    primitive.direction = primitive.length > 0 ? (move.b - move.a) / primitive.length : Vec2{1, 0};
  }
  const auto id = static_cast<std::int32_t>(primitives_.size());
  primitives_.push_back(primitive);
  visit_cells(primitive, [&](Cell& cell, Vec2 centre) {
    if (cell.covered_by >= 0) return;
    const double far = distance(primitive, centre);
    if (far + reach_ <= swept_radius) {
      cell.covered_by = id;
    } else if (far - reach_ < swept_radius) {
      entries_.push_back({id, cell.newest});
      cell.newest = static_cast<std::int32_t>(entries_.size()) - 1;
    }
  });
}

void ClearedGround::remove_last() {
  EVENLOAD_ASSERT(!primitives_.empty());
  const Primitive primitive = primitives_.back();
  primitives_.pop_back();
  const auto id = static_cast<std::int32_t>(primitives_.size());
  visit_cells(primitive, [&](Cell& cell, Vec2) {
    if (cell.covered_by == id) cell.covered_by = -1;
    if (cell.newest >= 0 && entries_[static_cast<std::size_t>(cell.newest)].move == id)
      cell.newest = entries_[static_cast<std::size_t>(cell.newest)].before;
  });
  while (!entries_.empty() && entries_.back().move == id) entries_.pop_back();
}

const ClearedGround::Cell& ClearedGround::cell_at(Vec2 x) const {
  const int i = static_cast<int>(std::floor((x.x - origin_.x) / cell_));
  const int j = static_cast<int>(std::floor((x.y - origin_.y) / cell_));
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return untouched_;
  return cells_[static_cast<std::size_t>(j) * columns_ + i];
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
  bool covers = false;
  for (int i = 0; i < count; ++i) {
    const Crossing& from = crossings.at[static_cast<std::size_t>(i)];
    const Crossing& to = crossings.at[static_cast<std::size_t>((i + 1) % count)];
    const double high = i + 1 < count ? to.angle : to.angle + 2 * kPi;
    if (high - from.angle < 1e-12) continue;
    const Vec2 middle = count > 1 ? between(from.direction, to.direction) : -from.direction;
    if (distance(primitive, p + radius * middle) > reach) continue;
    cut_wrapped(set, from.angle, high);
    covers = true;
  }
  return covers;
}

// Takes from `set` what the moves swept that matter within `window`. `seen`: moves taken already.
void ClearedGround::subtract_near(const Window& window, Vec2 p, double radius, std::size_t last,
                                  Seen& seen, std::vector<AngularInterval>& set) const {
  const Cell& cell = cell_at(window.middle);
  if (cell.covered_by >= 0 && static_cast<std::size_t>(cell.covered_by) < last) {
    subtract(primitives_[static_cast<std::size_t>(cell.covered_by)], p, radius, set);
    return;
  }
  if (cell.newest < 0) return;
  // A disc that holds what is left of the window.
  AngularInterval part;
  Vec2 middle;
  double half = 0;
  const auto measure = [&] {
    part = part_within(set, window.low, window.high);
    const double aside = 0.5 * (part.low + part.high - window.low - window.high);
    middle = p + rotated_little(window.middle - p, aside);
    half = 0.5 * part.width() * radius + kDiscMargin * radius;
  };
  measure();
  for (std::int32_t at = cell.newest; at >= 0 && part.width() > 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    at = entry.before;
    const auto index = static_cast<std::size_t>(entry.move);
    if (index >= last || seen.moves[index] == seen.look) continue;
    const Primitive& primitive = primitives_[index];
    if (distance(primitive, middle) >= primitive.radius + half) continue;
    seen.moves[index] = seen.look;
    if (subtract(primitive, p, radius, set)) measure();
  }
}

// Looks at the circle window by window, as long as `go_on(window)` says so after each.
template <typename Continue>
void ClearedGround::look_round(Vec2 p, double low, double high, double shrink, std::size_t last,
                               std::vector<AngularInterval>& set, Continue go_on) const {
  thread_local Seen seen;
  ++seen.look;
  if (seen.moves.size() < primitives_.size()) seen.moves.resize(2 * primitives_.size(), 0);
  const double radius = tool_radius_ - shrink;
  set.clear();
  set.push_back({low, high});
  const int n =
      std::max(1, static_cast<int>(std::ceil((high - low) * radius / (2 * half_window_))));
  const double step = (high - low) / n;
  const Vec2 turn = unit(step);
  Vec2 towards = unit(low + 0.5 * step);
  for (int k = 0; k < n && !set.empty(); ++k, towards = rotated(towards, turn)) {
    const Window window{p + radius * towards, low + k * step - kWindowMargin,
                        low + (k + 1) * step + kWindowMargin};
    if (!overlaps(set, window.low, window.high)) continue;
    subtract_near(window, p, radius, last, seen, set);
    if (!go_on(window)) return;
  }
}

void ClearedGround::uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out,
                              double shrink, std::size_t last) const {
  look_round(p, low, high, shrink, last, out, [](const Window&) { return true; });
  if (limited_ && !out.empty()) remove_outside_material(p, tool_radius_ - shrink, out);
}

void ClearedGround::remove_outside_material(Vec2 p, double radius,
                                            std::vector<AngularInterval>& set) const {
  std::vector<double> breaks;
  edge_boxes_.visit({p - Vec2{radius, radius}, p + Vec2{radius, radius}}, [&](std::uint32_t edge) {
    const Segment& s = material_edges_[edge];
    if (s.distance_to(p) > radius) return;
    const auto keep = [&](double angle) {
      if (s.distance_to(p + radius * unit(angle)) < 1e-7) breaks.push_back(wrap_positive(angle));
    };
    if (s.is_arc()) {
      const Vec2 v = s.centre - p;
      const double d = norm(v);
      if (d < 1e-12) return;
      const double c = (d * d + radius * radius - s.radius * s.radius) / (2 * d * radius);
      if (std::abs(c) >= 1) return;
      keep(angle_of(v) - std::acos(c));
      keep(angle_of(v) + std::acos(c));
    } else {
      const Vec2 direction = normalized(s.b - s.a);
      const double v = -cross(direction, p - s.a) / radius;
      if (std::abs(v) >= 1) return;
      keep(angle_of(direction) + std::asin(v));
      keep(angle_of(direction) + kPi - std::asin(v));
    }
  });
  std::sort(breaks.begin(), breaks.end());
  if (breaks.empty()) {
    const AngularInterval& piece = set.front();
    if (!material_.contains(p + radius * unit(0.5 * (piece.low + piece.high)))) set.clear();
    return;
  }
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const double low = breaks[i];
    const double high = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + 2 * kPi;
    if (high - low > 1e-12 && !material_.contains(p + radius * unit(0.5 * (low + high))))
      cut_wrapped(set, low, high);
  }
}

bool ClearedGround::is_clear(Vec2 p, double shrink) const {
  thread_local std::vector<AngularInterval> scratch;
  // What is outside the material can be told only in the end.
  const auto go_on = [&](const Window& window) {
    return limited_ || !overlaps(scratch, window.low, window.high);
  };
  look_round(p, 0, 2 * kPi, shrink, primitives_.size(), scratch, go_on);
  if (limited_ && !scratch.empty()) remove_outside_material(p, tool_radius_ - shrink, scratch);
  return scratch.empty();
}

bool ClearedGround::is_cleared_since(Vec2 x, std::size_t first) const {
  const Cell& cell = cell_at(x);
  if (cell.covered_by >= 0 && static_cast<std::size_t>(cell.covered_by) >= first) return true;
  for (std::int32_t at = cell.newest; at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    if (static_cast<std::size_t>(entry.move) < first) return false;
    const Primitive& primitive = primitives_[static_cast<std::size_t>(entry.move)];
    if (distance(primitive, x) <= primitive.radius) return true;
    at = entry.before;
  }
  return false;
}

std::optional<std::size_t> ClearedGround::move_bordering(Vec2 x) const {
  for (std::int32_t at = cell_at(x).newest; at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    at = entry.before;
    const auto index = static_cast<std::size_t>(entry.move);
    if (std::abs(distance(primitives_[index], x) - primitives_[index].radius) < kOnBorder)
      return index;
  }
  return std::nullopt;
}

// True when the moves from `first` to `last` are few, and each is tangent to the next.
bool ClearedGround::runs_on(std::size_t first, std::size_t last) const {
  if (last - first > kMostInARow) return false;
  for (std::size_t i = first; i < last; ++i) {
    const Segment &a = primitives_[i].segment, &b = primitives_[i + 1].segment;
    if (evenload::distance(a.b, b.a) > kOnBorder || norm(a.tangent(1) - b.tangent(0)) > kTangent)
      return false;
  }
  return true;
}

bool ClearedGround::is_smooth_between(Vec2 a, Vec2 b) const {
  const std::optional<std::size_t> at_a = move_bordering(a), at_b = move_bordering(b);
  if (at_a && at_b) return runs_on(std::min(*at_a, *at_b), std::max(*at_a, *at_b));
  if (at_a || at_b || !limited_) return false;
  const BoundaryIndex::Hit edge_a = material_.nearest(a), edge_b = material_.nearest(b);
  return edge_a.curve == edge_b.curve && edge_a.segment == edge_b.segment;
}

bool ClearedGround::is_cleared_point(Vec2 x) const {
  return is_cleared_since(x, 0) || (limited_ && !material_.contains(x));
}

}  // namespace evenload
