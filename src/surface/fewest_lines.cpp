#include "surface/fewest_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace evenload {

namespace {

// Heights of a corner between its bounds, the curve itself first: with more of them there are
// hardly fewer lines.
constexpr std::size_t kHeights = 6;
// Upright bounds of a steep curve are wider than across it, up to so many times.
constexpr double kWidest = 10;
constexpr int kUnseen = -1;

struct Corner {
  int lines = kUnseen;  // to come here
  std::size_t from = 0;
};

class Search {
 public:
  Search(const std::vector<Vec2>& curve, double below, double above)
      : curve_(curve), corners_(curve.size() * kHeights) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double stretch = stretch_at(i);
      heights_.push_back({0, above * stretch / 4, above * stretch / 2, above * stretch * 3 / 4,
                          above * stretch, -below * stretch});
    }
  }

  std::vector<Vec2> run(LineEnds ends) {
    const std::size_t at_ends = ends == LineEnds::kFree ? kHeights : 1;
    std::vector<std::size_t> layer;
    for (std::size_t h = 0; h < at_ends; ++h) {
      corners_[h].lines = 0;
      layer.push_back(h);
    }
    for (;;) {
      std::vector<std::size_t> next;
      for (const std::size_t corner : layer) look_from(corner, next);
      const std::size_t last = (curve_.size() - 1) * kHeights;
      for (std::size_t h = 0; h < at_ends; ++h)
        if (corners_[last + h].lines != kUnseen) return way_to(last + h);
      layer = std::move(next);
    }
  }

 private:
  // By how much bounds across the curve are higher in z at a point: the less of both sides.
  double stretch_at(std::size_t i) const {
    double stretch = kWidest;
    for (const std::size_t k : {i, i + 1}) {
      if (k == 0 || k == curve_.size()) continue;
      const Vec2 piece = curve_[k] - curve_[k - 1];
      stretch = std::min(stretch, norm(piece) / piece.x);
    }
    return stretch;
  }

  double z(std::size_t corner) const {
    return curve_[corner / kHeights].y + heights_[corner / kHeights][corner % kHeights];
  }

  // Adds the corners that one line from this one reaches first.
  void look_from(std::size_t corner, std::vector<std::size_t>& found) {
    const std::size_t point = corner / kHeights;
    const Vec2 from{curve_[point].x, z(corner)};
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (std::size_t i = point + 1; i < curve_.size() && low <= high; ++i) {
      const double run = curve_[i].x - from.x, rise = curve_[i].y - from.y;
      for (std::size_t h = 0; h < kHeights; ++h) {
        Corner& there = corners_[i * kHeights + h];
        if (there.lines != kUnseen) continue;
        const double slope = (rise + heights_[i][h]) / run;
        if (slope < low || slope > high) continue;
        there = {corners_[corner].lines + 1, corner};
        found.push_back(i * kHeights + h);
      }
      low = std::max(low, (rise + heights_[i][kHeights - 1]) / run);
      high = std::min(high, (rise + heights_[i][kHeights - 2]) / run);
    }
  }

  std::vector<Vec2> way_to(std::size_t corner) const {
    std::vector<Vec2> way;
    for (;; corner = corners_[corner].from) {
      way.push_back({curve_[corner / kHeights].x, z(corner)});
      if (corners_[corner].lines == 0) break;
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const std::vector<Vec2>& curve_;
  std::vector<std::array<double, kHeights>> heights_;  // over the curve; the highest before last
  std::vector<Corner> corners_;
};

}  // namespace

std::vector<Vec2> fewest_lines(const std::vector<Vec2>& curve, double below, double above,
                               LineEnds ends) {
  return Search(curve, below, above).run(ends);
}

std::vector<Vec2> without_straight_ones(const std::vector<Vec2>& curve, double tolerance) {
  std::vector<Vec2> kept{curve.front()};
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Vec2 from = kept.back();
    const double run = curve[i].x - from.x, rise = curve[i].y - from.y;
    if (rise / run < low || rise / run > high) {
      kept.push_back(curve[i - 1]);
      const Vec2 start = kept.back();
      low = (curve[i].y - tolerance - start.y) / (curve[i].x - start.x);
      high = (curve[i].y + tolerance - start.y) / (curve[i].x - start.x);
      continue;
    }
    low = std::max(low, (rise - tolerance) / run);
    high = std::min(high, (rise + tolerance) / run);
  }
  kept.push_back(curve.back());
  return kept;
}

}  // namespace evenload
