#include "inspection/certificate.h"

#include <algorithm>
#include <cmath>

#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kDifference = 1e-5;  // of the size of all, for second derivatives
constexpr double kBentInwards =
    1e-5;  // share of the bends' size that differences cannot tell from 0
constexpr double kDependent = 1e-9;
constexpr double kLeastBend = 1e-9;
constexpr double kStiffest = 1e6;

// Contacts as rows that all rise with the peak.
struct Touching {
  Which points;
  Eigen::VectorXd sides, heights, multipliers;
  Eigen::MatrixXd slopes;  // a column for each contact
};

Touching touching(const Deviations& at, const Eigen::MatrixXd& directions,
                  const std::vector<Contact>& contacts) {
  Touching result;
  const auto size = static_cast<Eigen::Index>(contacts.size());
  result.sides.resize(size);
  Eigen::VectorXd given(size);
  for (const Contact& each : contacts) {
    const auto j = static_cast<Eigen::Index>(result.points.size());
    result.sides[j] = each.side;
    given[j] = each.multiplier;
    result.points.push_back(each.point);
  }
  const Rows rows = at.rows(result.points);
  result.heights = result.sides.cwiseProduct(rows.values);
  result.slopes = directions.transpose() * rows.gradients * result.sides.asDiagonal();
  // The multipliers that balance best, of sum 1. Where there are many those nearest to what is
  // given, which are above 0: the evenest might have to pull.
  Eigen::MatrixXd system(directions.cols() + 1, size);
  system << result.slopes, Eigen::RowVectorXd::Ones(size);
  Eigen::VectorXd goal = Eigen::VectorXd::Zero(directions.cols() + 1);
  goal[directions.cols()] = 1;
  if (const double sum = given.sum(); sum > 0) given /= sum;
  result.multipliers = given + least_squares(system, goal - system * given);
  return result;
}

// How the contacts, weighted by their multipliers, bend, by differences of gradients.
Eigen::MatrixXd bends(const Deviations& at, const Eigen::MatrixXd& directions,
                      const std::vector<Contact>& contacts, double peak) {
  const Eigen::Index freedom = directions.cols();
  Which points;
  Eigen::VectorXd weights(static_cast<Eigen::Index>(contacts.size()));
  for (const Contact& each : contacts) {
    weights[static_cast<Eigen::Index>(points.size())] = each.multiplier * each.side;
    points.push_back(each.point);
  }
  // Distances from a line bend within their own size.
  const double difference = at.is_two_sided() ? kDifference : std::min(kDifference, 1e-3 * peak);
  Eigen::MatrixXd result(freedom, freedom);
  for (Eigen::Index k = 0; k < freedom; ++k) {
    const double size = difference / directions.col(k).norm();
    const auto weighted = [&](double by) -> Eigen::VectorXd {
      const Rows rows = at.moved(by * directions.col(k))->rows(points);
      return directions.transpose() * (rows.gradients * weights);
    };
    result.col(k) = (weighted(size) - weighted(-size)) / (2 * size);
  }
  return 0.5 * (result + result.transpose());
}

// Steps that keep the contacts level with each other, in columns.
Eigen::MatrixXd level_steps(const Touching& contacts) {
  const Eigen::Index freedom = contacts.slopes.rows(), others = contacts.slopes.cols() - 1;
  if (others == 0) return Eigen::MatrixXd::Identity(freedom, freedom);
  return complement(contacts.slopes.rightCols(others).colwise() - contacts.slopes.col(0),
                    kDependent);
}

}  // namespace

Certificate certificate(const Deviations& at, const Eigen::MatrixXd& directions,
                        const std::vector<Contact>& contacts, double peak, double rounding) {
  Certificate result;
  std::vector<Contact> kept;
  for (const Contact& each : contacts)
    if (each.multiplier > 0) kept.push_back(each);
  if (kept.empty()) return result;
  const Touching touch = touching(at, directions, kept);
  const double sum = touch.multipliers.sum();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].multiplier = touch.multipliers[static_cast<Eigen::Index>(i)] / sum;
    if (kept[i].multiplier > 0) result.contacts.push_back(kept[i]);
  }
  const Eigen::VectorXd left = touch.slopes * touch.multipliers;
  result.imbalance = left.size() ? left.cwiseAbs().maxCoeff() : 0;
  result.gap = peak - touch.heights.dot(touch.multipliers) / sum;
  const double level = contact_level(peak, rounding);
  if (!(touch.multipliers.minCoeff() >= -kMostImbalance && result.imbalance <= kMostImbalance &&
        std::abs(result.gap) <= level && peak - touch.heights.minCoeff() <= level))
    return result;
  const Eigen::MatrixXd free = level_steps(touch);
  result.is_proved = true;
  if (free.cols() > 0) {
    const Eigen::MatrixXd bent = bends(at, directions, result.contacts, peak);
    const double least = axes_of(free.transpose() * bent * free).values[0];
    result.is_proved = least >= -kBentInwards * bent.cwiseAbs().maxCoeff();
  }
  return result;
}

Eigen::MatrixXd safe_bends(const Deviations& at, const Eigen::MatrixXd& directions,
                           const std::vector<Contact>& contacts, double peak, double damping) {
  const Eigen::Index freedom = directions.cols();
  const Eigen::MatrixXd bent = bends(at, directions, contacts, peak);
  const double largest = std::max(bent.cwiseAbs().maxCoeff(), kLeastBend);
  const Eigen::MatrixXd free = level_steps(touching(at, directions, contacts));
  Eigen::MatrixXd result = bent;
  if (free.cols() > 0) {
    const Axes inner = axes_of(free.transpose() * bent * free);
    const Eigen::MatrixXd axes = free * inner.vectors;
    const Eigen::VectorXd wanted =
        inner.values.cwiseAbs().cwiseMax(kLeastBend * largest).array() + damping * largest;
    result += axes * (wanted - inner.values).asDiagonal() * axes.transpose();
  }
  // Across them the contacts decide, however stiff the peak is there.
  const Eigen::MatrixXd across =
      Eigen::MatrixXd::Identity(freedom, freedom) - free * free.transpose();
  for (double stiff = largest; stiff < kStiffest * largest; stiff *= 8) {
    const Eigen::MatrixXd tried = result + stiff * across;
    if (is_positive_definite(tried)) return tried;
  }
  return result + kStiffest * largest * Eigen::MatrixXd::Identity(freedom, freedom);
}

}  // namespace evenload
