// The connected components of a bisection, and those that are poles and no zeros.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "dynamics/mdbm.h"

namespace evenload {

namespace {

// Between two nodes: values so many times those of the nodes tell a pole, or so much smaller a
// zero.
constexpr double kTelling = 4;
constexpr int kMostLooks = 16;
constexpr std::size_t kLookedAt = 8;  // cells of a component

}  // namespace

std::vector<int> Mdbm::components() const {
  std::unordered_map<Index, int, Hash> number;
  for (std::size_t i = 0; i < cells_.size(); ++i) number.emplace(cells_[i], -1);
  int count = 0, around = 1;
  for (int a = 0; a < axes(); ++a) around *= 3;
  for (const Index& start : cells_) {
    if (number[start] >= 0) continue;
    std::vector<Index> open{start};
    number[start] = count;
    while (!open.empty()) {
      const Index cell = open.back();
      open.pop_back();
      for (int n = 0; n < around; ++n) {
        Index neighbour = cell;
        for (int a = 0, rest = n; a < axes(); ++a, rest /= 3)
          neighbour[a] += (rest % 3 - 1) * stride_;
        const auto found = number.find(neighbour);
        if (found == number.end() || found->second >= 0) continue;
        found->second = count;
        open.push_back(neighbour);
      }
    }
    ++count;
  }
  std::vector<int> result;
  for (const Index& cell : cells_) result.push_back(number[cell]);
  return result;
}

// Of |f| over the corners of a cell so wide; infinite where one was not evaluated.
double Mdbm::mean_size(const Index& cell, std::int64_t stride, int equation) const {
  double sum = 0;
  for (int number = 0; number < 1 << axes(); ++number) {
    Index node = cell;
    for (int a = 0; a < axes(); ++a)
      if (number >> a & 1) node[a] += stride;
    const double* value = values(node);
    if (!value) return std::numeric_limits<double>::infinity();
    sum += std::abs(value[equation]);
  }
  return sum / (1 << axes());
}

// Whether an equation tends to infinity where it changes its sign between two corners.
bool Mdbm::is_pole(const Index& cell, int equation) {
  double high[kMostAxes], low[kMostAxes], at[kMostAxes], found[kMostAxes + 1];
  double largest = 0, least = std::numeric_limits<double>::infinity();
  int signs = 0;
  for (int number = 0; number < 1 << axes(); ++number) {
    const Index node = corner(cell, number);
    const double value = values(node)[equation];
    for (int a = 0; a < axes(); ++a) (value > 0 ? high : low)[a] = place(node, a);
    signs |= value > 0 ? 1 : 2;
    largest = std::max(largest, std::abs(value));
    least = std::min(least, std::abs(value));
  }
  for (int i = 0; i < kMostLooks && signs == 3; ++i) {
    for (int a = 0; a < axes(); ++a) at[a] = 0.5 * (low[a] + high[a]);
    problem_.evaluate(at, found);
    ++looks_between_;
    const double value = found[equation];
    if (!(std::abs(value) < kTelling * largest)) return true;
    if (kTelling * std::abs(value) < least) return false;
    std::copy_n(at, axes(), value > 0 ? high : low);
  }
  return false;
}

// Whether most of a component's cells have larger values than before they were halved, and most of
// some that are looked at closely hold a pole.
bool Mdbm::is_pole(std::vector<Index> cells, int equation) {
  std::vector<Index> grown;
  std::size_t known = 0;
  for (const Index& cell : cells) {
    Index parent = cell;
    for (int a = 0; a < axes(); ++a) parent[a] -= parent[a] % (2 * stride_);
    const double before = mean_size(parent, 2 * stride_, equation);
    if (!std::isfinite(before)) continue;
    ++known;
    if (mean_size(cell, stride_, equation) >= before) grown.push_back(cell);
  }
  if (2 * grown.size() <= known || grown.empty()) return false;
  const std::size_t step = 1 + grown.size() / kLookedAt;
  int poles = 0, looked_at = 0;
  for (std::size_t i = 0; i < grown.size(); i += step, ++looked_at)
    poles += is_pole(grown[i], equation) ? 1 : 0;
  return 2 * poles > looked_at;
}

void Mdbm::drop_poles() {
  const std::vector<int> numbers = components();
  std::map<int, std::vector<Index>> parts;
  for (std::size_t i = 0; i < cells_.size(); ++i) parts[numbers[i]].push_back(cells_[i]);
  std::vector<Index> kept;
  for (const auto& [number, cells] : parts) {
    bool drop = false;
    for (int e = 0; e < problem_.equations && !drop; ++e) drop = is_pole(cells, e);
    if (!drop) kept.insert(kept.end(), cells.begin(), cells.end());
  }
  std::sort(kept.begin(), kept.end());
  cells_ = std::move(kept);
}

}  // namespace evenload
