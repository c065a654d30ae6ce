#include "simulate/cusps.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

constexpr int kHalvings = 40;  // of the way between two places, on which a ridge is looked for
// Of half the passes' distance: how far to both sides of a place a parabola is laid through what
// stands, where its least may lie, and how often that is done.
constexpr double kAside = 0.25, kNearest = 0.3, kFurthest = 4;
constexpr int kParabolas = 2;

// mm of an underside above the part, across its surface.
double above_part(double z, const Top& top) { return top.normal.z * (z - top.z); }

}  // namespace

// The underside of a pass, of which one piece is known, near that piece.
Underside Cusps::of_pass(std::int32_t run, Vec2 at) const {
  Underside best;
  const auto last = static_cast<std::int32_t>(runs_.size()) - 1;
  for (std::int32_t k = std::max(0, run - 1); k <= std::min(last, run + 1); ++k) {
    const CutterRun& each = runs_[static_cast<std::size_t>(k)];
    Underside found = underside(cutter_, each, at);
    found.along += each.begin;
    if (found.z < best.z) best = found;
  }
  return best;
}

// mm that a pass leaves on the part where it is lowest, about `half` off a place: on a plane just
// there, on what is bent nearer or further off. Nothing where there is no part.
std::optional<double> Cusps::valley(std::int32_t run, Vec2 from, Vec2 half) const {
  const auto at = [&](double t) -> std::optional<double> {
    const Vec2 place = from + t * half;
    const Underside below = of_pass(run, place);
    const std::optional<Top> top = part_.highest_at(place);
    if (!top || below.z == HUGE_VAL) return std::nullopt;
    return above_part(below.z, *top);
  };
  std::optional<double> lowest = at(1);
  double t = 1;
  if (!lowest) return lowest;
  for (int k = 0; k < kParabolas; ++k) {
    const std::optional<double> a = at(t - kAside), b = at(t), c = at(t + kAside);
    if (!a || !b || !c || !(*a + *c > 2 * *b)) break;
    t = std::clamp(t + 0.5 * kAside * (*a - *c) / (*a - 2 * *b + *c), kNearest, kFurthest);
    const std::optional<double> found = at(t);
    if (found && *found < *lowest) lowest = found;
  }
  return lowest;
}

Vec2 Cusps::tip_of(const CutPlace& place) const {
  const CutterRun& run = runs_[static_cast<std::size_t>(place.run)];
  if (!(run.length > 0)) return run.path.a;
  return run.path.point(std::clamp((place.along - run.begin) / run.length, 0.0, 1.0));
}

std::optional<double> Cusps::between(const CutPlace& mine, const CutPlace& other) const {
  const Vec2 way = other.at - mine.at;
  double low = 0, high = 1;
  for (int k = 0; k < kHalvings; ++k) {
    const double t = 0.5 * (low + high);
    const Vec2 at = mine.at + t * way;
    (of_pass(mine.run, at).z <= of_pass(other.run, at).z ? low : high) = t;
  }
  const Vec2 ridge = mine.at + low * way;
  const std::optional<Top> top = part_.highest_at(ridge);
  if (!top) return std::nullopt;
  const double peak = above_part(of_pass(mine.run, ridge).z, *top);
  // Under the ridge, along the part's normal; both passes touch the part to either side of that.
  const Vec2 foot = ridge - peak * Vec2{top->normal.x, top->normal.y};
  const Vec2 half = 0.5 * (tip_of(other) - tip_of(mine));
  const std::optional<double> a = valley(mine.run, foot, -1.0 * half);
  const std::optional<double> b = valley(other.run, foot, half);
  if (!a && !b) return std::nullopt;
  return peak - (a && b ? 0.5 * (*a + *b) : (a ? *a : *b));
}

}  // namespace evenload
