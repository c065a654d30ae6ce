#include "strategy/leftover.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Share of the tool's radius between the points.
constexpr double kSpacing = 1.0 / 15;
// The grid is not made of more points than this.
constexpr double kMaximumPoints = 4e7;
// mm: points nearer than this to the edge of the tool's reach are not looked for.
constexpr double kEdge = 0.01;

}  // namespace

void Leftover::prepare(const Area& centres, const Bounds& bounds, const ClearedGround& ground) {
  const double radius = ground.tool_radius();
  const double width = bounds.high.x - bounds.low.x, height = bounds.high.y - bounds.low.y;
  cell_ = std::max(kSpacing * radius, std::sqrt(width * height / kMaximumPoints));
  const int columns = static_cast<int>(std::ceil(width / cell_));
  const int rows = static_cast<int>(std::ceil(height / cell_));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Vec2 p = bounds.low + Vec2{(i + 0.5) * cell_, (j + 0.5) * cell_};
      if (ground.is_cleared_point(p)) continue;
      if (centres.signed_distance(p) < -(radius - kEdge)) continue;
      points_.push_back({p, false});
    }
  prepared_ = true;
}

void Leftover::drop_cleared(const ClearedGround& ground) {
  std::erase_if(points_, [&](const Point& point) { return ground.is_cleared_point(point.p); });
}

double Leftover::area(const ClearedGround& ground) {
  drop_cleared(ground);
  return static_cast<double>(points_.size()) * cell_ * cell_;
}

std::optional<Pose> Leftover::next_start(const ClearedGround& ground, const Area& centres,
                                         Vec2 from) {
  drop_cleared(ground);
  const double radius = ground.tool_radius();
  for (;;) {
    Point* nearest = nullptr;
    for (Point& point : points_)
      if (!point.asked &&
          (!nearest || squared_norm(point.p - from) < squared_norm(nearest->p - from)))
        nearest = &point;
    if (!nearest) return std::nullopt;
    const Vec2 x = nearest->p;
    for (Point& point : points_)  // neighbours belong to the same piece
      if (distance(point.p, x) < 0.5 * radius) point.asked = true;
    // From every side: where the tool just touches the point's surroundings.
    for (int i = 0; i < 24; ++i) {
      const Vec2 outwards = unit(2 * kPi * i / 24);
      double far = 2.5 * radius, near = radius * 0.9;
      const auto usable = [&](double d) {
        const Vec2 p = x + d * outwards;
        return centres.signed_distance(p) >= 0 && ground.is_clear(p);
      };
      double touch = far;
      bool found = false;
      for (double d = radius; d < far; d += 0.1 * radius)
        if (usable(d)) {
          touch = d;
          found = true;
          break;
        }
      if (!found) continue;
      near = touch - 0.1 * radius;
      for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (near + touch);
        (usable(middle) ? touch : near) = middle;
      }
      return Pose{x + touch * outwards, angle_of(-outwards) + kPi / 2};
    }
  }
}

}  // namespace evenload
