#include "ball_end/bent_surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace evenload {

namespace {

// A circle of curvature k through the origin, which it leaves along x, bending down where k > 0.
struct Arc {
  double sine, cosine, x, y;  // of the angle at s, and the place there

  Arc(double k, double s) : sine(std::sin(k * s)), cosine(std::cos(k * s)) {
    const double half = std::sin(k * s / 2);
    x = k != 0 ? sine / k : s;
    y = k != 0 ? -2 * half * half / k : 0;
  }
};

// How far (x, y) lies outside of that circle; for k = 0 above the line.
double height_above(double k, double x, double y) {
  const double to_centre = std::hypot(1 + k * y, k * x);
  return (2 * y + k * (x * x + y * y)) / (to_centre + 1);
}

}  // namespace

BentSurface::BentSurface(const BentPlace& place, double ball_radius, Steps steps)
    : first_(place.first), second_(place.second), ball_radius_(ball_radius), stretch_{1, 1} {
  if (!std::isfinite(first_) || !std::isfinite(second_) || !std::isfinite(place.towards) ||
      !(place.slope >= 0 && place.slope < kPi / 2))
    throw std::invalid_argument(
        "A patch needs two curvatures in 1/mm, a slope from 0 to below 90 degrees and the "
        "direction "
        "in which it leans.");
  const Vec2 stretch{1 + first_ * ball_radius, 1 + second_ * ball_radius};
  if (!(stretch.x > 0 && stretch.y > 0))
    throw std::invalid_argument(
        "The ball does not fit into the concave surface: take a tool whose radius is smaller.");
  if (steps == Steps::kPlan)
    throw std::invalid_argument(
        "Steps on a patch are measured on the centre or on the surface, not in plan.");
  if (steps == Steps::kSurface) stretch_ = stretch;
  const Vec2 lean = unit(place.towards);
  to_tool_ = Eigen::AngleAxisd(place.slope, Eigen::Vector3d(-lean.y, lean.x, 0)).toRotationMatrix();
}

PathPoint BentSurface::centre(Vec2 at, Vec2 along) const {
  const double k = first_ / (1 + first_ * ball_radius_), l = second_ / (1 + second_ * ball_radius_);
  const Arc u(k, at.x * stretch_.x), v(l, at.y * stretch_.y);
  const double du = along.x * stretch_.x, dv = along.y * stretch_.y;
  // The first circle, at the height u.y above the second one's, is turned with that.
  const double radial = 1 + l * u.y;  // of its place, over the second circle's radius
  const Eigen::Vector3d place(u.x, v.x * radial, v.y + u.y * v.cosine);
  const Eigen::Vector3d by_u(u.cosine, -u.sine * v.sine, -u.sine * v.cosine);
  const Eigen::Vector3d by_v(0, v.cosine * radial, -v.sine * radial);
  const Eigen::Vector3d by_uu =
      -k * Eigen::Vector3d(u.sine, u.cosine * v.sine, u.cosine * v.cosine);
  const Eigen::Vector3d by_uv = -l * u.sine * Eigen::Vector3d(0, v.cosine, -v.sine);
  const Eigen::Vector3d by_vv = -l * radial * Eigen::Vector3d(0, v.sine, v.cosine);
  const Eigen::Vector3d apex(0, 0, ball_radius_);
  return {to_tool_ * (apex + place), to_tool_ * (du * by_u + dv * by_v),
          to_tool_ * (du * du * by_uu + 2 * du * dv * by_uv + dv * dv * by_vv)};
}

double BentSurface::distance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = to_tool_.transpose() * point;
  return height_above(first_, p.x(), height_above(second_, p.y(), p.z()));
}

Eigen::Vector3d BentSurface::normal(Vec2 at) const {
  const double k = first_ / (1 + first_ * ball_radius_), l = second_ / (1 + second_ * ball_radius_);
  const Arc u(k, at.x * stretch_.x), v(l, at.y * stretch_.y);
  return to_tool_ * Eigen::Vector3d(u.sine, u.cosine * v.sine, u.cosine * v.cosine);
}

}  // namespace evenload
