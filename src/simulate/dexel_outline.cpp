#include "simulate/dexel_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <tuple>

#include "support/errors.h"

namespace evenload {
namespace {

// mm: a dexel that ends this near to a node may lie on either side of it.
constexpr double kAtNode = 1e-6;
// Cells' sides: what joins a side of a cell to itself is this much longer than it is. Longer than
// two other joints, so that slivers and slits go on into the next cell wherever they can.
constexpr double kTurnBack = 3;

struct Interval {
  double low = 0, high = 0;
};

std::vector<Interval> intervals_above(const DexelRow& row, double z) {
  std::vector<Interval> result;
  const std::vector<DexelRow::Piece>& pieces = row.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (!(pieces[i].top > z)) continue;
    if (!result.empty() && result.back().high == pieces[i].x)
      result.back().high = pieces[i + 1].x;
    else
      result.push_back({pieces[i].x, pieces[i + 1].x});
  }
  return result;
}

std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const Interval both{std::max(a[i].low, b[k].low), std::min(a[i].high, b[k].high)};
    if (both.high - both.low > kShortestPiece) result.push_back(both);
    ++(a[i].high < b[k].high ? i : k);
  }
  return result;
}

// Where a row or column meets the border.
struct Crossing {
  double at = 0;            // mm along the dexel
  int edge = 0;             // between the nodes `edge` and `edge` + 1 of the dexel
  bool enters = false;      // material begins here, along the dexel
  std::uint32_t point = 0;  // its number
};

// The crossings of a dexel whose `nodes` nodes lie at first, first + spacing, ...
std::vector<Crossing> crossings_of(const std::vector<Interval>& intervals, double first,
                                   double spacing, int nodes) {
  std::vector<Crossing> result;
  const auto add = [&](double at, bool enters) {
    const int edge = static_cast<int>(std::floor((at - first) / spacing));
    result.push_back({at, std::clamp(edge, -1, nodes - 1), enters, 0});
  };
  for (const Interval& interval : intervals) {
    add(interval.low, true);
    add(interval.high, false);
  }
  return result;
}

// A crossing as seen on the way round a cell, counter-clockwise from its lower left node.
struct Visit {
  std::int64_t cell = 0;
  int side = 0, rank = 0;
  std::uint32_t point = 0;
  bool enters = false;
};

class Tracer {
 public:
  Tracer(const DexelStock& stock, double z, const std::vector<std::vector<Region>>& within)
      : stock_(stock), columns_(stock.column_count()), rows_(stock.row_count()) {
    for (const std::vector<Region>& regions : within) {
      std::vector<Prism> prisms;
      for (const Region& region : regions) prisms.push_back({region, stock.bottom() + 1});
      masks_.emplace_back(prisms, stock);
    }
    inside_.resize(static_cast<std::size_t>(rows_) * columns_);
    for (int j = 0; j < rows_; ++j)
      add_row(j,
              intervals_in(stock.row(j), z, [j](const DexelStock& mask) { return mask.row(j); }));
    for (int i = 0; i < columns_; ++i)
      add_column(
          i, intervals_in(stock.column(i), z, [i](const DexelStock& m) { return m.column(i); }));
  }

  std::vector<std::vector<Vec2>> outlines() {
    join_in_cells();
    std::vector<std::vector<Vec2>> result;
    std::vector<bool> passed(points_.size(), false);
    for (std::uint32_t start = 0; start < points_.size(); ++start) {
      if (passed[start]) continue;
      std::vector<Vec2> outline;
      for (std::uint32_t at = start; !passed[at]; at = next_[at]) {
        passed[at] = true;
        if (outline.empty() || distance(outline.back(), points_[at]) > kZeroLength)
          outline.push_back(points_[at]);
      }
      while (outline.size() > 1 && distance(outline.back(), outline.front()) <= kZeroLength)
        outline.pop_back();
      if (outline.size() > 2) result.push_back(std::move(outline));
    }
    return result;
  }

 private:
  template <typename Dexel>
  std::vector<Interval> intervals_in(const DexelRow& row, double z, Dexel dexel_of) const {
    std::vector<Interval> result = intervals_above(row, z);
    for (const DexelStock& mask : masks_)
      result = common(result, intervals_above(dexel_of(mask), kNoMaterial));
    return result;
  }

  std::int64_t cell(int i, int j) const {
    return static_cast<std::int64_t>(j + 1) * (columns_ + 1) + (i + 1);
  }

  std::uint32_t add_point(Vec2 p) {
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size()) - 1;
  }

  void add_row(int j, const std::vector<Interval>& intervals) {
    std::vector<Crossing> found =
        crossings_of(intervals, stock_.column_x(0), stock_.resolution(), columns_);
    int rank = 0;
    for (Crossing& c : found) {
      c.point = add_point({c.at, stock_.row_y(j)});
      visits_.push_back({cell(c.edge, j), 0, rank, c.point, c.enters});
      visits_.push_back({cell(c.edge, j - 1), 2, -rank, c.point, !c.enters});
      ++rank;
    }
    for (std::size_t k = 0; k + 1 < found.size(); k += 2)
      for (int i = found[k].edge + 1; i <= found[k + 1].edge; ++i)
        inside_[static_cast<std::size_t>(j) * columns_ + i] = true;
  }

  // Where rounding lets a column see a node otherwise than its row does, the row is right: what the
  // column meets next to the node changes sides, or it meets the border at the node.
  void add_column(int i, const std::vector<Interval>& intervals) {
    std::vector<Crossing> found =
        crossings_of(intervals, stock_.row_y(0), stock_.resolution(), rows_);
    const auto by_row = [&](int j) {
      return j >= 0 && j < rows_ && inside_[static_cast<std::size_t>(j) * columns_ + i];
    };
    for (Crossing& c : found) {
      const int node =
          static_cast<int>(std::lround((c.at - stock_.row_y(0)) / stock_.resolution()));
      if (std::abs(c.at - stock_.row_y(node)) < kAtNode)
        c.edge = std::clamp(by_row(node) == c.enters ? node - 1 : node, -1, rows_ - 1);
    }
    int rank = 0;
    const auto add = [&](double y, int edge, bool enters) {
      const std::uint32_t point = add_point({stock_.column_x(i), y});
      visits_.push_back({cell(i, edge), 3, -rank, point, !enters});
      visits_.push_back({cell(i - 1, edge), 1, rank, point, enters});
      ++rank;
    };
    bool inside = false;  // by the column
    std::size_t k = 0;
    for (int edge = -1; edge < rows_; ++edge) {
      if (by_row(edge) != inside) add(stock_.row_y(edge), edge, inside);
      for (; k < found.size() && found[k].edge == edge; ++k) {
        add(found[k].at, edge, found[k].enters);
        inside = found[k].enters;
      }
      if (by_row(edge + 1) != inside) add(stock_.row_y(edge + 1), edge, !inside);
    }
  }

  void join_in_cells() {
    next_.resize(points_.size());
    std::sort(visits_.begin(), visits_.end(), [](const Visit& a, const Visit& b) {
      return std::tie(a.cell, a.side, a.rank) < std::tie(b.cell, b.side, b.rank);
    });
    for (std::size_t first = 0; first < visits_.size();) {
      std::size_t last = first;
      while (last < visits_.size() && visits_[last].cell == visits_[first].cell) ++last;
      EVENLOAD_ASSERT((last - first) % 2 == 0);
      join(first, last);
      first = last;
    }
  }

  // The border runs from where material ends, on the way round the cell, to where it begins.
  void join_pair(std::size_t a, std::size_t b) {
    EVENLOAD_ASSERT(visits_[a].enters != visits_[b].enters);
    const Visit& from = visits_[visits_[a].enters ? b : a];
    const Visit& to = visits_[visits_[a].enters ? a : b];
    next_[from.point] = to.point;
  }

  // The shortest joints of the visits [first, last) that do not cross, and as few as can be from a
  // side to itself. What is joined to the first splits the others into two rows of the same kind.
  void join(std::size_t first, std::size_t last) {
    if (last - first == 2) {
      join_pair(first, first + 1);
      return;
    }
    const std::size_t n = last - first;
    const auto length = [&](std::size_t a, std::size_t b) {
      const Visit &from = visits_[first + a], &to = visits_[first + b];
      const double back = from.side == to.side ? kTurnBack * stock_.resolution() : 0;
      return back + distance(points_[from.point], points_[to.point]);
    };
    // Of the visits [a, b): least length, and what a is joined to.
    std::vector<double> least((n + 1) * (n + 1), 0.0);
    std::vector<std::size_t> partner((n + 1) * (n + 1), 0);
    for (std::size_t count = 2; count <= n; count += 2)
      for (std::size_t a = 0; a + count <= n; ++a) {
        const std::size_t b = a + count, at = a * (n + 1) + b;
        least[at] = -1;
        for (std::size_t m = a + 1; m < b; m += 2) {
          const double total =
              length(a, m) + least[(a + 1) * (n + 1) + m] + least[(m + 1) * (n + 1) + b];
          if (least[at] >= 0 && total >= least[at]) continue;
          least[at] = total;
          partner[at] = m;
        }
      }
    const std::function<void(std::size_t, std::size_t)> apply = [&](std::size_t a, std::size_t b) {
      if (a == b) return;
      const std::size_t m = partner[a * (n + 1) + b];
      join_pair(first + a, first + m);
      apply(a + 1, m);
      apply(m + 1, b);
    };
    apply(0, n);
  }

  const DexelStock& stock_;
  int columns_, rows_;
  std::vector<DexelStock> masks_;
  std::vector<bool> inside_;  // the nodes, by their rows
  std::vector<Vec2> points_;
  std::vector<Visit> visits_;
  std::vector<std::uint32_t> next_;  // by point
};

}  // namespace

std::vector<std::vector<Vec2>> outlines_above(const DexelStock& stock, double z,
                                              const std::vector<std::vector<Region>>& within) {
  return Tracer(stock, z, within).outlines();
}

}  // namespace evenload
