#include "ball_end/swept_pass.h"

#include <cmath>
#include <limits>

namespace evenload {

namespace {

constexpr double kNearest = 1e-2;  // mm along the pass, from where on a parabola is the distance
constexpr int kMostHalvings = 60;

}  // namespace

double SweptPass::distance(const Eigen::Vector3d& point) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = -kInfinity, high = kInfinity, s = last_;
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
  for (int i = 0; i < kMostHalvings; ++i) {
    const PathPoint place = surface_->centre(through_ + s * along_, along_);
    away = point - place.at;
    const double pull = away.dot(place.first);  // > 0: the nearest place lies ahead
    (pull > 0 ? low : high) = s;
    const double slope = place.first.squaredNorm() - away.dot(place.second);
    double next = s + pull / slope;
    // Curvature jumps where arcs meet, and Newton's step may leave what is known by then.
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (!std::isfinite(next)) next = s + (pull > 0 ? 1 : -1);
    last_ = next;
    if (std::abs(next - s) < kNearest) return std::sqrt(away.squaredNorm() - pull * pull / slope);
    s = next;
  }
  return away.norm();
}

}  // namespace evenload
