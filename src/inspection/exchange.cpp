#include "inspection/exchange.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "inspection/candidates.h"

namespace evenload {

namespace {

constexpr int kMost = kMostFreedom + 1;
using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;

constexpr int kMostExchanges = 400;  // some 20 are usual: more is a cycle
constexpr double kLeastPivot = 1e-11;
constexpr double kFar = 1e6;     // a step that long is held by nothing: slopes are about 1
constexpr double kLevel = 1e-9;  // of a point that is raised by 1
constexpr double kSlack = 1e-3;  // share of the reach that steps may go beyond it: it is no law

// A bound of the programme: of a point, or of the reach, where `point` is -1 - (number of the
// step).
struct Bound {
  Eigen::Index point;
  int side;
};

class Programme {
 public:
  Programme(const Rows& rows, bool is_two_sided, double reach, double rounding)
      : rows_(rows),
        candidates_(rows, is_two_sided),
        reach_(reach),
        rounding_(rounding),
        freedom_(rows.gradients.rows()) {}

  ExchangeStep solve() {
    begin();
    bool is_solved = false;
    for (int i = 0; i < kMostExchanges; ++i) {
      place();
      Bound worst{};
      if (!find_worst(worst)) {
        is_solved = true;
        break;
      }
      if (!take(worst)) break;
    }
    return result(is_solved);
  }

 private:
  void begin() {
    const Side highest = candidates_.highest();
    basis_.push_back({highest.point, highest.side});
    // The reach balances this point's gradient.
    for (Eigen::Index k = 0; k < freedom_; ++k)
      basis_.push_back({-1 - k, highest.side * rows_.gradients(k, highest.point) >= 0 ? 1 : -1});
  }

  Small normal_of(const Bound& bound) const {
    Small normal = Small::Zero(freedom_ + 1);
    if (bound.point < 0) {
      normal[-1 - bound.point] = bound.side;
    } else {
      normal.head(freedom_) = -bound.side * rows_.gradients.col(bound.point);
      normal[freedom_] = 1;
    }
    return normal;
  }
  double limit_of(const Bound& bound) const {
    return bound.point < 0 ? -reach_ : bound.side * rows_.values[bound.point];
  }

  // The step at which all bounds of the basis hold, and the multipliers that balance them.
  void place() {
    const Eigen::Index n = freedom_ + 1;
    Square normals(n, n);
    Small limits(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Bound& bound = basis_[static_cast<std::size_t>(j)];
      normals.row(j) = normal_of(bound).transpose();
      limits[j] = limit_of(bound);
    }
    const Small at = normals.partialPivLu().solve(limits);
    step_ = at.head(freedom_);
    level_ = at[freedom_];
    transposed_.compute(normals.transpose());
    Small goal = Small::Zero(n);
    goal[freedom_] = 1;
    multipliers_ = transposed_.solve(goal);
  }

  // The bound of a point, or of the reach, that is broken most.
  bool find_worst(Bound& worst) {
    double most = kSlack * reach_ + rounding_;
    bool is_found = false;
    for (Eigen::Index k = 0; k < freedom_; ++k) {
      const double outside = std::abs(step_[k]) - reach_;
      if (outside <= most) continue;
      most = outside;
      worst = {-1 - k, step_[k] < 0 ? 1 : -1};
      is_found = true;
    }
    if (is_found) return true;
    const std::optional<Side> point = candidates_.worst(step_, level_, rounding_);
    if (point) worst = {point->point, point->side};
    return point.has_value();
  }

  // Takes a bound into the basis and lets that one go whose multiplier comes to 0 first.
  bool take(const Bound& entering) {
    const Small share = transposed_.solve(normal_of(entering));
    Eigen::Index leaving = -1;
    double least = 0;
    for (Eigen::Index j = 0; j <= freedom_; ++j) {
      if (share[j] <= kLeastPivot) continue;
      const double ratio = std::max(multipliers_[j], 0.0) / share[j];
      const bool is_tie = leaving >= 0 && ratio <= least * (1 + 1e-12);
      if (leaving < 0 || ratio < least || (is_tie && share[j] > share[leaving])) {
        least = ratio;
        leaving = j;
      }
    }
    if (leaving < 0) return false;
    basis_[static_cast<std::size_t>(leaving)] = entering;
    return true;
  }

  ExchangeStep result(bool is_solved) const {
    ExchangeStep found{step_, level_, {}, is_solved};
    for (std::size_t j = 0; j < basis_.size(); ++j)
      if (basis_[j].point >= 0)
        found.contacts.push_back({basis_[j].point, basis_[j].side,
                                  std::max(0.0, multipliers_[static_cast<Eigen::Index>(j)])});
    return found;
  }

  const Rows& rows_;
  Candidates candidates_;
  double reach_, rounding_;
  Eigen::Index freedom_;
  std::vector<Bound> basis_;
  Eigen::VectorXd step_;
  Small multipliers_;
  double level_ = 0;
  Eigen::PartialPivLU<Square> transposed_;
};

}  // namespace

ExchangeStep best_linear_step(const Rows& rows, bool is_two_sided, double reach, double rounding) {
  return Programme(rows, is_two_sided, reach, rounding).solve();
}

Eigen::VectorXd shared_multipliers(const Columns& slopes) {
  const Eigen::Index count = slopes.cols();
  Eigen::VectorXd shared = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (shared[i] > 0) continue;
    // A point that is raised above the others presses, where these can hold it.
    const Rows raised{Eigen::VectorXd::Unit(count, i), slopes};
    Eigen::VectorXd pressing = Eigen::VectorXd::Zero(count);
    for (const Contact& each : best_linear_step(raised, false, kFar, kLevel).contacts)
      pressing[each.point] = each.multiplier;
    if ((slopes * pressing).norm() <= kLevel) shared += pressing;
  }
  return shared;
}

}  // namespace evenload
