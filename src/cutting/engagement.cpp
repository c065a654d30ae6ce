#include "cutting/engagement.h"

#include <cmath>
#include <stdexcept>

#include "geometry/vec2.h"

namespace evenload {

double side_step(double angle, double radius) { return radius * (1 - std::cos(angle)); }

double engagement_angle(double step, double radius) { return std::acos(1 - step / radius); }

double side_step_on_contour(double angle, double radius, double curvature_radius, Contour contour) {
  const double k = contour == Contour::kConcave ? -1 : 1;
  const double across = radius * std::sin(angle);
  if (curvature_radius < across)
    throw std::invalid_argument(
        "the contour's radius of curvature is below r sin(theta): no side "
        "step gives this engagement");
  return side_step(angle, radius) + k * curvature_radius -
         k * std::sqrt(curvature_radius * curvature_radius - across * across);
}

double largest_chip_thickness(double angle, double feed_per_tooth) {
  return angle < kPi / 2 ? feed_per_tooth * std::sin(angle) : feed_per_tooth;
}

double mean_chip_thickness(double angle, double feed_per_tooth) {
  return angle > 0 ? feed_per_tooth * (1 - std::cos(angle)) / angle : 0;
}

}  // namespace evenload
