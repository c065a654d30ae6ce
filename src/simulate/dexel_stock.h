// Stock as dexels: rows along x and columns along y, each with floating-point ends.
//
// Rows alone see a border that runs along them only to a row's spacing; with columns too, every
// border is met at exact points hardly further apart than the spacing, whichever way it runs. Both
// are cut by every move. Cost and memory grow linearly with 1 / resolution.
// Law: with A_x the area by rows, A_y by columns and A_n by the nodes where they cross,
// A_x + A_y - A_n is the area. Its error is of second order in the resolution along borders
// parallel to the axes, where rows alone have one of first order: the error of a row's width is
// multiplied by that of a column's height. Round borders have the order 3/2, as with rows alone.
// Source: [Jacsó 2021, simulation with dexels], who has rows only.
#pragma once

#include <vector>

#include "geometry/region.h"
#include "simulate/dexel_row.h"
#include "simulate/height_map.h"
#include "simulate/swept_disc.h"

namespace evenload {

// Something that stands on the plane: a region up to a height.
struct Prism {
  Region region;
  double top = 0;  // mm
};

struct Removal {
  double volume = 0;  // mm^3; of a cut hardly wider than the resolution rather rough
  double area = 0;    // mm^2 on which nothing is left
  bool any = false;   // whether a dexel was cut at all

  Removal& operator+=(const Removal& other) {
    volume += other.volume;
    area += other.area;
    any = any || other.any;
    return *this;
  }
};

class DexelStock {
 public:
  // Prisms that overlap count as one. Nothing reaches below `bottom`. Throws std::invalid_argument
  // for no prisms, a resolution that is not positive, and more than kMostRows rows.
  DexelStock(const std::vector<Prism>& prisms, double bottom, double resolution);
  // Stock that is no stack of prisms, as high as its upper side. Throws the same, for an empty map.
  DexelStock(const HeightMap& map, double bottom, double resolution);
  // The prisms on the rows and columns of another stock, and only where these are; they may be
  // none.
  DexelStock(const std::vector<Prism>& prisms, const DexelStock& grid);

  // Lowers to `z` what lies in the disc of `radius` that moves along `path`, an arc of any sweep.
  Removal cut(const Segment& path, double radius, double z);

  double resolution() const { return resolution_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }
  const Bounds& bounds() const { return bounds_; }

  // Rows: y = row_y(j). Columns, whose pieces run along y: x = column_x(i).
  int row_count() const { return static_cast<int>(rows_.size()); }
  int column_count() const { return static_cast<int>(columns_.size()); }
  const DexelRow& row(int j) const { return rows_[static_cast<std::size_t>(j)]; }
  const DexelRow& column(int i) const { return columns_[static_cast<std::size_t>(i)]; }
  double row_y(int j) const { return origin_.y + j * resolution_; }
  double column_x(int i) const { return origin_.x + i * resolution_; }
  // The first row at or above y, and the first column at or right of x; they may lie outside.
  int row_from(double y) const;
  int column_from(double x) const;

  double area() const;             // mm^2 with any material, by the law above
  double volume() const;           // mm^3
  double height_at(Vec2 p) const;  // by the nearest row
  // mm^2 of what prisms take up where the stock does not stand so high, by the law above.
  double area_lacking(const std::vector<Prism>& prisms) const;
  // mm^2 of the disc over which the stock stands higher than z, by rows.
  double area_above(Vec2 centre, double radius, double z) const;

 private:
  Removal cut_piece(const Segment& path, double radius, double z);
  void lay_out(const Bounds& bounds);
  void fill(const std::vector<Prism>& prisms);

  double resolution_;
  double top_, bottom_;
  Bounds bounds_;
  Vec2 origin_;  // the first node
  std::vector<DexelRow> rows_, columns_;
  std::vector<DexelRow::Piece> scratch_;
};

// Rows and columns together: 10 m at 0.05 mm.
inline constexpr double kMostRows = 4e5;

}  // namespace evenload
