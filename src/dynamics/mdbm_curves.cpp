#include "dynamics/mdbm_curves.h"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "support/solvers.h"

namespace evenload {

namespace {

using Index = Mdbm::Index;
using Facet = std::vector<Index>;  // its nodes, in order

constexpr double kNotZero = 1e-13;  // of a value: those that are 0 are taken as a little above

struct Crossing {
  Eigen::VectorXd place;
  double constraint = 1;
};

class Crossings {
 public:
  explicit Crossings(const Mdbm& mdbm) : mdbm_(mdbm), axes_(mdbm.axes()) { scale(); }

  void add_cell(const Index& cell) {
    std::vector<int> order(static_cast<std::size_t>(axes_));
    std::iota(order.begin(), order.end(), 0);
    do {
      Facet simplex{cell};
      for (const int axis : order) {
        simplex.push_back(simplex.back());
        simplex.back()[axis] += mdbm_.stride();
      }
      add_simplex(simplex);
    } while (std::next_permutation(order.begin(), order.end()));
  }

  std::vector<std::vector<double>> polylines();

 private:
  void scale() {
    sizes_.assign(static_cast<std::size_t>(mdbm_.problem().equations), 0);
    for (const Index& cell : mdbm_.cells())
      for (std::size_t e = 0; e < sizes_.size(); ++e)
        sizes_[e] = std::max(sizes_[e], std::abs(mdbm_.values(cell)[e]));
  }

  // The number of the crossing of a facet, or -1.
  int crossing(const Facet& facet) {
    const auto known = numbers_.find(facet);
    if (known != numbers_.end()) return known->second;
    const int equations = mdbm_.problem().equations;
    Eigen::MatrixXd lhs(axes_, axes_);
    Eigen::VectorXd constraint = Eigen::VectorXd::Ones(axes_);
    for (int n = 0; n < axes_; ++n) {
      const double* value = mdbm_.values(facet[static_cast<std::size_t>(n)]);
      for (int e = 0; e < equations; ++e)
        lhs(e, n) = value[e] == 0 ? kNotZero * sizes_[static_cast<std::size_t>(e)] : value[e];
      lhs(equations, n) = 1;
      if (mdbm_.problem().has_constraint) constraint[n] = value[equations];
    }
    int number = -1;
    const auto share = solved_if_regular(lhs, Eigen::VectorXd::Unit(axes_, axes_ - 1));
    if (share && share->minCoeff() >= 0) {
      Crossing found{Eigen::VectorXd::Zero(axes_), share->dot(constraint)};
      for (int n = 0; n < axes_; ++n)
        for (int a = 0; a < axes_; ++a)
          found.place[a] += (*share)[n] * mdbm_.place(facet[static_cast<std::size_t>(n)], a);
      number = static_cast<int>(crossings_.size());
      crossings_.push_back(found);
      links_.emplace_back();
    }
    numbers_.emplace(facet, number);
    return number;
  }

  void add_simplex(const Facet& simplex) {
    int ends[2], count = 0;
    for (std::size_t left_out = 0; left_out < simplex.size(); ++left_out) {
      Facet facet = simplex;
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(left_out));
      const int number = crossing(facet);
      if (number < 0) continue;
      if (count < 2) ends[count] = number;
      ++count;
    }
    if (count == 2 && ends[0] != ends[1]) join(ends[0], ends[1]);
  }

  // Where the constraint changes sign the line ends on it.
  void join(int a, int b) {
    double at_a = crossings_[static_cast<std::size_t>(a)].constraint;
    double at_b = crossings_[static_cast<std::size_t>(b)].constraint;
    if (at_a <= 0 && at_b <= 0) return;
    if (at_a <= 0) {
      std::swap(a, b);
      std::swap(at_a, at_b);
    }
    if (at_b <= 0) {
      const Eigen::VectorXd from = crossings_[static_cast<std::size_t>(a)].place;
      const Eigen::VectorXd to = crossings_[static_cast<std::size_t>(b)].place;
      crossings_.push_back({from + (to - from) * (at_a / (at_a - at_b)), 0});
      links_.emplace_back();
      b = static_cast<int>(crossings_.size()) - 1;
    }
    links_[static_cast<std::size_t>(a)].push_back(b);
    links_[static_cast<std::size_t>(b)].push_back(a);
  }

  const Mdbm& mdbm_;
  int axes_;
  std::vector<double> sizes_;
  std::map<Facet, int> numbers_;
  std::vector<Crossing> crossings_;
  std::vector<std::vector<int>> links_;
};

std::vector<std::vector<double>> Crossings::polylines() {
  std::vector<std::vector<double>> result;
  std::vector<bool> is_used(crossings_.size(), false);
  const auto walk = [&](int start) {
    std::vector<double> line;
    int here = start, before = -1;
    for (;;) {
      const Crossing& crossing = crossings_[static_cast<std::size_t>(here)];
      line.insert(line.end(), crossing.place.data(), crossing.place.data() + axes_);
      is_used[static_cast<std::size_t>(here)] = true;
      int next = -1;
      for (const int other : links_[static_cast<std::size_t>(here)]) {
        if (!is_used[static_cast<std::size_t>(other)]) next = other;
        if (next < 0 && other == start && before >= 0 && before != start) {
          const Eigen::VectorXd& first = crossings_[static_cast<std::size_t>(start)].place;
          line.insert(line.end(), first.data(), first.data() + axes_);
        }
      }
      if (next < 0) break;
      before = here;
      here = next;
    }
    result.push_back(std::move(line));
  };
  // Open curves from their ends, then those that are closed.
  for (const bool closed : {false, true})
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      if (!is_used[i] && !links_[i].empty() && (closed || links_[i].size() == 1))
        walk(static_cast<int>(i));
  return result;
}

bool is_known(const Mdbm& mdbm, const Index& cell) {
  for (int number = 0; number < 1 << mdbm.axes(); ++number) {
    Index node = cell;
    for (int a = 0; a < mdbm.axes(); ++a)
      if (number >> a & 1) node[a] += mdbm.stride();
    if (!mdbm.values(node)) return false;
  }
  return true;
}

// The kept cells, and with several equations the neighbours that were looked at: the foot of the
// least-squares planes may have left out one that a bent curve passes through.
std::set<Index> with_neighbours(const Mdbm& mdbm) {
  std::set<Index> result(mdbm.cells().begin(), mdbm.cells().end());
  if (mdbm.problem().equations == 1) return result;
  for (const Index& cell : mdbm.cells())
    for (int a = 0; a < mdbm.axes(); ++a)
      for (const int side : {-1, 1}) {
        Index neighbour = cell;
        neighbour[a] += side * mdbm.stride();
        if (is_known(mdbm, neighbour)) result.insert(neighbour);
      }
  return result;
}

}  // namespace

std::vector<std::vector<double>> curves(const Mdbm& mdbm) {
  if (mdbm.problem().equations != mdbm.axes() - 1)
    throw std::invalid_argument("Curves need one equation fewer than there are axes.");
  Crossings crossings(mdbm);
  for (const Index& cell : with_neighbours(mdbm)) crossings.add_cell(cell);
  return crossings.polylines();
}

}  // namespace evenload
