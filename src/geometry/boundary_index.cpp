#include "geometry/boundary_index.h"

#include <algorithm>
#include <limits>

#include "geometry/box_tree.h"

namespace evenload {

// A piece in the form that answers squared distances with the fewest operations and without angles.
struct FastPiece {
  Vec2 a, b;
  Vec2 centre;         // arcs: the centre; lines: the vector from a to b
  Vec2 middle;         // arcs: unit vector from the centre to the arc's middle
  double sine = 0;     // arcs: of half the included angle
  bool wide = false;   // arcs: more than half a circle
  double radius = 0;   // arcs; 0 marks a line
  double inverse = 0;  // lines: 1 / squared length

  explicit FastPiece(const Segment& s) : a(s.a), b(s.b) {
    if (s.is_arc()) {
      centre = s.centre;
      radius = s.radius;
      middle = unit(s.start_angle + 0.5 * s.sweep);
      sine = std::abs(std::sin(0.5 * s.sweep));
      wide = std::abs(s.sweep) > kPi;
    } else {
      centre = s.b - s.a;
      const double squared = squared_norm(centre);
      inverse = squared > 0 ? 1 / squared : 0;
    }
  }

  double squared_distance(Vec2 q) const {
    if (radius == 0) {
      const Vec2 from_a = q - a;
      const double t = std::clamp(dot(from_a, centre) * inverse, 0.0, 1.0);
      return squared_norm(from_a - t * centre);
    }
    const Vec2 from_centre = q - centre;
    const double r = norm(from_centre);
    // By the sine, since the cosine of a flat arc's angle is 1 after rounding.
    const bool narrow = std::abs(cross(middle, from_centre)) <= r * sine;
    const bool ahead = dot(middle, from_centre) > 0;
    if (wide ? ahead || !narrow : ahead && narrow) return (r - radius) * (r - radius);
    return std::min(squared_norm(q - a), squared_norm(q - b));
  }
};

namespace {

constexpr std::size_t kCellsPerSide = 512;  // at most; the hints then fill a few MB
// Of squared distances: a hint stays until a piece is a tenth nearer. In the middle of a round
// outline nearly all pieces are equally near, and to find the nearest would take a look at each.
constexpr double kHintSlack = 0.81;

}  // namespace

struct BoundaryIndex::Implementation {
  std::vector<Segment> segments;
  std::vector<FastPiece> pieces;
  std::vector<std::size_t> first_of_curve;
  BoxTree tree;

  // A grid over the box of all: per cell a piece near it, which bounds a search from the start,
  // and, where no piece passes the cell, the cell's winding number; per row the pieces it takes to
  // find a winding number.
  static constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();
  Bounds box{};
  std::size_t columns = 0, rows = 0;
  double per_x = 0, per_y = 0;  // cells per mm
  std::vector<std::uint32_t> hint;
  std::vector<std::int32_t> winding;
  std::vector<std::vector<std::uint32_t>> in_row;

  std::size_t column_of(double x) const {
    return static_cast<std::size_t>(
        std::clamp((x - box.low.x) * per_x, 0.0, static_cast<double>(columns - 1)));
  }
  std::size_t row_of(double y) const {
    return static_cast<std::size_t>(
        std::clamp((y - box.low.y) * per_y, 0.0, static_cast<double>(rows - 1)));
  }
  int winding_at(std::size_t row, Vec2 q) const {
    int sum = 0;
    for (const std::uint32_t i : in_row[row]) sum += winding_of(segments[i], q);
    return sum;
  }
  double search(Vec2 q, double best, std::size_t& item) const {
    tree.nearest(q, best, item, [&](std::size_t i) { return pieces[i].squared_distance(q); });
    return best;
  }
  void build_grid(const std::vector<Bounds>& boxes);
};

void BoundaryIndex::Implementation::build_grid(const std::vector<Bounds>& boxes) {
  box = boxes[0];
  for (const Bounds& b : boxes) box = joined(box, b);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  // About two cells a piece: a search then starts from a piece that is nearly always the right one.
  const double cells = 2.0 * static_cast<double>(boxes.size()) + 16;
  const double larger = std::max({width, height, 1e-9});
  const double side =
      std::max(std::sqrt(std::max(width, 1e-3 * larger) * std::max(height, 1e-3 * larger) / cells),
               larger / static_cast<double>(kCellsPerSide));
  columns = static_cast<std::size_t>(width / side) + 1;
  rows = static_cast<std::size_t>(height / side) + 1;
  per_x = per_y = 1 / side;

  in_row.resize(rows);
  std::vector<std::uint8_t> passed(columns * rows, 0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::size_t row0 = row_of(boxes[i].low.y), row1 = row_of(boxes[i].high.y);
    const std::size_t column0 = column_of(boxes[i].low.x), column1 = column_of(boxes[i].high.x);
    for (std::size_t row = row0; row <= row1; ++row) {
      in_row[row].push_back(static_cast<std::uint32_t>(i));
      for (std::size_t column = column0; column <= column1; ++column)
        passed[row * columns + column] = 1;
    }
  }
  hint.resize(columns * rows);
  winding.assign(columns * rows, kUnknown);
  std::size_t near = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t cell = row * columns + column;
      const Vec2 centre{box.low.x + (static_cast<double>(column) + 0.5) * side,
                        box.low.y + (static_cast<double>(row) + 0.5) * side};
      search(centre, kHintSlack * pieces[near].squared_distance(centre), near);
      hint[cell] = static_cast<std::uint32_t>(near);
      if (passed[cell]) continue;
      const bool as_before = column > 0 && !passed[cell - 1];
      winding[cell] = as_before ? winding[cell - 1] : winding_at(row, centre);
    }
  }
}

BoundaryIndex::BoundaryIndex(const std::vector<Curve>& curves) {
  const auto built = std::make_shared<Implementation>();
  Implementation& in = *built;
  std::vector<Bounds> boxes;
  for (const Curve& curve : curves) {
    in.first_of_curve.push_back(in.segments.size());
    for (std::size_t i = 0; i < curve.segment_count(); ++i) {
      in.segments.push_back(curve.segment(i));
      in.pieces.emplace_back(in.segments.back());
      boxes.push_back(in.segments.back().bounds());
    }
  }
  in.tree = BoxTree(boxes);
  if (!boxes.empty()) in.build_grid(boxes);
  implementation_ = built;
}

bool BoundaryIndex::empty() const { return implementation_->segments.empty(); }

BoundaryIndex::Hit BoundaryIndex::nearest(Vec2 q) const {
  const Implementation& in = *implementation_;
  std::size_t item = in.hint[in.row_of(q.y) * in.columns + in.column_of(q.x)];
  in.search(q, in.pieces[item].squared_distance(q), item);

  Hit hit;
  const Segment& s = in.segments[item];
  hit.t = s.nearest(q);
  hit.point = s.point(hit.t);
  hit.distance = distance(q, hit.point);
  const auto after = std::upper_bound(in.first_of_curve.begin(), in.first_of_curve.end(), item);
  hit.curve = static_cast<std::size_t>(after - in.first_of_curve.begin()) - 1;
  hit.segment = item - in.first_of_curve[hit.curve];
  return hit;
}

double BoundaryIndex::distance_below(Vec2 q, double limit) const {
  const Implementation& in = *implementation_;
  if (empty() || !(limit > 0)) return limit;
  std::size_t item = in.hint[in.row_of(q.y) * in.columns + in.column_of(q.x)];
  const double bound = std::min(limit * limit, in.pieces[item].squared_distance(q));
  const double best = in.search(q, bound, item);
  return best < limit * limit ? std::sqrt(best) : limit;
}

bool BoundaryIndex::contains(Vec2 q) const {
  const Implementation& in = *implementation_;
  if (empty() || q.x < in.box.low.x || q.x > in.box.high.x || q.y < in.box.low.y ||
      q.y > in.box.high.y)
    return false;
  const std::size_t row = in.row_of(q.y);
  const std::int32_t known = in.winding[row * in.columns + in.column_of(q.x)];
  return (known != Implementation::kUnknown ? known : in.winding_at(row, q)) != 0;
}

}  // namespace evenload
