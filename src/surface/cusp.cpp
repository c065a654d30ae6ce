#include "surface/cusp.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

constexpr double kSteepest = 4;        // rise over run across a strip beyond which no pass helps
constexpr double kNarrowest = 0.05;    // of the stepover on level ground; no strip is narrower
constexpr double kWidestStrip = 4;     // of the same; none is wider
constexpr double kExact = 0.005;       // of the cusp's height
constexpr double kNoise = 0.02;        // of it, that triangles may make in what is found
constexpr double kMostOfCorner = 0.5;  // the widest strip on which a curvature is found
constexpr int kMostTries = 24;

}  // namespace

double cusp_of(double corner, double stepover) {
  return corner - std::sqrt((corner - 0.5 * stepover) * (corner + 0.5 * stepover));
}

double stepover_for(double corner, double cusp_height) {
  const double height = std::min(cusp_height, corner);
  return 2 * std::sqrt(height * (2 * corner - height));
}

CuspRule::CuspRule(const Ground& ground, double cusp_height, double deflection)
    : wish_(cusp_height),
      corner_(ground.cutter.corner),  // with an allowance it is the offset face that it cuts
      level_(stepover_for(corner_, cusp_height)),
      widening_(std::max(1.0, std::sqrt(deflection / (kNoise * cusp_height)))) {}

double CuspRule::strip_for(double width, double covered) const {
  return std::clamp(widening_ * width, width,
                    std::max(width, std::min(kMostOfCorner * corner_, covered)));
}

double CuspRule::height(double width, double wide, double one, double middle, double other,
                        double slope) const {
  if (std::abs(other - one) > kSteepest * wide) return kNothing;
  const double share = width / wide;
  const SpacePoint feed = (1 / std::sqrt(1 + slope * slope)) * SpacePoint{1, 0, slope};
  SpacePoint between{0, width, share * (other - one)};
  between = between - dot(between, feed) * feed;
  const double apart = norm(between);
  const SpacePoint normal = (1 / apart) * cross(feed, between);
  const double above = share * share * (middle - 0.5 * (one + other)) * normal.z;
  return cusp_of(corner_, std::min(apart, 2 * corner_)) - above;
}

double CuspRule::widest(double guess, const std::function<double(double)>& height_of) const {
  double low = 0, high = std::min(kWidestStrip * level_, 1.8 * corner_), best = 0;
  double step = std::min(guess, high);
  for (int i = 0; i < kMostTries && high - low > 1e-4 * level_; ++i) {
    const double height = height_of(step);
    if (height == kNothing) return level_;
    if (height <= wish_) {
      best = low = step;
      if (height > (1 - kExact) * wish_) break;
    } else {
      high = step;
    }
    // A cusp grows as the square of the distance.
    const double wanted = step * std::sqrt((1 - 0.5 * kExact) * wish_ / std::max(height, 1e-12));
    step = wanted > low && wanted < high ? wanted : 0.5 * (low + high);
  }
  return std::max(best, kNarrowest * level_);
}

}  // namespace evenload
