// Multi-dimensional bisection: the set {x in a box: f(x) = 0}, found with few evaluations.
//
// 1. Every node of a coarse grid is evaluated. 2. Cells whose corners bracket all equations are
// kept; with several equations those, too, must have the foot of the least-squares plane near.
// 3. Through each face that brackets, the neighbour is looked at, until nothing is new: a set once
// touched is followed to its end. 4. Cells are halved, and again from 2.
// Where there is a constraint c(x) > 0, cells that it leaves out at all corners are dropped. So are
// poles, where an equation changes its sign through infinity: in a component whose cells mostly
// have larger values than before they were halved, some are bisected until the values tell.
//
// What is found for certain: each component that separates nodes of the first grid. A disc of
// radius r is hit when the cells are no wider than r sqrt 2; what is smaller may be overlooked.
// Laws: the points' distance from a smooth set falls by 4 with each halving; closed curves are
// closed; factors of f and the order of the axes change nothing; neither does the number of
// threads. Source: [Bachrathy & Stepan 2012], [Bachrathy 2013, thesis 7].
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "support/progress.h"

namespace evenload {

inline constexpr int kMostAxes = 4;
inline constexpr int kMostHalvings = 20;

struct MdbmAxis {
  double low = 0, high = 1;
  int cells = 1;  // of the first grid
};

struct MdbmProblem {
  std::vector<MdbmAxis> axes;  // 1 to kMostAxes
  int equations = 1;           // 1 to the number of axes
  bool has_constraint = false;
  // From a place, one number for each axis, to the equations' values, and c behind them.
  std::function<void(const double* place, double* values)> evaluate;
  int threads = 1;
};

class Mdbm {
 public:
  using Index = std::array<std::int64_t, kMostAxes>;  // of a node, 2^kMostHalvings to a first cell

  // Throws std::invalid_argument for a problem that breaks the conditions above.
  explicit Mdbm(MdbmProblem problem);

  // Evaluates the first grid; then each call halves the cells. Throws Cancelled where `progress`
  // says so, and keeps what it has. With `every` above 1, which must divide the axes' cells, begin
  // takes each every-th line of the grid, for a quick look before begin at 1 takes them all.
  void begin(Progress& progress, int every = 1);
  void halve(Progress& progress);

  int axes() const { return static_cast<int>(problem_.axes.size()); }
  const MdbmProblem& problem() const { return problem_; }
  std::int64_t stride() const { return stride_; }  // between neighbours
  // Lowest corners of the kept cells, in the order of their indices.
  const std::vector<Index>& cells() const { return cells_; }
  // One place for each cell, `axes()` numbers each.
  std::vector<double> points() const;
  // After the first grid, and after each halving.
  const std::vector<std::int64_t>& evaluations() const { return evaluations_; }
  // Of all on a full grid as fine as the last: the product over the axes of its nodes.
  double brute_force() const;
  // Components of cells that share a corner: a number for each cell, from 0 on.
  std::vector<int> components() const;

  double place(const Index& node, int axis) const;
  const double* values(const Index& node) const;  // null where it was not evaluated

 private:
  struct Hash {
    std::size_t operator()(const Index& index) const;
  };
  using CellSet = std::unordered_map<Index, bool, Hash>;

  int value_count() const { return problem_.equations + (problem_.has_constraint ? 1 : 0); }
  Index corner(const Index& cell, int number) const;
  bool is_inside(const Index& cell) const;
  void evaluate(const std::vector<Index>& cells, Progress& progress);
  bool brackets(const Index& cell, int axis, int side) const;
  bool is_kept(const Index& cell) const;
  bool foot(const Index& cell, bool with_constraint, double* xi) const;
  double mean_size(const Index& cell, std::int64_t stride, int equation) const;
  bool is_pole(std::vector<Index> cells, int equation);
  void drop_poles();
  bool is_pole(const Index& cell, int equation);
  void judge(std::vector<Index> candidates, std::int64_t width, Progress& progress);
  std::vector<Index> all_that_hold(std::vector<Index> candidates, Progress& progress);

  MdbmProblem problem_;
  std::int64_t stride_;
  std::unordered_map<Index, std::size_t, Hash> nodes_;
  std::vector<double> values_;
  std::vector<Index> cells_;
  std::vector<std::int64_t> evaluations_;
  std::int64_t looks_between_ = 0;
};

// E = 1/(D_P - dimension), D_P = ln(evaluations)/ln(nodes per side of the last grid), geometric
// mean over the axes: brute force has 1/(axes - dimension), which is 1/equations for smooth sets.
double efficiency(const Mdbm& mdbm, double dimension);

}  // namespace evenload
