#include "surface/stepped.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/beside.h"

namespace evenload {

namespace {

constexpr double kFan = kPi / 16;  // rad between the rays round a corner

std::vector<Vec2> with_places(const std::vector<Vec2>& outline) {
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i], way = outline[(i + 1) % outline.size()] - from;
    const double length = norm(way);
    if (!(length > kUnitedGrid)) continue;
    const int count = std::max(1, static_cast<int>(std::ceil(length / kStationsApart)));
    for (int k = 0; k < count; ++k) places.push_back(from + (static_cast<double>(k) / count) * way);
  }
  return places;
}

}  // namespace

std::vector<Stepped> outlines_of(const std::vector<Patch>& patches) {
  std::vector<Stepped> rows;
  for (const Patch& patch : patches) {
    rows.push_back({with_places(patch.outline), {}});
    for (const std::vector<Vec2>& hole : patch.holes) rows.push_back({with_places(hole), {}});
  }
  return rows;
}

std::vector<Patch> bands(const std::vector<Stepped>& rows, double share, int side,
                         Progress& progress) {
  std::vector<Patch> polygons;
  for (const Stepped& row : rows) {
    const std::size_t count = row.corners.size();
    progress.step();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count, before = (i + count - 1) % count;
      const Vec2 p = row.corners[i], q = row.corners[next];
      const Vec2 normal = side * left_normal(normalized(q - p));
      const double here = share * row.steps[i], there = share * row.steps[next];
      polygons.push_back({{p, q, q + there * normal, p + here * normal}, {}});
      const Vec2 earlier = side * left_normal(normalized(p - row.corners[before]));
      const double turn = std::atan2(cross(earlier, normal), dot(earlier, normal));
      if (side * turn >= 0) continue;
      // The rays of the two sides part at this corner.
      std::vector<Vec2> fan{p};
      const int rays = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / kFan)));
      const double reach = here / std::cos(0.5 * turn / rays);
      fan.push_back(p + here * earlier);
      for (int k = 0; k < rays; ++k)
        fan.push_back(p + reach * rotated(earlier, turn * (k + 0.5) / rays));
      fan.push_back(p + here * normal);
      polygons.push_back({std::move(fan), {}});
    }
  }
  return polygons;
}

std::vector<Stepped> outwards(const std::vector<Stepped>& rows, const std::vector<Stepped>& before,
                              Progress& progress) {
  std::vector<Stepped> result = rows;
  for (Stepped& row : result)
    for (std::size_t i = 0; i < row.corners.size(); ++i) {
      progress.step();
      double nearest = HUGE_VAL;
      for (const Stepped& each : before)
        for (std::size_t k = 0; k < each.corners.size(); ++k) {
          const double off = squared_norm(each.corners[k] - row.corners[i]);
          if (off >= nearest) continue;
          nearest = off;
          row.steps[i] = each.steps[k];
        }
    }
  return result;
}

}  // namespace evenload
