#include "simulate/rest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace evenload {
namespace {

// Each level of the part with all that stands higher, and with what no tool reaches; grown by the
// tolerance.
std::vector<Prism> out_of_reach(const std::vector<Prism>& part, double tool_radius) {
  std::map<double, std::vector<Region>, std::greater<>> by_top;
  for (const Prism& prism : part) by_top[prism.top].push_back(prism.region);
  std::vector<Prism> result;
  std::vector<Region> standing;  // at this height
  for (const auto& [top, regions] : by_top) {
    standing.insert(standing.end(), regions.begin(), regions.end());
    for (const Region& region :
         offset(offset(standing, tool_radius), std::min(0.0, kRestTolerance - tool_radius)))
      result.push_back({region, top});
  }
  return result;
}

struct Run {
  int row = 0;
  double low = 0, high = 0;  // mm
  double depth = 0;          // mm
};

// Where `stock` stands above `target`, which has the same rows, by more than the tolerance.
std::vector<Run> runs_above(const DexelStock& stock, const DexelStock* target) {
  std::vector<Run> runs;
  std::vector<double> ends;
  for (int j = 0; j < stock.row_count(); ++j) {
    const DexelRow& row = stock.row(j);
    if (row.empty()) continue;
    const DexelRow* below = target ? &target->row(j) : nullptr;
    ends.clear();
    for (const DexelRow::Piece& piece : row.pieces()) ends.push_back(piece.x);
    if (below)
      for (const DexelRow::Piece& piece : below->pieces()) ends.push_back(piece.x);
    std::sort(ends.begin(), ends.end());
    bool open = false;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (!(ends[i + 1] > ends[i])) continue;
      const double middle = 0.5 * (ends[i] + ends[i + 1]);
      const double top = row.top_at(middle);
      double depth = 0;
      if (top != kNoMaterial)
        depth = top - std::max(stock.bottom(), below ? below->top_at(middle) : kNoMaterial);
      if (depth <= kRestTolerance) {
        open = false;
      } else if (open && runs.back().high == ends[i]) {
        runs.back().high = ends[i + 1];
        runs.back().depth = std::max(runs.back().depth, depth);
      } else {
        runs.push_back({j, ends[i], ends[i + 1], depth});
        open = true;
      }
    }
  }
  return runs;
}

double area_of(const std::vector<Run>& runs, double resolution) {
  double length = 0;
  for (const Run& run : runs) length += run.high - run.low;
  return length * resolution;
}

// Which runs of neighbouring rows overlap: calls meet(lower, upper), indices of runs.
template <typename Meet>
void visit_neighbours(const std::vector<Run>& runs, Meet meet) {
  std::size_t first = 0;  // of the row below
  for (std::size_t i = 0; i < runs.size(); ++i) {
    while (first < i && runs[first].row < runs[i].row - 1) ++first;
    for (std::size_t k = first; k < i && runs[k].row == runs[i].row - 1; ++k)
      if (runs[k].low <= runs[i].high && runs[i].low <= runs[k].high) meet(k, i);
  }
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::vector<RestPatch> patches_of(const std::vector<Run>& runs, const DexelStock& stock) {
  std::vector<std::size_t> parent(runs.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  visit_neighbours(
      runs, [&](std::size_t a, std::size_t b) { parent[root_of(parent, a)] = root_of(parent, b); });
  std::map<std::size_t, RestPatch> found;
  std::map<std::size_t, double> longest;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t root = root_of(parent, i);
    RestPatch& patch = found[root];
    const double length = runs[i].high - runs[i].low;
    patch.area += length * stock.resolution();
    patch.depth = std::max(patch.depth, runs[i].depth);
    if (length > longest[root]) {
      longest[root] = length;
      patch.at = {0.5 * (runs[i].low + runs[i].high), stock.row_y(runs[i].row)};
    }
  }
  std::vector<RestPatch> patches;
  for (const auto& [unused, patch] : found) patches.push_back(patch);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const RestPatch& a, const RestPatch& b) { return a.area > b.area; });
  return patches;
}

// Strips of runs that each have one neighbour, as polygons half a row wider at both ends.
std::vector<std::vector<Vec2>> outlines_of(const std::vector<Run>& runs, const DexelStock& stock) {
  const std::size_t none = runs.size();
  std::vector<std::size_t> above(runs.size(), none), below(runs.size(), none);
  std::vector<int> count_above(runs.size(), 0), count_below(runs.size(), 0);
  visit_neighbours(runs, [&](std::size_t a, std::size_t b) {
    above[a] = b;
    below[b] = a;
    ++count_above[a];
    ++count_below[b];
  });
  const auto joined = [&](std::size_t a) {  // with the run above it
    return count_above[a] == 1 && count_below[above[a]] == 1;
  };
  std::vector<std::vector<Vec2>> outlines;
  const double half = 0.5 * stock.resolution();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (count_below[i] == 1 && joined(below[i])) continue;
    std::vector<Vec2> right, left;
    std::size_t last = i;
    for (std::size_t k = i;; k = above[k]) {
      const double y = stock.row_y(runs[k].row);
      if (k == i) {
        right.push_back({runs[k].high, y - half});
        left.push_back({runs[k].low, y - half});
      }
      right.push_back({runs[k].high, y});
      left.push_back({runs[k].low, y});
      last = k;
      if (!joined(k)) break;
    }
    const double y = stock.row_y(runs[last].row) + half;
    right.push_back({runs[last].high, y});
    left.push_back({runs[last].low, y});
    right.insert(right.end(), left.rbegin(), left.rend());
    outlines.push_back(std::move(right));
  }
  return outlines;
}

}  // namespace

Rest find_rest(const DexelStock& stock, const std::vector<Prism>& part, double tool_radius) {
  Rest rest;
  std::vector<Run> runs;
  if (part.empty()) {
    runs = runs_above(stock, nullptr);
  } else {
    const double resolution = stock.resolution();
    const DexelStock target(out_of_reach(part, tool_radius), stock), walls(part, stock);
    runs = runs_above(stock, &target);
    rest.unreachable_area =
        std::max(0.0, area_of(runs_above(stock, &walls), resolution) - area_of(runs, resolution));
  }
  rest.area = area_of(runs, stock.resolution());
  rest.patches = patches_of(runs, stock);
  for (const RestPatch& patch : rest.patches) rest.depth = std::max(rest.depth, patch.depth);
  rest.outlines = outlines_of(runs, stock);
  return rest;
}

}  // namespace evenload
