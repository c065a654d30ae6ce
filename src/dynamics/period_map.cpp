#include "dynamics/period_map.h"

#include <algorithm>
#include <cmath>

#include "dynamics/collocation.h"
#include "dynamics/element.h"
#include "support/errors.h"
#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kSame = 1e-12;  // relative, of a delay and the period
// rad of the fastest vibration in an element at the accuracy 1; measured so that errors stay below
// the accuracy aimed at (tests/cpp/dynamics_stability_test.cpp).
constexpr double kMapElement = 7.0;
constexpr double kMeasured = 30;  // rad of the fastest vibration in the periods measured

}  // namespace

PeriodMap::PeriodMap(const PeriodicSystem& system, double accuracy, int refinement)
    : width_(system.width),
      state_(2 * static_cast<int>(system.modes.size())),
      looks_straight_back_(system.delays.size() == 1 &&
                           std::abs(system.delays[0] - system.period) < kSame * system.period) {
  slots_ = looks_straight_back_ ? kStages : kStages + 2;
  size_ = state_;
  // Each element adds to the error.
  const double share =
      std::min(accuracy, 1.0) / std::max(1.0, system.fastest * system.period / kMeasured);
  double longest = kMapElement * std::pow(share, 0.5 / kStages) / system.fastest;
  // What is looked at lies in an earlier element.
  if (!looks_straight_back_)
    longest = std::min(longest, *std::min_element(system.delays.begin(), system.delays.end()));
  for (const PeriodPiece& piece : system.pieces) {
    const double length = piece.end - piece.start;
    if (!piece.active) {
      starts_.push_back(piece.start);
      lengths_.push_back(length);
      add_idle(system, length);
      continue;
    }
    const int count = refinement * std::max(1, static_cast<int>(std::ceil(length / longest)));
    for (int i = 0; i < count; ++i) {
      starts_.push_back(piece.start + length * i / count);
      lengths_.push_back(length / count);
      add_active(system, starts_.back(), lengths_.back());
    }
  }
  find_looks(system);
}

void PeriodMap::add_idle(const PeriodicSystem& system, double length) {
  Element element;
  element.first = size_;
  element.active = false;
  element.from = Eigen::MatrixXd::Zero(state_, state_);
  for (int r = 0; 2 * r < state_; ++r)
    element.from.block<2, 2>(2 * r, 2 * r) = free_motion(system.modes[r], length);
  elements_.push_back(std::move(element));
}

void PeriodMap::add_active(const PeriodicSystem& system, double start, double length) {
  const ElementResponse response(system.modes, width_, length);
  const int forces = kStages * width_, values = slots_ * width_;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(forces, forces), damping = stiffness;
  Element element;
  element.first = size_;
  element.active = true;
  size_ += values;
  Coefficients c;
  c.delayed.resize(system.delays.size());
  element.delayed.resize(system.delays.size() * kStages * width_ * width_);
  for (int i = 0; i < kStages; ++i) {
    system.coefficients(start + length * collocation().node[i], c);
    stiffness.block(i * width_, i * width_, width_, width_) =
        c.stiffness.topLeftCorner(width_, width_);
    damping.block(i * width_, i * width_, width_, width_) = c.damping.topLeftCorner(width_, width_);
    for (std::size_t j = 0; j < c.delayed.size(); ++j)
      for (int row = 0; row < width_; ++row)
        for (int column = 0; column < width_; ++column)
          element.delayed[((j * kStages + i) * width_ + row) * width_ + column] =
              c.delayed[j](row, column);
  }
  // Forces at the nodes: F = -K (q0 + G F) - D (v0 + Gv F) + delayed.
  const Eigen::MatrixXd lhs = Eigen::MatrixXd::Identity(forces, forces) +
                              stiffness.lazyProduct(response.value_by_force) +
                              damping.lazyProduct(response.speed_by_force);
  Eigen::MatrixXd rhs(forces, state_ + forces);
  rhs.leftCols(state_) = -stiffness.lazyProduct(response.value_by_state) -
                         damping.lazyProduct(response.speed_by_state);
  rhs.rightCols(forces).setIdentity();
  const Eigen::MatrixXd force = columns_solved(lhs, rhs);
  element.from.resize(values + state_, state_ + forces);
  const int nodes = looks_straight_back_ ? 0 : width_;  // the start's value comes first
  auto at_nodes = element.from.middleRows(nodes, forces);
  at_nodes.noalias() = response.value_by_force * force;
  at_nodes.leftCols(state_) += response.value_by_state;
  auto end = element.from.bottomRows(state_);
  end.noalias() = response.end_by_force * force;
  end.leftCols(state_) += response.end_by_state;
  if (!looks_straight_back_) {
    element.from.topRows(width_).setZero();
    element.from.topLeftCorner(width_, state_) = response.value_of_state;
    element.from.middleRows(nodes + forces, width_).noalias() = response.value_of_state * end;
  }
  elements_.push_back(std::move(element));
}

void PeriodMap::find_looks(const PeriodicSystem& system) {
  if (looks_straight_back_) return;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    Element& element = elements_[e];
    if (!element.active) continue;
    for (const double delay : system.delays)
      for (int i = 0; i < kStages; ++i) {
        double time = starts_[e] + lengths_[e] * collocation().node[i] - delay;
        Look look{};
        look.now = time >= 0;
        if (!look.now) time += system.period;
        const auto after = std::upper_bound(starts_.begin(), starts_.end(), time);
        const std::size_t found = static_cast<std::size_t>(after - starts_.begin()) - 1;
        const auto weights = collocation().interpolation((time - starts_[found]) / lengths_[found]);
        look.first = elements_[found].first;
        look.count = elements_[found].active ? kStages + 2 : 0;  // nothing was cut there
        EVENLOAD_ASSERT(!look.now || found < e);
        std::copy(weights.begin(), weights.end(), look.weight);
        element.looks.push_back(look);
      }
  }
}

void PeriodMap::gather(const Element& element, const double* before, const double* after,
                       double* force) const {
  const int square = width_ * width_;
  std::fill(force, force + kStages * width_, 0.0);
  const std::size_t delays = element.delayed.size() / (kStages * square);
  for (std::size_t j = 0; j < delays; ++j)
    for (int i = 0; i < kStages; ++i) {
      const double* matrix = &element.delayed[(j * kStages + i) * square];
      double q[2] = {0, 0};
      if (looks_straight_back_) {
        for (int k = 0; k < width_; ++k) q[k] = before[element.first + i * width_ + k];
      } else {
        const Look& look = element.looks[j * kStages + i];
        const double* values = (look.now ? after : before) + look.first;
        for (int n = 0; n < look.count; ++n)
          for (int k = 0; k < width_; ++k) q[k] += look.weight[n] * values[n * width_ + k];
      }
      for (int row = 0; row < width_; ++row)
        for (int k = 0; k < width_; ++k) force[i * width_ + row] += matrix[row * width_ + k] * q[k];
    }
}

void PeriodMap::apply(const double* before, double* after) const {
  Eigen::VectorXd in(state_ + kStages * width_), out(state_ + slots_ * width_);
  in.head(state_) = Eigen::Map<const Eigen::VectorXd>(before, state_);
  for (const Element& element : elements_) {
    if (!element.active) {
      in.head(state_) = (element.from * in.head(state_)).eval();
      continue;
    }
    gather(element, before, after, in.data() + state_);
    out.noalias() = element.from * in;
    std::copy_n(out.data(), slots_ * width_, after + element.first);
    in.head(state_) = out.tail(state_);
  }
  std::copy_n(in.data(), state_, after);
}

std::vector<PeriodMap::Node> PeriodMap::nodes() const {
  std::vector<Node> result;
  const int before = looks_straight_back_ ? 0 : width_;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int i = 0; i < kStages && elements_[e].active; ++i)
      result.push_back({elements_[e].first + before + i * width_,
                        starts_[e] + lengths_[e] * collocation().node[i],
                        lengths_[e] * collocation().weight[i]});
  return result;
}

}  // namespace evenload
