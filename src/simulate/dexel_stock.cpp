#include "simulate/dexel_stock.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace evenload {
namespace {

constexpr double kSameHeight =
    1e-3;  // mm: tops of models and stocks that should be one are that near

// Fills, up to its top, the rows that cross a prism. `mirror`: columns in place of rows.
void fill_rows(std::vector<DexelRow>& rows, double first, double spacing, const Prism& prism,
               bool mirror) {
  std::vector<std::vector<double>> crossings(rows.size());
  // A border that rises or falls all the way from a to b crosses the rows of [a.y, b.y).
  const auto cross_rows = [&](double ya, double yb, auto x_at) {
    const double low = std::min(ya, yb), high = std::max(ya, yb);
    int j = std::max(0, static_cast<int>(std::ceil((low - first) / spacing)));
    for (; j < static_cast<int>(rows.size()); ++j) {
      const double y = first + j * spacing;
      if (y >= high) break;
      if (y >= low) crossings[static_cast<std::size_t>(j)].push_back(x_at(y));
    }
  };
  for (const Curve& curve : prism.region.curves()) {
    for (Segment s : curve.segments()) {
      if (mirror) s = mirrored(s);
      if (!s.is_arc()) {
        cross_rows(s.a.y, s.b.y, [&](double y) {
          return s.a.x + (y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x);
        });
        continue;
      }
      // Split where the arc turns back, at its lowest and highest points.
      const double begin = std::min(s.start_angle, s.start_angle + s.sweep);
      const double end = std::max(s.start_angle, s.start_angle + s.sweep);
      double from = begin;
      while (from < end) {
        const double turn = (std::floor(from / kPi - 0.5 + 1e-12) + 1.5) * kPi;
        const double to = std::min(end, turn);
        const bool right = std::cos(0.5 * (from + to)) > 0;
        // The ends are the segment's own where they are its ends, so that neighbours agree.
        const auto y_at = [&](double angle) {
          if (angle == s.start_angle) return s.a.y;
          if (angle == s.start_angle + s.sweep) return s.b.y;
          return s.centre.y + s.radius * std::sin(angle);
        };
        cross_rows(y_at(from), y_at(to), [&](double y) {
          const double d = y - s.centre.y;
          const double half = std::sqrt(std::max(0.0, (s.radius - d) * (s.radius + d)));
          return right ? s.centre.x + half : s.centre.x - half;
        });
        from = to;
      }
    }
  }
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::vector<double>& x = crossings[j];
    std::sort(x.begin(), x.end());
    for (std::size_t i = 0; i + 1 < x.size(); i += 2) rows[j].raise(x[i], x[i + 1], prism.top);
  }
}

// Calls part(piece of at most a quarter circle).
template <typename Part>
void split(const Segment& path, Part part) {
  if (!path.is_arc()) {
    part(path);
    return;
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(path.sweep) / (kPi / 2))));
  for (int k = 0; k < pieces; ++k)
    part(pieces == 1
             ? path
             : Segment::arc(path.centre, path.radius, path.start_angle + path.sweep * k / pieces,
                            path.sweep / pieces));
}

}  // namespace

DexelStock::DexelStock(const std::vector<Prism>& prisms, double bottom, double resolution)
    : resolution_(resolution), top_(bottom), bottom_(bottom) {
  if (prisms.empty()) throw std::invalid_argument("The stock has no region: give it one.");
  std::vector<Region> regions;
  for (const Prism& prism : prisms) {
    if (!(std::isfinite(prism.top) && std::isfinite(bottom)))
      throw std::invalid_argument("The stock's top and bottom must be numbers, in mm.");
    regions.push_back(prism.region);
    top_ = std::max(top_, prism.top);
  }
  lay_out(bounds_of(regions));
  fill(prisms);
}

DexelStock::DexelStock(const HeightMap& map, double bottom, double resolution)
    : resolution_(resolution), top_(map.highest()), bottom_(bottom) {
  if (map.empty()) throw std::invalid_argument("The stock has no upper side: give it one.");
  lay_out(map.bounds());
  map.raise(rows_, origin_.y, resolution_, false);
  map.raise(columns_, origin_.x, resolution_, true);
}

// Finds the rows and columns of a stock whose resolution, top and bottom are set.
void DexelStock::lay_out(const Bounds& bounds) {
  if (!(resolution_ > 0 && std::isfinite(resolution_)))
    throw std::invalid_argument("The resolution must be positive, in mm.");
  if (!(top_ > bottom_)) throw std::invalid_argument("The stock's top must lie above its bottom.");
  bounds_ = bounds;
  const double width = bounds_.high.x - bounds_.low.x, height = bounds_.high.y - bounds_.low.y;
  if ((width + height) / resolution_ > kMostRows)
    throw std::invalid_argument(
        "The stock would need too many dexels: choose a coarser resolution.");
  if (std::min(width, height) < resolution_)
    throw std::invalid_argument(
        "The resolution is coarser than the stock is wide: choose a finer one.");
  // As many as come nearest to covering the box, in its middle.
  const auto count = [&](double extent) { return std::round(extent / resolution_); };
  rows_.resize(static_cast<std::size_t>(count(height)));
  columns_.resize(static_cast<std::size_t>(count(width)));
  origin_ = 0.5 * (bounds_.low + bounds_.high) -
            0.5 * resolution_ * Vec2{count(width) - 1, count(height) - 1};
}

DexelStock::DexelStock(const std::vector<Prism>& prisms, const DexelStock& grid)
    : resolution_(grid.resolution_),
      top_(grid.bottom_),
      bottom_(grid.bottom_),
      bounds_(grid.bounds_),
      origin_(grid.origin_),
      rows_(grid.rows_.size()),
      columns_(grid.columns_.size()) {
  for (const Prism& prism : prisms) top_ = std::max(top_, prism.top);
  fill(prisms);
}

void DexelStock::fill(const std::vector<Prism>& prisms) {
  for (const Prism& prism : prisms) {
    if (!(prism.top > bottom_)) continue;
    fill_rows(rows_, origin_.y, resolution_, prism, false);
    fill_rows(columns_, origin_.x, resolution_, prism, true);
  }
}

int DexelStock::row_from(double y) const {
  return static_cast<int>(std::ceil((y - origin_.y) / resolution_));
}

int DexelStock::column_from(double x) const {
  return static_cast<int>(std::ceil((x - origin_.x) / resolution_));
}

Removal DexelStock::cut(const Segment& path, double radius, double z) {
  Removal total;
  if (z >= top_) return total;
  split(path, [&](const Segment& piece) { total += cut_piece(piece, radius, z); });
  return total;
}

Removal DexelStock::cut_piece(const Segment& path, double radius, double z) {
  RowRemoval by_rows, by_columns;
  SweptDisc::Interval intervals[SweptDisc::kMostIntervals];
  const auto cut_rows = [&](std::vector<DexelRow>& rows, const Segment& along, double first,
                            double low, double high, const RowNodes& nodes, RowRemoval& removal) {
    const SweptDisc swept(along, radius);
    const Bounds box = swept.bounds();
    if (box.high.x <= low || box.low.x >= high) return;
    const int from = static_cast<int>(std::max(0.0, std::ceil((box.low.y - first) / resolution_)));
    const int to = static_cast<int>(std::min(static_cast<double>(rows.size()) - 1,
                                             std::floor((box.high.y - first) / resolution_)));
    for (int j = from; j <= to; ++j) {
      DexelRow& row = rows[static_cast<std::size_t>(j)];
      if (row.empty()) continue;
      const int count = swept.on_row(first + j * resolution_, intervals);
      for (int k = 0; k < count; ++k)
        row.cut(intervals[k].low, intervals[k].high, z, bottom_, nodes, removal, scratch_);
    }
  };
  cut_rows(rows_, path, origin_.y, bounds_.low.x, bounds_.high.x, {origin_.x, resolution_},
           by_rows);
  cut_rows(columns_, mirrored(path), origin_.x, bounds_.low.y, bounds_.high.y,
           {origin_.y, resolution_}, by_columns);
  const double cell = resolution_ * resolution_;
  return {resolution_ * (by_rows.area + by_columns.area) - cell * by_rows.node_height,
          resolution_ * (by_rows.through + by_columns.through) - cell * by_rows.through_nodes,
          by_rows.area > 0 || by_columns.area > 0};
}

namespace {

// Length and height taken together over pieces with material: calls add(length, height, nodes).
template <typename Add>
void add_up(const std::vector<DexelRow>& rows, double bottom, const RowNodes& nodes, Add add) {
  for (const DexelRow& row : rows) {
    const std::vector<DexelRow::Piece>& pieces = row.pieces();
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
      if (pieces[i].top != kNoMaterial)
        add(pieces[i + 1].x - pieces[i].x, pieces[i].top - bottom,
            nodes.count(pieces[i].x, pieces[i + 1].x));
  }
}

}  // namespace

double DexelStock::area() const {
  double by_rows = 0, by_columns = 0, by_nodes = 0;
  add_up(rows_, bottom_, {origin_.x, resolution_}, [&](double length, double, double nodes) {
    by_rows += length;
    by_nodes += nodes;
  });
  add_up(columns_, bottom_, {origin_.y, resolution_},
         [&](double length, double, double) { by_columns += length; });
  return resolution_ * (by_rows + by_columns) - resolution_ * resolution_ * by_nodes;
}

double DexelStock::volume() const {
  double by_rows = 0, by_columns = 0, by_nodes = 0;
  add_up(rows_, bottom_, {origin_.x, resolution_}, [&](double length, double h, double nodes) {
    by_rows += length * h;
    by_nodes += nodes * h;
  });
  add_up(columns_, bottom_, {origin_.y, resolution_},
         [&](double length, double h, double) { by_columns += length * h; });
  return resolution_ * (by_rows + by_columns) - resolution_ * resolution_ * by_nodes;
}

double DexelStock::area_lacking(const std::vector<Prism>& prisms) const {
  const DexelStock wanted(prisms, *this);
  // Where one row's pieces stand higher than another's: calls add(length, nodes).
  const auto compare = [](const DexelRow& high, const DexelRow& low, const RowNodes& nodes,
                          auto add) {
    std::vector<double> ends;
    for (const DexelRow* row : {&high, &low})
      for (const DexelRow::Piece& piece : row->pieces()) ends.push_back(piece.x);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double middle = 0.5 * (ends[i] + ends[i + 1]);
      if (ends[i + 1] > ends[i] && high.top_at(middle) > low.top_at(middle) + kSameHeight)
        add(ends[i + 1] - ends[i], nodes.count(ends[i], ends[i + 1]));
    }
  };
  double by_rows = 0, by_columns = 0, by_nodes = 0;
  for (std::size_t j = 0; j < rows_.size(); ++j)
    compare(wanted.rows_[j], rows_[j], {origin_.x, resolution_}, [&](double length, double nodes) {
      by_rows += length;
      by_nodes += nodes;
    });
  for (std::size_t i = 0; i < columns_.size(); ++i)
    compare(wanted.columns_[i], columns_[i], {origin_.y, resolution_},
            [&](double length, double) { by_columns += length; });
  return resolution_ * (by_rows + by_columns) - resolution_ * resolution_ * by_nodes;
}

double DexelStock::area_above(Vec2 centre, double radius, double z) const {
  double length = 0;
  const int end = std::min(row_count(), row_from(centre.y + radius));
  for (int j = std::max(0, row_from(centre.y - radius)); j < end; ++j) {
    const double d = row_y(j) - centre.y;
    const double half = std::sqrt(std::max(0.0, (radius - d) * (radius + d)));
    const std::vector<DexelRow::Piece>& pieces = row(j).pieces();
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
      if (pieces[i].top > z)
        length += std::max(0.0, std::min(pieces[i + 1].x, centre.x + half) -
                                    std::max(pieces[i].x, centre.x - half));
  }
  return length * resolution_;
}

double DexelStock::height_at(Vec2 p) const {
  const int j = static_cast<int>(std::lround((p.y - origin_.y) / resolution_));
  return j < 0 || j >= row_count() ? kNoMaterial : row(j).top_at(p.x);
}

}  // namespace evenload
