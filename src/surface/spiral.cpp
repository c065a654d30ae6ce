#include "surface/spiral.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

constexpr double kWidestStep = kPi / 8;  // rad between corners, in the middle

// How far the outermost place that has to be met lies from a middle, mm.
double farthest(const std::vector<Region>& regions, Vec2 middle) {
  double result = 0;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves())
      for (const Vec2 p : curve.flattened(kChords)) result = std::max(result, norm(p - middle));
  return result;
}

}  // namespace

std::vector<std::vector<Polyline>> spiral_rows(const Ground& ground,
                                               const std::vector<Region>& regions, double stepover,
                                               bool is_outwards, bool is_clockwise) {
  const Bounds bounds = bounds_of(regions);
  const Vec2 middle = 0.5 * (bounds.low + bounds.high);
  const double reach = ground.by_contact ? ground.cutter.radius + ground.allowance : 0;
  const auto turns =
      static_cast<std::size_t>(std::ceil((farthest(regions, middle) + reach) / stepover)) + 1;
  const double sense = is_outwards == is_clockwise ? -1 : 1;  // of growing angles, from the middle
  std::vector<std::vector<Polyline>> rows(turns);
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const double outer = stepover * static_cast<double>(turn + 1);
    const double step = std::min(kWidestStep, 2 * std::acos(std::max(0.0, 1 - kChords / outer)));
    const auto count = static_cast<std::size_t>(std::ceil(2 * kPi / step));
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count);
      const double radius = stepover * (static_cast<double>(turn) + share);
      const double angle = sense * 2 * kPi * share;
      corners.push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    // A turn ends to the last bit where the next one begins.
    corners.front() = middle + Vec2{stepover * static_cast<double>(turn), 0};
    corners.back() = middle + Vec2{outer, 0};
    if (!is_outwards) std::reverse(corners.begin(), corners.end());
    rows[is_outwards ? turn : turns - 1 - turn].push_back({std::move(corners), false});
  }
  return rows;
}

}  // namespace evenload
