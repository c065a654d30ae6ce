#include "inspection/bent_step.h"

#include <algorithm>
#include <optional>

#include "inspection/candidates.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr int kMostJoining = 200;
constexpr double kMixture = 1e-10;
constexpr double kLeastPart = 1e-11;

class BentProgramme {
 public:
  BentProgramme(const Rows& rows, bool is_two_sided, const Eigen::MatrixXd& bends, double rounding)
      : rows_(rows), candidates_(rows, is_two_sided), bends_(bends), rounding_(rounding) {}

  ExchangeStep solve() {
    touching_ = {candidates_.highest()};
    multipliers_ = Eigen::VectorXd::Ones(1);
    bool is_solved = false;
    for (int i = 0; i < kMostJoining && settle(); ++i) {
      const std::optional<Side> worst = candidates_.worst(step_, level_, rounding_);
      if (!worst) {
        is_solved = true;
        break;
      }
      if (!take(*worst)) break;
    }
    ExchangeStep found{step_, level_, {}, is_solved};
    for (std::size_t j = 0; j < touching_.size(); ++j)
      found.contacts.push_back(
          {touching_[j].point, touching_[j].side, multipliers_[static_cast<Eigen::Index>(j)]});
    return found;
  }

 private:
  // Gradient and 1 of a side: what its multiplier adds to the balance.
  Eigen::VectorXd pressing(const Side& side) const {
    Eigen::VectorXd result(rows_.gradients.rows() + 1);
    result << side.side * rows_.gradients.col(side.point), 1;
    return result;
  }
  Eigen::MatrixXd pressing() const {
    Eigen::MatrixXd result(rows_.gradients.rows() + 1, static_cast<Eigen::Index>(touching_.size()));
    for (Eigen::Index j = 0; j < result.cols(); ++j)
      result.col(j) = pressing(touching_[static_cast<std::size_t>(j)]);
    return result;
  }

  // The best step of the touching points alone, all of them level; lets go whoever would have to
  // pull. False where the numbers fail.
  bool settle() {
    for (;;) {
      const Eigen::VectorXd wanted = level();
      if (!wanted.allFinite()) return false;
      double share = 1;
      Eigen::Index leaving = -1;
      for (Eigen::Index j = 0; j < wanted.size(); ++j) {
        if (wanted[j] > 0) continue;
        const double fall = multipliers_[j] - wanted[j];
        const double until = fall > 0 ? multipliers_[j] / fall : 0;
        if (leaving < 0 || until < share) {
          share = until;
          leaving = j;
        }
      }
      if (leaving < 0) {
        multipliers_ = wanted;
        return true;
      }
      if (touching_.size() == 1) return false;  // one contact holds by itself but for rounding
      multipliers_ += share * (wanted - multipliers_);
      drop(leaving);
    }
  }

  // Multipliers of the touching points that balance with the bends where all are level; sets the
  // step and the level.
  Eigen::VectorXd level() {
    const Eigen::Index freedom = rows_.gradients.rows();
    const auto count = static_cast<Eigen::Index>(touching_.size());
    const Eigen::MatrixXd forces = pressing();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(freedom + count + 1, freedom + count + 1);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(freedom + count + 1);
    system.topLeftCorner(freedom, freedom) = bends_;
    system.block(0, freedom, freedom, count) = forces.topRows(freedom);
    system.block(freedom, 0, count, freedom) = forces.topRows(freedom).transpose();
    system.block(freedom, freedom + count, count, 1).setConstant(-1);
    system.block(freedom + count, freedom, 1, count).setConstant(1);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Side& each = touching_[static_cast<std::size_t>(j)];
      right[freedom + j] = -each.side * rows_.values[each.point];
    }
    right[freedom + count] = 1;
    const Eigen::VectorXd found = solved_carefully(system, right);
    step_ = found.head(freedom);
    level_ = found[freedom + count];
    return found.segment(freedom, count);
  }

  // A point joins; where its pressing is a mixture of the others', one of these leaves at once.
  bool take(const Side& entering) {
    const Eigen::MatrixXd forces = pressing();
    const Eigen::VectorXd force = pressing(entering);
    const Eigen::VectorXd mixture = least_squares(forces, force);
    double added = 0;
    if ((forces * mixture - force).norm() <= kMixture * force.norm()) {
      Eigen::Index leaving = -1;
      for (Eigen::Index j = 0; j < mixture.size(); ++j) {
        if (mixture[j] <= kLeastPart) continue;
        const double until = multipliers_[j] / mixture[j];
        if (leaving >= 0 && until >= added) continue;
        added = until;
        leaving = j;
      }
      if (leaving < 0) return false;
      multipliers_ -= added * mixture;
      drop(leaving);
    }
    touching_.push_back(entering);
    multipliers_.conservativeResize(multipliers_.size() + 1);
    multipliers_[multipliers_.size() - 1] = added;
    return true;
  }

  void drop(Eigen::Index leaving) {
    touching_.erase(touching_.begin() + leaving);
    const Eigen::Index behind = multipliers_.size() - 1 - leaving;
    multipliers_.segment(leaving, behind) = multipliers_.tail(behind).eval();
    multipliers_.conservativeResize(multipliers_.size() - 1);
    multipliers_ = multipliers_.cwiseMax(0).eval();
  }

  const Rows& rows_;
  Candidates candidates_;
  const Eigen::MatrixXd& bends_;
  double rounding_;
  std::vector<Side> touching_;
  Eigen::VectorXd multipliers_, step_;
  double level_ = 0;
};

}  // namespace

ExchangeStep best_bent_step(const Rows& rows, bool is_two_sided, const Eigen::MatrixXd& bends,
                            double rounding) {
  return BentProgramme(rows, is_two_sided, bends, rounding).solve();
}

}  // namespace evenload
