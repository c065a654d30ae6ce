// The points that lie furthest outside, without a look at all of them each time.
//
// A short list of candidates is asked first. Where none of them lies outside all points are looked
// at once, in groups of neighbours, and the worst of each group joins the list.
#pragma once

#include <optional>

#include "inspection/deviations.h"

namespace evenload {

// A side of a point: 1 where its deviation is positive, -1 where it is negative.
struct Side {
  Eigen::Index point;
  int side;
};

class Candidates {
 public:
  // Condition: `rows` outlives this; deviations are |value + gradient * step|, or without the bars.
  Candidates(const Rows& rows, bool is_two_sided);

  // The point that is highest at a step of 0.
  Side highest() const { return {points_.front(), side_of(rows_.values[points_.front()])}; }
  // The one that rises furthest above `level` after a step, where that is more than `rounding`.
  std::optional<Side> worst(const Eigen::VectorXd& step, double level, double rounding);

 private:
  double deviation(Eigen::Index i, const Eigen::VectorXd& step) const {
    return rows_.values[i] + rows_.gradients.col(i).dot(step);
  }
  int side_of(double value) const { return is_two_sided_ && value < 0 ? -1 : 1; }
  double height(double value) const { return is_two_sided_ && value < 0 ? -value : value; }
  std::optional<Side> worst_of(const Which& points, const Eigen::VectorXd& step,
                               double level) const;
  Which worst_of_groups(const Eigen::VectorXd& step, double level) const;

  const Rows& rows_;
  bool is_two_sided_;
  Which points_;
};

}  // namespace evenload
