#include "inspection/candidates.h"

#include <algorithm>
#include <limits>

namespace evenload {

namespace {

constexpr Eigen::Index kGroups = 48;

}  // namespace

Candidates::Candidates(const Rows& rows, bool is_two_sided)
    : rows_(rows), is_two_sided_(is_two_sided) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(rows.gradients.rows());
  points_ = worst_of_groups(none, -std::numeric_limits<double>::infinity());
  std::stable_sort(points_.begin(), points_.end(), [this](Eigen::Index a, Eigen::Index b) {
    return height(rows_.values[a]) > height(rows_.values[b]);
  });
}

std::optional<Side> Candidates::worst(const Eigen::VectorXd& step, double level, double rounding) {
  if (const std::optional<Side> known = worst_of(points_, step, level + rounding)) return known;
  const Which fresh = worst_of_groups(step, level + rounding);
  points_.insert(points_.end(), fresh.begin(), fresh.end());
  return worst_of(fresh, step, level + rounding);
}

std::optional<Side> Candidates::worst_of(const Which& points, const Eigen::VectorXd& step,
                                         double level) const {
  std::optional<Side> found;
  for (const Eigen::Index i : points) {
    const double value = deviation(i, step);
    if (height(value) <= level) continue;
    level = height(value);
    found = {i, side_of(value)};
  }
  return found;
}

Which Candidates::worst_of_groups(const Eigen::VectorXd& step, double level) const {
  const Eigen::Index count = rows_.values.size();
  const Eigen::Index group = std::max<Eigen::Index>(1, (count + kGroups - 1) / kGroups);
  Which result;
  for (Eigen::Index first = 0; first < count; first += group) {
    Eigen::Index worst = -1;
    double most = level;
    for (Eigen::Index i = first; i < std::min(first + group, count); ++i) {
      const double found = height(deviation(i, step));
      if (found <= most) continue;
      most = found;
      worst = i;
    }
    if (worst >= 0) result.push_back(worst);
  }
  return result;
}

}  // namespace evenload
