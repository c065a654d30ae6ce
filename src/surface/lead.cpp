#include "surface/lead.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

constexpr double kBite = 0.1;  // of the tolerance, into the part
constexpr int kHalvings = 3;
constexpr double kShortest = 1e-6;  // mm: lines without a direction

// The corners of the arc; none where the tool would meet the part.
std::vector<SpacePoint> arc_of(const Ground& ground, SpacePoint start, SpacePoint away,
                               double radius, double tolerance) {
  const double level = std::hypot(away.x, away.y);
  // Across `away`, upwards, in the same upright plane.
  const SpacePoint up{-away.z * away.x / level, -away.z * away.y / level, level};
  const double chord = 2 * std::acos(std::max(0.0, 1 - 0.5 * tolerance / radius));
  const auto count = static_cast<int>(std::ceil(0.5 * kPi / chord));
  std::vector<SpacePoint> corners;
  for (int k = 1; k <= count; ++k) {
    const double angle = 0.5 * kPi * k / count;
    corners.push_back(start + radius * std::sin(angle) * away +
                      radius * (1 - std::cos(angle)) * up);
  }
  const PlanLine line{plan(start), (1 / level) * Vec2{away.x, away.y}};
  SpacePoint before = start;
  for (const SpacePoint& corner : corners) {
    // Where the pass falls steeply from here the arc comes back over it.
    const double from = dot(plan(before - start), line.along);
    const double to = dot(plan(corner - start), line.along);
    if (std::abs(to - from) > kShortest)
      for (const DropSample& sample : samples_along(
               ground, line, std::min(from, to), std::max(from, to), tolerance, Sampled::kLink)) {
        const double share = (sample.s - from) / (to - from);
        if (before.z + share * (corner.z - before.z) < sample.z - kBite * tolerance) return {};
      }
    before = corner;
  }
  return corners;
}

}  // namespace

std::vector<SpacePoint> lead_arc(const Ground& ground, const std::vector<Waypoint>& points,
                                 const FinishParams& params) {
  const SpacePoint start = points.front();
  const auto next = std::find_if(points.begin() + 1, points.end(), [&](const Waypoint& p) {
    return norm(plan(p - start)) > kShortest;
  });
  double radius = params.lead_radius;
  if (next == points.end() || !(radius > 0)) return {};
  const SpacePoint away = -1.0 * beginning_of(start, *next);
  for (int k = 0; k <= kHalvings; ++k, radius /= 2) {
    std::vector<SpacePoint> arc = arc_of(ground, start, away, radius, params.tolerance);
    if (!arc.empty()) return arc;
  }
  return {};
}

}  // namespace evenload
