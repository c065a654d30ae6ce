// How far points lie from something that can still move: a feature, or a part.
//
// `Deviations` stands for one place of the thing. A step has a number for each degree of freedom,
// in the frame of that place, and `moved` is the place after it. Whatever finds the best place
// knows nothing else of features and parts.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace evenload {

using Columns = Eigen::MatrixXd;
using Which = std::vector<Eigen::Index>;

// Signed distances of points, and how they change with a step.
struct Rows {
  Eigen::VectorXd values;  // a number for each point
  Columns gradients;       // a column for each point, a row for each degree of freedom
};

class Deviations {
 public:
  virtual ~Deviations() = default;
  virtual Eigen::Index count() const = 0;
  virtual Eigen::Index freedom() const = 0;
  // Whether a point may lie on either side, and its sign tells on which. Distances from a line have
  // no sign.
  virtual bool is_two_sided() const = 0;
  virtual std::unique_ptr<Deviations> moved(const Eigen::VectorXd& step) const = 0;
  virtual Rows rows() const = 0;
  virtual Rows rows(const Which& which) const = 0;
};

}  // namespace evenload
