#include "dynamics/modes.h"

#include <cmath>

#include "support/demand.h"

namespace evenload {

void check_modes(const std::vector<Mode>& modes) {
  demand(!modes.empty(), "There is no mode: give at least one, from a tap test or a table.");
  for (const Mode& mode : modes) {
    demand(std::isfinite(mode.mass) && mode.mass > 0,
           "The modal mass of a mode must be a number of kg above 0.");
    demand(std::isfinite(mode.frequency) && mode.frequency > 0,
           "The frequency of a mode must be a number of Hz above 0.");
    demand(std::isfinite(mode.damping_ratio) && mode.damping_ratio >= 0,
           "The damping ratio of a mode must not be negative: 1 % is 0.01.");
    demand(mode.damping_ratio < 1,
           "The damping ratio of a mode must be below 1: give 1 % as 0.01.");
    demand(std::isfinite(mode.direction), "The direction of a mode must be a number of degrees.");
  }
}

std::complex<double> receptance(const Mode& mode, double w) {
  const double wn = mode.frequency;
  return 1.0 / (mode.mass * std::complex<double>(wn * wn - w * w, 2 * mode.damping_ratio * wn * w));
}

Eigen::Matrix2cd receptance(const std::vector<Mode>& modes, double w) {
  Eigen::Matrix2cd sum = Eigen::Matrix2cd::Zero();
  for (const Mode& mode : modes) {
    const Eigen::Vector2d along(std::cos(mode.direction), std::sin(mode.direction));
    sum += receptance(mode, w) * (along * along.transpose()).cast<std::complex<double>>();
  }
  return sum;
}

std::vector<Mode> turned(const std::vector<Mode>& modes, double angle) {
  std::vector<Mode> result = modes;
  for (Mode& mode : result) mode.direction -= angle;
  return result;
}

}  // namespace evenload
