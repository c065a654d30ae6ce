#include "cutting/cleared_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Share of the tool's radius: the side of a cell.
constexpr double kCell = 0.18;
// Share of a cell's side: the length along the circle that one look decides.
constexpr double kWindow = 0.8;
// Cells are not made finer than this many in all, so that memory stays bounded for large, sparse
// work.
constexpr double kMaximumCells = 6e6;
// Moves: shorter lists are not worth thinning; nor are those that have not grown so many times.
constexpr std::int32_t kLongList = 32;
constexpr double kLongGrowth = 2;
// The same of moves that stay.
constexpr std::int32_t kSettledList = 24;
constexpr double kSettledGrowth = 1.3;
// rad: what rounding may move the end of a window by.
constexpr double kWindowMargin = 1e-9;

// rad: how far from half a turn rounding may bring it.
constexpr double kHalfTurn = 1e-12;
// Share of the circle's radius: what turning by a small angle may be out by.
constexpr double kDiscMargin = 1e-9;

// Between two places on a circle the distance from a move that sweeps no smaller disc falls below
// that of both by at most this, over the circle's radius, times the square of half the way: along
// the circle the distance from any place of the move that is a radius away or more is bent by no
// more than twice the circle's curvature; a tenth is for places hardly nearer than that.
constexpr double kMostDip = 1.1;

// mm: from the border of a swept area to a place on it.
constexpr double kOnBorder = 1e-5;
// Of unit vectors along moves that are tangent to each other.
constexpr double kTangent = 1e-3;
// So many moves that follow each other are looked at for being tangent.
constexpr std::size_t kMostInARow = 20;

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
  cells_per_mm_ = 1 / cell_;
  half_window_ = 0.5 * kWindow * cell_;
  reach_ = std::sqrt(0.5) * cell_ + 1.01 * half_window_;
  half_circle_windows_ = windows_in(kPi, tool_radius);
  half_circle_turn_ = unit(kPi / half_circle_windows_);
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

// Into how many windows an arc of `angle` rad is divided.
int ClearedGround::windows_in(double angle, double radius) const {
  return std::max(1, static_cast<int>(std::ceil(angle * radius / (2 * half_window_))));
}

template <typename Visit>
void ClearedGround::visit_cells(const SweptMove& swept, Visit visit) {
  const double reach = swept.swept_radius() + reach_;
  const Segment& s = swept.segment();
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
  const auto column = [&](double x) {
    return static_cast<int>(std::floor((x - origin_.x) / cell_));
  };
  const auto row = [&](double y) { return static_cast<int>(std::floor((y - origin_.y) / cell_)); };
  const int j0 = std::max(0, row(low.y - reach)), j1 = std::min(rows_ - 1, row(high.y + reach));
  for (int j = j0; j <= j1; ++j) {
    const double y = origin_.y + (j + 0.5) * cell_;
    // What lies within reach of the move's box has rounded corners.
    const double beyond = std::max({0.0, low.y - y, y - high.y});
    const double aside = std::sqrt(std::max(0.0, reach * reach - beyond * beyond));
    double from = low.x, to = high.x;
    if (!s.is_arc() && std::abs(s.b.y - s.a.y) > reach) {
      // A long slanting line: only where it is near the row.
      const auto at = [&](double height) {
        return s.a.x + std::clamp((height - s.a.y) / (s.b.y - s.a.y), 0.0, 1.0) * (s.b.x - s.a.x);
      };
      std::tie(from, to) = std::minmax({at(y - reach), at(y + reach)});
    }
    const int first = std::max(0, column(from - aside)),
              last = std::min(columns_ - 1, column(to + aside));
    for (int i = first; i <= last; ++i)
      visit(cells_[static_cast<std::size_t>(j) * columns_ + i],
            Vec2{origin_.x + (i + 0.5) * cell_, y});
  }
}

void ClearedGround::add(const Segment& move, double swept_radius) {
  EVENLOAD_ASSERT(std::isfinite(move.a.x + move.a.y + move.b.x + move.b.y));
  count_look();
  const SweptMove swept(move, swept_radius);
  moves_.push_back(swept);
  marks_.push_back({entries_.size(), thinnings_.size()});
  spread(swept);
}

void ClearedGround::spread(const SweptMove& part) {
  const SweptMove whole = moves_.back();
  const auto id = static_cast<std::int32_t>(moves_.size()) - 1;
  const double radius = whole.swept_radius();
  visit_cells(part, [&](Cell& cell, Vec2 centre) {
    if (cell.covered_by >= 0) return;
    if (!part.is_within(centre, radius + reach_)) return;
    if (radius > reach_ && whole.is_within(centre, radius - reach_)) {
      cell.covered_by = id;
    } else if (cell.newest < 0 || entries_[static_cast<std::size_t>(cell.newest)].move != id) {
      list(cell, id);
      if (is_long(cell, kLongList, kLongGrowth)) thin(cell, centre);
    }
  });
}

void ClearedGround::extend_last(const Segment& longer, const Segment& more) {
  EVENLOAD_ASSERT(moves_.size() > settled_);
  const double radius = moves_.back().swept_radius();
  moves_.back() = SweptMove(longer, radius);
  spread(SweptMove(more, radius));
}

void ClearedGround::list(Cell& cell, std::int32_t move) {
  const std::int32_t length =
      cell.newest >= 0 ? entries_[static_cast<std::size_t>(cell.newest)].length : 0;
  has_long_list_ |= length + 1 >= kSettledList;
  entries_.push_back({move, cell.newest, length + 1});
  cell.newest = static_cast<std::int32_t>(entries_.size()) - 1;
}

// Whether a list has `least` moves or more, and `growth` times as many as when it was thinned last.
bool ClearedGround::is_long(const Cell& cell, std::int32_t least, double growth) const {
  if (cell.newest < 0) return false;
  const std::int32_t length = entries_[static_cast<std::size_t>(cell.newest)].length;
  if (length < least) return false;
  return cell.thinning < 0 ||
         length >= growth * thinnings_[static_cast<std::size_t>(cell.thinning)].length;
}

void ClearedGround::thin(Cell& cell, Vec2 centre) {
  struct Kept {
    std::int32_t move;
    BorderView view;
  };
  thread_local std::vector<Kept> kept;
  kept.clear();
  for (std::int32_t at = cell.newest; at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    at = entry.before;
    const BorderView view = moves_[static_cast<std::size_t>(entry.move)].seen_from(centre);
    const auto hides_it = [&](const Kept& newer) { return hides(newer.view, view, reach_); };
    if (std::none_of(kept.begin(), kept.end(), hides_it)) kept.push_back({entry.move, view});
  }
  thinnings_.push_back(
      {kept.front().move, cell.newest, static_cast<std::int32_t>(kept.size()), cell.thinning});
  cell.thinning = static_cast<std::int32_t>(thinnings_.size()) - 1;
  cell.newest = -1;
  for (auto k = kept.rbegin(); k != kept.rend(); ++k) list(cell, k->move);
}

void ClearedGround::settle(std::size_t first) {
  for (std::size_t i = first; has_long_list_ && i < moves_.size(); ++i) {
    const SweptMove swept = moves_[i];
    visit_cells(swept, [&](Cell& cell, Vec2 centre) {
      if (cell.covered_by < 0 && is_long(cell, kSettledList, kSettledGrowth)) thin(cell, centre);
    });
  }
  settled_ = moves_.size();
  has_long_list_ = false;
}

void ClearedGround::remove_last() {
  EVENLOAD_ASSERT(moves_.size() > settled_);
  count_look();
  const SweptMove swept = moves_.back();
  moves_.pop_back();
  const auto id = static_cast<std::int32_t>(moves_.size());
  visit_cells(swept, [&](Cell& cell, Vec2) {
    if (cell.covered_by == id) cell.covered_by = -1;
    if (cell.thinning >= 0 && thinnings_[static_cast<std::size_t>(cell.thinning)].move == id) {
      const Thinning& thinning = thinnings_[static_cast<std::size_t>(cell.thinning)];
      cell.newest = thinning.newest;
      cell.thinning = thinning.earlier;
    }
    if (cell.newest >= 0 && entries_[static_cast<std::size_t>(cell.newest)].move == id)
      cell.newest = entries_[static_cast<std::size_t>(cell.newest)].before;
  });
  entries_.resize(marks_.back().entries);
  thinnings_.resize(marks_.back().thinnings);
  marks_.pop_back();
}

const ClearedGround::Cell& ClearedGround::cell_at(Vec2 x) const {
  return cell_at_grid(cells_per_mm_ * (x - origin_));
}

// `at`: in cells from the grid's corner.
const ClearedGround::Cell& ClearedGround::cell_at_grid(Vec2 at) const {
  if (!(at.x >= 0 && at.y >= 0 && at.x < columns_ && at.y < rows_)) return untouched_;
  const int i = static_cast<int>(at.x), j = static_cast<int>(at.y);
  return cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(i)];
}

// Where a list begins that holds what counts of the moves before `last`.
std::int32_t ClearedGround::newest_before(const Cell& cell, std::size_t last) const {
  std::int32_t newest = cell.newest;
  for (std::int32_t at = cell.thinning; at >= 0;) {
    const Thinning& thinning = thinnings_[static_cast<std::size_t>(at)];
    if (static_cast<std::size_t>(thinning.move) < last) break;
    newest = thinning.newest;
    at = thinning.earlier;
  }
  return newest;
}

// Takes from `set` what the moves swept that matter within `window`, of which `part` is left.
// `seen`: moves taken already.
void ClearedGround::subtract_near(const Window& window, const Cell& cell, const CircleLook& look,
                                  AngularInterval part, Seen& seen,
                                  std::vector<AngularInterval>& set) const {
  const std::int32_t newest = newest_before(cell, look.last);
  if (newest < 0) return;
  // What is left of the window, and a disc that holds it.
  Vec2 middle, low_end, high_end;
  double half = 0;
  bool has_ends = false;
  const double window_middle = 0.5 * (window.low + window.high);
  const Vec2 spoke = window.middle - look.p;
  const auto at_angle = [&](double angle) {
    return look.p + rotated_little(spoke, angle - window_middle);
  };
  const auto measure = [&] {
    middle = at_angle(0.5 * (part.low + part.high));
    half = (0.5 * part.width() + kDiscMargin) * look.radius;
    has_ends = false;
  };
  measure();
  for (std::int32_t at = newest; at >= 0 && part.width() > 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    at = entry.before;
    const auto index = static_cast<std::size_t>(entry.move);
    if (index >= look.last || seen.moves[index] == seen.look) continue;
    const SweptMove& swept = moves_[index];
    if (!swept.is_within(middle, swept.swept_radius() + half)) continue;
    if (swept.swept_radius() >= look.radius) {
      if (!has_ends) {
        low_end = at_angle(part.low);
        high_end = at_angle(part.high);
        has_ends = true;
      }
      const double dip = kMostDip / look.radius * half * half + kDiscMargin * look.radius;
      const double reach = swept.swept_radius() + dip;
      if (!swept.is_within(low_end, reach) && !swept.is_within(high_end, reach)) continue;
    }
    seen.moves[index] = seen.look;
    if (!swept.subtract(look, set)) continue;
    part = part_within(set, window.low, window.high);
    measure();
  }
}

// Looks at the circle window by window, as long as `go_on(window)` says so after each.
template <typename Continue>
void ClearedGround::look_round(Vec2 p, double low, double high, double shrink, std::size_t last,
                               std::vector<AngularInterval>& set, Continue go_on) const {
  count_look();
  thread_local Seen seen;
  ++seen.look;
  if (seen.moves.size() < moves_.size()) seen.moves.resize(2 * moves_.size(), 0);
  const double radius = tool_radius_ - shrink;
  const CircleLook look{p, radius, low, last};
  set.clear();
  set.push_back({low, high});
  const int n = windows_in(high - low, radius);
  const double step = (high - low) / n;
  const bool half_circle = n == half_circle_windows_ && std::abs(high - low - kPi) < kHalfTurn;
  const Vec2 turn = half_circle ? half_circle_turn_ : unit(step);
  Vec2 towards = unit(low + 0.5 * step);
  // Most windows are covered as a whole, or nothing has been cut there: these need no more than
  // their cell.
  const Vec2 centre = cells_per_mm_ * (p - origin_);
  const double spoke = cells_per_mm_ * radius;
  int first_covered = n;  // of those side by side, which are cut at once
  const auto cut_covered = [&](int end) {
    if (first_covered >= end) return;
    cut_wrapped(set, low, std::max(low + first_covered * step - kWindowMargin, low),
                std::min(low + end * step + kWindowMargin, low + 2 * kPi));
    first_covered = n;
  };
  // One move often takes all the rest of the circle: windows beyond what is left are not looked at.
  int end = n;
  for (int k = 0; k < end; ++k, towards = rotated(towards, turn)) {
    const Cell& cell = cell_at_grid(centre + spoke * towards);
    if (cell.covered_by >= 0 && static_cast<std::size_t>(cell.covered_by) < last) {
      first_covered = std::min(first_covered, k);
      continue;
    }
    cut_covered(k);
    if (set.empty()) return;
    const Window window{p + radius * towards, low + k * step - kWindowMargin,
                        low + (k + 1) * step + kWindowMargin};
    if (cell.newest >= 0) {
      const AngularInterval part = part_within(set, window.low, window.high);
      if (part.width() <= 0) continue;
      const double highest = set.back().high;
      subtract_near(window, cell, look, part, seen, set);
      if (set.empty()) return;
      if (set.back().high < highest)
        end = std::min(n, static_cast<int>((set.back().high - low + kWindowMargin) / step) + 1);
    }
    if (!go_on(window)) return;
  }
  cut_covered(end);
}

void ClearedGround::uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out,
                              double shrink, std::size_t last) const {
  look_round(p, low, high, shrink, last, out, [](const Window&) { return true; });
  if (limited_ && !out.empty()) remove_outside_material(p, low, tool_radius_ - shrink, out);
}

void ClearedGround::remove_outside_material(Vec2 p, double base, double radius,
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
      cut_wrapped(set, base, low, high);
  }
}

bool ClearedGround::is_clear(Vec2 p, double shrink) const {
  thread_local std::vector<AngularInterval> scratch;
  // What is outside the material can be told only in the end.
  const auto go_on = [&](const Window& window) {
    return limited_ || !overlaps(scratch, window.low, window.high);
  };
  look_round(p, 0, 2 * kPi, shrink, moves_.size(), scratch, go_on);
  if (limited_ && !scratch.empty()) remove_outside_material(p, 0, tool_radius_ - shrink, scratch);
  return scratch.empty();
}

bool ClearedGround::is_cleared_since(Vec2 x, std::size_t first) const {
  const Cell& cell = cell_at(x);
  if (cell.covered_by >= 0 && static_cast<std::size_t>(cell.covered_by) >= first) return true;
  for (std::int32_t at = cell.newest; at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    if (static_cast<std::size_t>(entry.move) < first) return false;
    const SweptMove& swept = moves_[static_cast<std::size_t>(entry.move)];
    if (swept.distance(x) <= swept.swept_radius()) return true;
    at = entry.before;
  }
  return false;
}

std::optional<ClearedGround::BorderPlace> ClearedGround::place_bordering(Vec2 x,
                                                                         std::size_t last) const {
  const Cell& cell = cell_at(x);
  for (std::int32_t at = newest_before(cell, last); at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    at = entry.before;
    const auto index = static_cast<std::size_t>(entry.move);
    if (index >= last) continue;
    if (std::abs(moves_[index].distance(x) - moves_[index].swept_radius()) >= kOnBorder) continue;
    const Segment& s = moves_[index].segment();
    const double t = s.nearest(x);
    return BorderPlace{index, t, cross(s.tangent(t), x - s.point(t)) > 0 ? 1.0 : -1.0};
  }
  return std::nullopt;
}

// True when the moves from one place to a later one are few, each is tangent to the next, and they
// turn by no more than `most_turn` rad; none turns towards a side on which the border is looked at
// more tightly than the disc is round: there the border has a cusp.
bool ClearedGround::runs_on(const BorderPlace& first, const BorderPlace& last,
                            double most_turn) const {
  if (last.move - first.move > kMostInARow) return false;
  double turn = 0;
  for (std::size_t i = first.move; i <= last.move; ++i) {
    const Segment& a = moves_[i].segment();
    for (const double side : {first.side, last.side})
      if (a.is_arc() && a.sweep * side > kTangent && a.radius < moves_[i].swept_radius())
        return false;
    const double from = i == first.move ? first.t : 0, to = i == last.move ? last.t : 1;
    turn += std::abs(a.sweep) * std::abs(to - from);
    if (turn > most_turn) return false;
    if (i == last.move) break;
    const Segment& b = moves_[i + 1].segment();
    if (evenload::distance(a.b, b.a) > kOnBorder || norm(a.tangent(1) - b.tangent(0)) > kTangent)
      return false;
  }
  return true;
}

bool ClearedGround::is_smooth_between(Vec2 a, Vec2 b, std::size_t last, double most_turn) const {
  const std::optional<BorderPlace> at_a = place_bordering(a, last), at_b = place_bordering(b, last);
  if (at_a && at_b)
    return at_a->move <= at_b->move ? runs_on(*at_a, *at_b, most_turn)
                                    : runs_on(*at_b, *at_a, most_turn);
  if (at_a || at_b || !limited_) return false;
  const BoundaryIndex::Hit edge_a = material_.nearest(a), edge_b = material_.nearest(b);
  return edge_a.curve == edge_b.curve && edge_a.segment == edge_b.segment;
}

bool ClearedGround::is_cleared_point(Vec2 x) const {
  return is_cleared_since(x, 0) || (limited_ && !material_.contains(x));
}

bool ClearedGround::is_cleared_around(Vec2 x, double margin) const {
  const auto covers = [&](std::int32_t move) {
    const SweptMove& swept = moves_[static_cast<std::size_t>(move)];
    return swept.distance(x) <= swept.swept_radius() - margin;
  };
  const Cell& cell = cell_at(x);
  if (cell.covered_by >= 0 && covers(cell.covered_by)) return true;
  for (std::int32_t at = cell.newest; at >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(at)];
    if (covers(entry.move)) return true;
    at = entry.before;
  }
  return limited_ && !material_.contains(x) && material_.distance_below(x, margin) >= margin;
}

}  // namespace evenload
