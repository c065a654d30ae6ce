// Numbered points in square cells: which of them lie near a box, and which is nearest to a place.
//
// Made for points that become fewer: a look costs as much as there are points left near it, however
// many there once were. Cells are never made so fine that there are many more than kMaximumCells.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/curve.h"

namespace evenload {

class PointGrid {
 public:
  static constexpr double kMaximumCells = 2e5;

  PointGrid() = default;
  // `bounds`: holds every point. `cell` mm > 0: the side of a cell.
  PointGrid(const Bounds& bounds, double cell);

  void add(std::size_t item, Vec2 p) {
    cell_at(p).push_back({item, p});
    ++size_;
  }
  std::size_t size() const { return size_; }

  // Calls visit(item) for every point of the cells that `range` meets.
  template <typename Visit>
  void visit(const Bounds& range, Visit&& visit) const {
    const Block block = block_of(range);
    for (int j = block.j0; j <= block.j1; ++j)
      for (int i = block.i0; i <= block.i1; ++i)
        for (const Point& point : cells_[index(i, j)]) visit(point.item);
  }

  // The same, and drops the points for which drop(item) is true; it must not add points here.
  template <typename Drop>
  void drop_if(const Bounds& range, Drop&& drop) {
    const Block block = block_of(range);
    for (int j = block.j0; j <= block.j1; ++j)
      for (int i = block.i0; i <= block.i1; ++i)
        size_ -= std::erase_if(cells_[index(i, j)],
                               [&](const Point& point) { return drop(point.item); });
  }

  // The point nearest to `q`, of several the one with the lowest number.
  std::optional<std::size_t> nearest(Vec2 q) const;

 private:
  struct Point {
    std::size_t item = 0;
    Vec2 p;
  };
  // Columns and rows of cells, the last ones included; none where a last is below a first.
  struct Block {
    int i0 = 0, j0 = 0, i1 = -1, j1 = -1;
  };
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }
  int column_of(double x) const;
  int row_of(double y) const;
  std::vector<Point>& cell_at(Vec2 p) { return cells_[index(column_of(p.x), row_of(p.y))]; }
  Block block_of(const Bounds& range) const;

  Vec2 origin_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::size_t size_ = 0;
  std::vector<std::vector<Point>> cells_;
};

}  // namespace evenload
