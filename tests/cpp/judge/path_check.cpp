#include "judge/path_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace evenload::path_check {
namespace {

// mm, of chords in place of the walls' arcs.
constexpr double kFlat = 1e-5;
// mm: heights this near are one.
constexpr double kSameHeight = 1e-6;
// mm, of the grid of cleared ground.
constexpr double kClearedCell = 0.125;
// rad: less engagement than this is not contact.
constexpr double kContact = kPi / 180;
// Halvings of the gap between two points of the half circle.
constexpr int kBisections = 6;
// rad: arcs are looked at at least once in this much of a turn.
constexpr double kTurn = kPi / 30;
constexpr double kKink = kPi / 180;

double distance_to_line(Vec2 q, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double square = squared_norm(d);
  const double t = square > 0 ? std::clamp(dot(q - a, d) / square, 0.0, 1.0) : 0;
  return distance(q, a + t * d);
}

// A line, or an arc of at most a quarter turn.
struct Piece {
  Vec2 a, b;
  bool arc = false;
  Vec2 centre;
  double radius = 0, start = 0, sweep = 0;

  double length() const { return arc ? std::abs(sweep) * radius : distance(a, b); }
  Vec2 point(double t) const {
    return arc ? centre + radius * unit(start + t * sweep) : a + t * (b - a);
  }
  Vec2 direction(double t) const {
    if (!arc) return normalized(b - a);
    return (sweep > 0 ? 1.0 : -1.0) * left_normal(unit(start + t * sweep));
  }
  double distance_to(Vec2 q) const {
    if (!arc) return distance_to_line(q, a, b);
    const Vec2 v = q - centre;
    const double side = sweep > 0 ? 1 : -1;
    if (side * cross(a - centre, v) >= 0 && side * cross(v, b - centre) >= 0 &&
        dot(v, (a - centre) + (b - centre)) >= 0)
      return std::abs(norm(v) - radius);
    return std::min(distance(q, a), distance(q, b));
  }
  // What has been gone of it at `t`.
  Piece until(double t) const {
    Piece part = *this;
    part.b = point(t);
    part.sweep = t * sweep;
    return part;
  }
};

std::vector<Piece> pieces_of(Vec2 from, const Move& move) {
  std::vector<Piece> result;
  const Vec2 to{move.x, move.y};
  if (move.sweep == 0) {
    if (distance(from, to) > 1e-9) {
      Piece piece;
      piece.a = from;
      piece.b = to;
      result.push_back(piece);
    }
    return result;
  }
  const Vec2 centre{move.cx, move.cy};
  const int n = std::max(1, static_cast<int>(std::ceil(std::abs(move.sweep) / (kPi / 2) - 1e-9)));
  for (int i = 0; i < n; ++i) {
    Piece piece;
    piece.arc = true;
    piece.centre = centre;
    piece.radius = distance(from, centre);
    piece.sweep = move.sweep / n;
    piece.start = angle_of(from - centre) + i * piece.sweep;
    piece.a = piece.point(0);
    piece.b = piece.point(1);
    if (piece.length() > 1e-9) result.push_back(piece);
  }
  return result;
}

Bounds bounds_of_points(const std::vector<Vec2>& points) {
  Bounds box{points.front(), points.front()};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

struct Grid {
  Vec2 origin;
  double cell = 1;
  int columns = 0, rows = 0;

  Grid(Bounds box, double cell_size) : origin(box.low), cell(cell_size) {
    columns = static_cast<int>((box.high.x - box.low.x) / cell) + 1;
    rows = static_cast<int>((box.high.y - box.low.y) / cell) + 1;
  }
  std::size_t size() const { return static_cast<std::size_t>(columns) * rows; }
  int column(double x) const {
    return std::clamp(static_cast<int>((x - origin.x) / cell), 0, columns - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>((y - origin.y) / cell), 0, rows - 1);
  }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * columns + i; }
  std::size_t at(Vec2 p) const { return index(column(p.x), row(p.y)); }
  Vec2 middle(int i, int j) const {
    return {origin.x + (i + 0.5) * cell, origin.y + (j + 0.5) * cell};
  }
  double half_diagonal() const { return cell * 0.70711; }
};

struct Edge {
  Vec2 a, b;
};

// Even-odd test on closed polygons.
class Inside {
 public:
  Inside(const std::vector<Edge>& edges, Bounds box) : edges_(edges), rows_(box, 0.25) {
    buckets_.resize(rows_.rows);
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (int j = rows_.row(std::min(edges_[k].a.y, edges_[k].b.y));
           j <= rows_.row(std::max(edges_[k].a.y, edges_[k].b.y)); ++j)
        buckets_[j].push_back(k);
  }
  bool operator()(Vec2 p) const {
    bool inside = false;
    for (const std::size_t k : buckets_[rows_.row(p.y)]) {
      const Edge& e = edges_[k];
      if ((e.a.y > p.y) != (e.b.y > p.y) &&
          p.x < e.a.x + (e.b.x - e.a.x) * (p.y - e.a.y) / (e.b.y - e.a.y))
        inside = !inside;
    }
    return inside;
  }

 private:
  std::vector<Edge> edges_;
  Grid rows_;
  std::vector<std::vector<std::size_t>> buckets_;
};

// Distance to the walls where it is below a limit.
class Walls {
 public:
  Walls(const std::vector<Edge>& edges, Bounds box, double limit)
      : edges_(edges), grid_(box, 1.0), limit_(limit), buckets_(grid_.size()) {
    const double reach = limit + grid_.half_diagonal();
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Edge& e = edges_[k];
      for (int j = grid_.row(std::min(e.a.y, e.b.y) - reach);
           j <= grid_.row(std::max(e.a.y, e.b.y) + reach); ++j)
        for (int i = grid_.column(std::min(e.a.x, e.b.x) - reach);
             i <= grid_.column(std::max(e.a.x, e.b.x) + reach); ++i)
          if (distance_to_line(grid_.middle(i, j), e.a, e.b) <= reach)
            buckets_[grid_.index(i, j)].push_back(k);
    }
  }
  double distance_below_limit(Vec2 p) const {
    double best = limit_;
    for (const std::size_t k : buckets_[grid_.at(p)])
      best = std::min(best, distance_to_line(p, edges_[k].a, edges_[k].b));
    return best;
  }

 private:
  std::vector<Edge> edges_;
  Grid grid_;
  double limit_;
  std::vector<std::vector<std::size_t>> buckets_;
};

// What the tool has cleared so far. A cell that one piece covers whole forgets the others.
class Cleared {
 public:
  Cleared(Bounds box, double radius)
      : grid_(box, kClearedCell),
        radius_(radius),
        whole_(grid_.size(), kNone),
        part_(grid_.size()) {}

  void add(const Piece& piece) {
    const auto id = static_cast<std::int32_t>(pieces_.size());
    pieces_.push_back(piece);
    const Bounds box = bounds_of_points({piece.a, piece.b, piece.point(0.5)});
    // An arc of a quarter turn leaves the box of these points by less than this.
    const double margin = radius_ + (piece.arc ? 0.3 * piece.length() : 0) + grid_.cell;
    for (int j = grid_.row(box.low.y - margin); j <= grid_.row(box.high.y + margin); ++j)
      for (int i = grid_.column(box.low.x - margin); i <= grid_.column(box.high.x + margin); ++i) {
        const std::size_t c = grid_.index(i, j);
        if (whole_[c] != kNone) continue;
        const double d = piece.distance_to(grid_.middle(i, j));
        if (d <= radius_ - grid_.half_diagonal()) {
          whole_[c] = id;
          part_[c] = {};
        } else if (d <= radius_ + grid_.half_diagonal()) {
          part_[c].push_back(id);
        }
      }
  }
  bool contains(Vec2 p) const { return depth(p) >= 0; }
  // mm: a piece has cleared all that lies nearer to the point than this. Negative where the point
  // is not cleared.
  double depth(Vec2 p) const {
    const std::size_t c = grid_.at(p);
    if (whole_[c] != kNone) return std::max(0.0, radius_ - pieces_[whole_[c]].distance_to(p));
    for (auto id = part_[c].rbegin(); id != part_[c].rend(); ++id) {
      const double d = pieces_[*id].distance_to(p);
      if (d <= radius_) return radius_ - d;
    }
    return -1;
  }

 private:
  static constexpr std::int32_t kNone = -1;

  Grid grid_;
  double radius_;
  std::vector<std::int32_t> whole_;  // the piece
  std::vector<std::vector<std::int32_t>> part_;
  std::vector<Piece> pieces_;
};

// The largest mean over a window that moves along a run of samples.
class WindowMean {
 public:
  explicit WindowMean(double window) : window_(window) {}
  void restart() {
    until_ = {0};
    sum_ = {0};
    first_ = 0;
  }
  // Answers the mean over the window that ends here; shorter runs count as if nothing was met
  // before them.
  double add(double length, double value) {
    until_.push_back(until_.back() + length);
    sum_.push_back(sum_.back() + length * value);
    const double from = until_.back() - window_;
    if (from <= 0) return sum_.back() / window_;
    while (until_[first_ + 1] <= from) ++first_;
    const double share = (from - until_[first_]) / (until_[first_ + 1] - until_[first_]);
    const double before = sum_[first_] + share * (sum_[first_ + 1] - sum_[first_]);
    return (sum_.back() - before) / window_;
  }

 private:
  double window_;
  std::vector<double> until_{0}, sum_{0};
  std::size_t first_ = 0;
};

class Check {
 public:
  Check(const Stock& stock, double radius, const std::vector<Move>& moves, const Settings& settings)
      : stock_(stock),
        radius_(radius),
        moves_(moves),
        settings_(settings),
        wall_edges_(edges(false)),
        open_edges_(edges(true)),
        box_(whole_box()),
        in_walls_(wall_edges_, box_),
        in_open_(open_edges_, box_),
        walls_(wall_edges_, box_, radius + kDeepest),
        cleared_(box_, radius),
        half_circle_(half_circle(settings.angle)),
        engagement_(settings.window),
        rate_(settings.window) {}

  Findings run() {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Move& move : moves_) lowest = std::min(lowest, move.z);
    for (std::size_t i = 1; i < moves_.size(); ++i) {
      check_arc(moves_[i - 1], moves_[i]);
      go(moves_[i - 1], moves_[i], lowest);
    }
    look_for_leftovers();
    return found_;
  }

 private:
  static bool is_open(const Curve& curve) {
    return std::all_of(curve.vertices().begin(), curve.vertices().end(),
                       [](const Vertex& v) { return v.open; });
  }
  std::vector<Edge> edges(bool open) const {
    std::vector<Edge> result;
    for (const Region& region : stock_.regions)
      for (const Curve& curve : region.curves()) {
        if (is_open(curve) != open) continue;
        const std::vector<Vec2> points = curve.flattened(kFlat);
        for (std::size_t k = 0; k < points.size(); ++k)
          result.push_back({points[k], points[(k + 1) % points.size()]});
      }
    return result;
  }
  Bounds whole_box() const {
    std::vector<Vec2> points;
    for (const Edge& e : wall_edges_) points.push_back(e.a);
    for (const Edge& e : open_edges_) points.push_back(e.a);
    Vec2 from{moves_.front().x, moves_.front().y};
    for (const Move& move : moves_) {
      points.push_back({move.x, move.y});
      for (const Piece& piece : pieces_of(from, move))
        for (const double t : {0.25, 0.5, 0.75}) points.push_back(piece.point(t));
      from = {move.x, move.y};
    }
    Bounds box = bounds_of_points(points);
    const double margin = 2 * radius_;
    return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
  }

  // Where the tool may be as far as walls are concerned. Where the outer boundary is open the
  // islands alone are walls.
  bool within_walls(Vec2 p) const { return open_edges_.empty() ? in_walls_(p) : !in_walls_(p); }
  bool holds_material(Vec2 p) const {
    if (stock_.hole && distance(p, *stock_.hole) <= stock_.hole_radius) return false;
    if (!open_edges_.empty() && !in_open_(p)) return false;
    return !cleared_.contains(p);
  }

  void check_arc(const Move& from, const Move& to) {
    if (to.sweep == 0) return;
    const Vec2 centre{to.cx, to.cy};
    const Vec2 leads_to = centre + rotated(Vec2{from.x, from.y} - centre, to.sweep);
    found_.arc_mismatch = std::max(found_.arc_mismatch, distance(leads_to, {to.x, to.y}));
    found_.largest_sweep = std::max(found_.largest_sweep, std::abs(to.sweep));
  }

  void look_for_gouge(Vec2 p) {
    const double d = walls_.distance_below_limit(p);
    const double depth = within_walls(p) ? radius_ - d : radius_ + d;
    if (depth > found_.gouge) {
      found_.gouge = depth;
      found_.gouge_at = p;
    }
  }

  void go(const Move& from, const Move& to, double lowest) {
    const Vec2 a{from.x, from.y};
    const bool at_floor = to.z <= lowest + kSameHeight;
    const bool level = std::abs(from.z - to.z) <= kSameHeight;
    const std::vector<Piece> pieces = pieces_of(a, to);
    if (std::min(from.z, to.z) < stock_.top - kSameHeight) {
      look_for_gouge({to.x, to.y});
      for (const Piece& piece : pieces) {
        const int n = looks(piece);
        for (int k = 0; k < n; ++k) look_for_gouge(piece.point((k + 0.5) / n));
      }
    }
    if (pieces.empty()) {
      if (at_floor && !level) plunge(a);
      if (!level) break_off();
      return;
    }
    if (to.kind == MoveKind::kRapid && std::min(from.z, to.z) < stock_.top - kSameHeight)
      for (const Piece& piece : pieces)
        for (int k = 0; k < looks(piece); ++k) plunge(piece.point((k + 0.5) / looks(piece)));
    if (!at_floor || !level) {
      break_off();
      return;
    }
    if (to.kind == MoveKind::kCut || to.kind == MoveKind::kLink) {
      walk(pieces, to);
      return;
    }
    break_off();
    for (const Piece& piece : pieces) cleared_.add(piece);
  }

  int looks(const Piece& piece) const {
    return std::max(1, static_cast<int>(std::ceil(std::max(piece.length() / settings_.step,
                                                           std::abs(piece.sweep) / kTurn))));
  }

  void bad_plunge(Vec2 p) {
    ++found_.bad_plunges;
    found_.bad_plunge_at = p;
  }

  void plunge(Vec2 p) {
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 0.97})
      for (int k = 0; k < 48; ++k)
        if (holds_material(p + share * radius_ * unit(k * kPi / 24))) {
          bad_plunge(p);
          return;
        }
  }

  void break_off() {
    kind_ = MoveKind::kRapid;
    has_heading_ = false;
  }

  void walk(const std::vector<Piece>& pieces, const Move& move) {
    const bool cut = move.kind == MoveKind::kCut;
    if (move.kind != kind_) {
      engagement_.restart();
      rate_.restart();
      kind_ = move.kind;
      if (!cut) has_heading_ = false;
    }
    bool first = true;
    for (const Piece& piece : pieces) {
      const int n = looks(piece);
      const double length = piece.length() / n;
      for (int k = 0; k < n; ++k) {
        const double t = (k + 0.5) / n;
        const Load load = load_at(piece, t);
        note(load, piece.point(t), length, move, cut);
        if (first && cut && has_heading_) look_for_kink(piece, load.angle);
        first = false;
        last_engagement_ = load.angle;
      }
      cleared_.add(piece);
      heading_ = piece.direction(1);
      has_heading_ = cut;
    }
  }

  struct Load {
    double angle = 0;  // rad
    double width = 0;  // mm
    double right = 0;  // share of the width on the right less that on the left
  };

  // The points at which a half circle about x is looked at, from the right to the left.
  static std::vector<Vec2> half_circle(double angle) {
    const int n = static_cast<int>(std::lround(kPi / angle));
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) points.push_back(unit(-kPi / 2 + (k + 0.5) * kPi / n));
    return points;
  }

  // Looks at points of the half circle, and between two that differ for where the material ends. A
  // point deep in cleared ground answers for those after it.
  Load load_at(const Piece& piece, double t) const {
    const Vec2 p = piece.point(t), ahead = piece.direction(t), left = left_normal(ahead);
    const double r = radius_ - settings_.thinnest;
    const Piece gone = piece.until(t);
    const auto at = [&](Vec2 towards) { return p + r * (towards.x * ahead + towards.y * left); };
    const auto meets = [&](Vec2 towards) {
      const Vec2 q = at(towards);
      // The half circle itself lies that much inside the tool.
      return holds_material(q) &&
             !(piece.arc && gone.distance_to(q) <= radius_ - 2 * settings_.thinnest);
    };
    const double d = kPi / static_cast<double>(half_circle_.size());
    Load load;
    bool before = false;
    double from = -kPi / 2;
    const auto close = [&](double to) {
      load.angle += to - from;
      load.width += radius_ * (std::sin(to) - std::sin(from));
      load.right += std::cos(to) - std::cos(from);
    };
    for (std::size_t k = 0; k < half_circle_.size(); ++k) {
      const bool now = meets(half_circle_[k]);
      if (now != before) {
        double change = -kPi / 2;
        if (k > 0) {
          double high = -kPi / 2 + (static_cast<double>(k) + 0.5) * d, low = high - d;
          for (int i = 0; i < kBisections; ++i) {
            change = 0.5 * (low + high);
            (meets(unit(change)) == before ? low : high) = change;
          }
        }
        if (now)
          from = change;
        else
          close(change);
      }
      before = now;
      if (!now) k += cleared_after(at(half_circle_[k]), r * d);
    }
    if (before) close(kPi / 2);
    return load;
  }

  // How many points of the half circle, `spacing` mm apart, one piece has cleared with this one.
  std::size_t cleared_after(Vec2 point, double spacing) const {
    return static_cast<std::size_t>(std::max(0.0, cleared_.depth(point)) / spacing);
  }

  void note(const Load& load, Vec2 p, double length, const Move& move, bool cut) {
    const double mean = engagement_.add(length, load.angle);
    const double rate = rate_.add(length, load.width * move.feed);
    if (cut)
      found_.mean_cut_engagement +=
          (load.angle - found_.mean_cut_engagement) * length / (found_.cut_length + length);
    (cut ? found_.cut_length : found_.link_length) += length;
    found_.removed_area += load.width * length;
    double& worst = cut ? found_.cut_engagement : found_.link_engagement;
    if (mean > worst) {
      worst = mean;
      (cut ? found_.cut_engagement_at : found_.link_engagement_at) = p;
    }
    if (cut && rate > found_.removal_rate) {
      found_.removal_rate = rate;
      found_.removal_rate_at = p;
    }
    if (cut && load.angle > kContact)
      (load.right >= 0 ? found_.climb_length : found_.conventional_length) += length;
  }

  void look_for_kink(const Piece& piece, double engagement) {
    const Vec2 d = piece.direction(0);
    const double turn = std::abs(std::atan2(cross(heading_, d), dot(heading_, d)));
    if (turn <= kKink || engagement <= kContact || last_engagement_ <= kContact) return;
    ++found_.kinks;
    if (turn > found_.worst_kink) {
      found_.worst_kink = turn;
      found_.worst_kink_at = piece.a;
    }
  }

  // The tool reaches what lies within its radius of a place where its centre may be. Such places
  // are looked for on a grid, four times finer where the walls are near.
  void look_for_leftovers() {
    const double h = settings_.cell;
    const Grid grid(box_, h);
    std::vector<std::uint8_t> centre(grid.size()), reach(grid.size());
    const auto fits = [&](Vec2 p) {
      return within_walls(p) && walls_.distance_below_limit(p) >= radius_;
    };
    for (int j = 0; j < grid.rows; ++j)
      for (int i = 0; i < grid.columns; ++i)
        centre[grid.index(i, j)] = fits(grid.middle(i, j)) ? 1 : 0;
    const double r = radius_ - 10 * settings_.thinnest;
    const auto stamp = [&](Vec2 p) {
      for (int j = grid.row(p.y - r); j <= grid.row(p.y + r); ++j) {
        const double half_chord = std::sqrt(r * r - std::pow(grid.middle(0, j).y - p.y, 2));
        if (!(half_chord >= 0)) continue;
        // The columns whose middles lie on the chord.
        const int from = grid.column(p.x - half_chord + 0.5 * h),
                  to = grid.column(p.x + half_chord + 0.5 * h);
        std::fill(reach.begin() + static_cast<std::ptrdiff_t>(grid.index(from, j)),
                  reach.begin() + static_cast<std::ptrdiff_t>(grid.index(to, j)), 1);
      }
    };
    for (int j = 1; j + 1 < grid.rows; ++j)
      for (int i = 1; i + 1 < grid.columns; ++i) {
        const Vec2 p = grid.middle(i, j);
        bool same = true;
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di)
            same &= centre[grid.index(i + di, j + dj)] == centre[grid.index(i, j)];
        if (same) {
          if (centre[grid.index(i, j)]) reach[grid.index(i, j)] = 1;
          // A channel narrower than a cell lies between centres that do not fit.
          if (centre[grid.index(i, j)] || !within_walls(p) ||
              walls_.distance_below_limit(p) < radius_ - h)
            continue;
        }
        for (int b = 0; b < 4; ++b)
          for (int a = 0; a < 4; ++a) {
            const Vec2 q = p + h * Vec2{(a - 1.5) / 4, (b - 1.5) / 4};
            if (fits(q)) stamp(q);
          }
      }
    for (int j = 0; j < grid.rows; ++j)
      for (int i = 0; i < grid.columns; ++i) {
        const Vec2 p = grid.middle(i, j);
        if (!reach[grid.index(i, j)]) continue;
        if (stock_.hole && distance(p, *stock_.hole) <= stock_.hole_radius) continue;
        if (!open_edges_.empty() && !in_open_(p)) continue;
        found_.reachable_area += h * h;
        if (cleared_.contains(p)) continue;
        found_.left_area += h * h;
        found_.left_at = p;
      }
    if (found_.reachable_area > 0) found_.left_share = found_.left_area / found_.reachable_area;
  }

  const Stock& stock_;
  double radius_;
  const std::vector<Move>& moves_;
  Settings settings_;
  std::vector<Edge> wall_edges_, open_edges_;
  Bounds box_;
  Inside in_walls_, in_open_;
  Walls walls_;
  Cleared cleared_;
  std::vector<Vec2> half_circle_;
  WindowMean engagement_, rate_;
  Findings found_;
  MoveKind kind_ = MoveKind::kRapid;
  Vec2 heading_;
  bool has_heading_ = false;
  double last_engagement_ = 0;
};

}  // namespace

Findings check_path(const Stock& stock, double tool_radius, const std::vector<Move>& moves,
                    const Settings& settings) {
  return Check(stock, tool_radius, moves, settings).run();
}

}  // namespace evenload::path_check
