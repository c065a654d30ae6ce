#include "geometry/point_grid.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace evenload {
namespace {

// Share of a distance: what rounding may make of it.
constexpr double kRounding = 1e-9;

// The cell's number for `offset` cells from the first; the last ones for what lies beyond.
int clamped(double offset, int count) {
  return static_cast<int>(std::clamp(std::floor(offset), 0.0, static_cast<double>(count - 1)));
}

}  // namespace

PointGrid::PointGrid(const Bounds& bounds, double cell) : origin_(bounds.low) {
  if (!(cell > 0)) throw std::invalid_argument("The cells of a grid must be wider than nothing.");
  const double width = bounds.high.x - bounds.low.x, height = bounds.high.y - bounds.low.y;
  cell_ = std::max({cell, std::sqrt(width * height / kMaximumCells),
                    2 * std::max(width, height) / kMaximumCells});
  columns_ = static_cast<int>(std::floor(width / cell_)) + 1;
  rows_ = static_cast<int>(std::floor(height / cell_)) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

int PointGrid::column_of(double x) const { return clamped((x - origin_.x) / cell_, columns_); }

int PointGrid::row_of(double y) const { return clamped((y - origin_.y) / cell_, rows_); }

PointGrid::Block PointGrid::block_of(const Bounds& range) const {
  if (cells_.empty()) return {};
  return {column_of(range.low.x), row_of(range.low.y), column_of(range.high.x),
          row_of(range.high.y)};
}

std::optional<std::size_t> PointGrid::nearest(Vec2 q) const {
  if (size_ == 0) return std::nullopt;
  std::optional<std::size_t> item;
  double best = std::numeric_limits<double>::infinity();
  const auto look = [&](int i, int j) {
    if (i < 0 || i >= columns_) return;
    for (const Point& point : cells_[index(i, j)]) {
      const double d = squared_norm(point.p - q);
      if (d > best || (d == best && point.item > *item)) continue;
      best = d;
      item = point.item;
    }
  };
  // Ring by ring about the place's cell. All of ring k is k - 1 cells away or further, also from a
  // place beside the grid, which is no nearer to any point than the grid's border before it.
  const int column = column_of(q.x), row = row_of(q.y);
  for (int k = 0; k < std::max(columns_, rows_); ++k) {
    if ((k - 1) * cell_ > std::sqrt(best) * (1 + kRounding)) break;
    const int i0 = column - k, i1 = column + k;
    for (int j = std::max(0, row - k); j <= std::min(rows_ - 1, row + k); ++j) {
      if (std::abs(j - row) < k) {
        look(i0, j);
        look(i1, j);
      } else {
        for (int i = std::max(0, i0); i <= std::min(columns_ - 1, i1); ++i) look(i, j);
      }
    }
  }
  return item;
}

}  // namespace evenload
