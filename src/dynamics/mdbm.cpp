#include "dynamics/mdbm.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "support/demand.h"
#include "support/parallel.h"
#include "support/solvers.h"

namespace evenload {

namespace {

// Of half a cell: with several equations the foot of a cell that the set only passes by lies
// farther away.
constexpr double kNear = 1.5;

}  // namespace

std::size_t Mdbm::Hash::operator()(const Index& index) const {
  std::uint64_t hash = 0;
  for (const std::int64_t i : index) {
    hash ^= static_cast<std::uint64_t>(i) + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
    hash *= 0xff51afd7ed558ccdU;
    hash ^= hash >> 33U;
  }
  return hash;
}

Mdbm::Mdbm(MdbmProblem problem)
    : problem_(std::move(problem)), stride_(std::int64_t{1} << kMostHalvings) {
  demand(!problem_.axes.empty() && axes() <= kMostAxes,
         "The bisection takes one to four axes, each (low, high, cells).");
  for (const MdbmAxis& axis : problem_.axes) {
    demand(std::isfinite(axis.low) && std::isfinite(axis.high) && axis.low < axis.high,
           "Each axis of the bisection must rise from its low to its high end.");
    demand(axis.cells >= 1, "Each axis of the bisection needs at least one cell.");
  }
  demand(problem_.equations >= 1 && problem_.equations <= axes(),
         "The bisection needs at least one equation, and no more than there are axes.");
}

double Mdbm::place(const Index& node, int axis) const {
  const MdbmAxis& a = problem_.axes[static_cast<std::size_t>(axis)];
  const double share = std::ldexp(static_cast<double>(node[axis]), -kMostHalvings) / a.cells;
  return a.low * (1 - share) + a.high * share;
}

const double* Mdbm::values(const Index& node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? nullptr : &values_[found->second];
}

Mdbm::Index Mdbm::corner(const Index& cell, int number) const {
  Index result = cell;
  for (int a = 0; a < axes(); ++a)
    if (number >> a & 1) result[a] += stride_;
  return result;
}

bool Mdbm::is_inside(const Index& cell) const {
  for (int a = 0; a < axes(); ++a)
    if (cell[a] < 0 ||
        cell[a] >= static_cast<std::int64_t>(problem_.axes[static_cast<std::size_t>(a)].cells)
                       << kMostHalvings)
      return false;
  return true;
}

void Mdbm::evaluate(const std::vector<Index>& cells, Progress& progress) {
  std::vector<Index> missing;
  const auto width = static_cast<std::size_t>(value_count());
  for (const Index& cell : cells)
    for (int number = 0; number < 1 << axes(); ++number) {
      const Index node = corner(cell, number);
      if (nodes_.emplace(node, values_.size() + missing.size() * width).second)
        missing.push_back(node);
    }
  std::vector<double> found(missing.size() * width);
  const auto work = [&](std::size_t i) {
    double at[kMostAxes];
    for (int a = 0; a < axes(); ++a) at[a] = place(missing[i], a);
    problem_.evaluate(at, &found[i * width]);
  };
  try {
    parallel_for(missing.size(), problem_.threads, work, progress);
  } catch (...) {
    for (const Index& node : missing) nodes_.erase(node);
    throw;
  }
  values_.insert(values_.end(), found.begin(), found.end());
}

// Whether the corners of a cell, or of its face on `side` of an axis, bracket all equations.
bool Mdbm::brackets(const Index& cell, int axis, int side) const {
  const int count = problem_.equations;
  bool above[kMostAxes] = {}, below[kMostAxes] = {}, allowed = !problem_.has_constraint;
  for (int number = 0; number < 1 << axes(); ++number) {
    if (axis >= 0 && (number >> axis & 1) != side) continue;
    const double* value = values(corner(cell, number));
    for (int e = 0; e < count; ++e) {
      above[e] = above[e] || value[e] >= 0;
      below[e] = below[e] || value[e] <= 0;
    }
    allowed = allowed || value[count] > 0;
  }
  return allowed && std::all_of(above, above + count, [](bool is) { return is; }) &&
         std::all_of(below, below + count, [](bool is) { return is; });
}

// The foot of the least-squares planes from the cell's middle, in half cells. Whether there is one.
bool Mdbm::foot(const Index& cell, bool with_constraint, double* xi) const {
  const int count = problem_.equations + (with_constraint ? 1 : 0), corners = 1 << axes();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(count);
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(count, axes());
  for (int number = 0; number < corners; ++number) {
    const double* value = values(corner(cell, number));
    for (int e = 0; e < count; ++e) {
      mean[e] += value[e] / corners;
      for (int a = 0; a < axes(); ++a)
        slope(e, a) += (number >> a & 1 ? value[e] : -value[e]) / corners;
    }
  }
  // Equations may be of very different size.
  for (int e = 0; e < count; ++e) {
    const double size = slope.row(e).norm();
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(mean[e])) return false;
    slope.row(e) /= size;
    mean[e] /= size;
  }
  const Eigen::VectorXd step =
      slope.transpose() * solved_symmetric(slope.lazyProduct(slope.transpose()), -mean);
  std::copy_n(step.data(), axes(), xi);
  return step.allFinite();
}

bool Mdbm::is_kept(const Index& cell) const {
  if (!brackets(cell, -1, 0)) return false;
  if (problem_.equations == 1) return true;
  double xi[kMostAxes];
  return foot(cell, false, xi) &&
         std::all_of(xi, xi + axes(), [](double x) { return std::abs(x) <= kNear; });
}

// Keeps those of the candidates, `width` wide, that hold the set, and all that are found from them
// on. Where it is cancelled all stays as it was.
void Mdbm::judge(std::vector<Index> candidates, std::int64_t width, Progress& progress) {
  const std::int64_t before = std::exchange(stride_, width);
  try {
    std::vector<Index> kept = all_that_hold(std::move(candidates), progress);
    std::sort(kept.begin(), kept.end());
    cells_ = std::move(kept);
  } catch (...) {
    stride_ = before;
    throw;
  }
  drop_poles();
  evaluations_.push_back(static_cast<std::int64_t>(nodes_.size()) + looks_between_);
}

std::vector<Mdbm::Index> Mdbm::all_that_hold(std::vector<Index> candidates, Progress& progress) {
  CellSet seen;
  std::vector<Index> kept;
  for (const Index& cell : candidates) seen.emplace(cell, true);
  while (!candidates.empty()) {
    evaluate(candidates, progress);
    std::vector<Index> next;
    for (const Index& cell : candidates) {
      if (!is_kept(cell)) continue;
      kept.push_back(cell);
      for (int a = 0; a < axes(); ++a)
        for (int side = 0; side < 2; ++side) {
          Index neighbour = cell;
          neighbour[a] += side ? stride_ : -stride_;
          if (is_inside(neighbour) && brackets(cell, a, side) &&
              seen.emplace(neighbour, true).second)
            next.push_back(neighbour);
        }
    }
    candidates = std::move(next);
  }
  return kept;
}

void Mdbm::begin(Progress& progress, int every) {
  const std::int64_t width = std::int64_t{every} << kMostHalvings;
  std::vector<Index> all{Index{}};
  for (int a = 0; a < axes(); ++a) {
    const int cells = problem_.axes[static_cast<std::size_t>(a)].cells;
    demand(every >= 1 && cells % every == 0,
           "A first look at each n-th line of the grid needs an n that divides its cells.");
    const std::vector<Index> before = std::move(all);
    all.clear();
    for (Index cell : before)
      for (int i = 0; i < cells / every; ++i) {
        cell[a] = i * width;
        all.push_back(cell);
      }
  }
  judge(std::move(all), width, progress);
}

void Mdbm::halve(Progress& progress) {
  demand(stride_ > 1, "The bisection cannot halve its cells more than twenty times.");
  std::vector<Index> children;
  for (const Index& cell : cells_)
    for (int number = 0; number < 1 << axes(); ++number) {
      Index child = cell;
      for (int a = 0; a < axes(); ++a)
        if (number >> a & 1) child[a] += stride_ / 2;
      children.push_back(child);
    }
  judge(std::move(children), stride_ / 2, progress);
}

std::vector<double> Mdbm::points() const {
  std::vector<double> result;
  for (const Index& cell : cells_) {
    double xi[kMostAxes] = {};
    bool is_there = foot(cell, false, xi);
    if (is_there && problem_.has_constraint && problem_.equations < axes()) {
      double constraint = 0;  // of the plane through the corners, at the foot
      const int corners = 1 << axes();
      for (int number = 0; number < corners; ++number) {
        const double c = values(corner(cell, number))[problem_.equations];
        constraint += c / corners;
        for (int a = 0; a < axes(); ++a) constraint += (number >> a & 1 ? c : -c) * xi[a] / corners;
      }
      if (constraint < 0) is_there = foot(cell, true, xi);
    }
    const bool is_near =
        is_there && std::all_of(xi, xi + axes(), [](double x) { return std::abs(x) <= kNear; });
    for (int a = 0; a < axes(); ++a) {
      const double low = place(cell, a), high = place(corner(cell, 1 << a), a);
      result.push_back(0.5 * (low + high) + (is_near ? 0.5 * (high - low) * xi[a] : 0));
    }
  }
  return result;
}

double Mdbm::brute_force() const {
  double result = 1;
  for (const MdbmAxis& axis : problem_.axes)
    result *= axis.cells * std::ldexp(1.0, kMostHalvings) / static_cast<double>(stride_) + 1;
  return result;
}

double efficiency(const Mdbm& mdbm, double dimension) {
  const double nodes = std::log(mdbm.brute_force()) / mdbm.axes();  // ln of those per side
  return 1 / (std::log(static_cast<double>(mdbm.evaluations().back())) / nodes - dimension);
}

}  // namespace evenload
