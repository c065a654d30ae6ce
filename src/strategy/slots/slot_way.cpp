#include "strategy/slots/slot_way.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Places in a step that are tried for a first period: how much of a step may be lost.
constexpr int kTriesInStep = 4;
// Share of the tool's radius: between two looks along a cut that shall be clear.
constexpr double kLook = 0.1;
// Share of a step: what is thinner in front of a period is a scallop.
constexpr double kScallop = 0.25;
// Share of a step: what is thinner is no material where a period shall cut nothing.
constexpr double kNoMaterial = 0.002;
// Of unit vectors: towards the front, not the walls.
constexpr double kAcross = 0.5;

// `thin` mm: what is no thicker does not count.
bool is_clear(const std::vector<Segment>& moves, const ClearedGround& ground, double thin) {
  for (const Segment& move : moves) {
    const int n = static_cast<int>(std::ceil(move.length() / (kLook * ground.tool_radius())));
    for (int i = 0; i <= n; ++i)
      if (!ground.is_clear(move.point(static_cast<double>(i) / n), thin)) return false;
  }
  return true;
}

}  // namespace

std::vector<Segment> cut_at(const Way& way, double s) {
  return placed(way.pattern.cut, pose_on(way.stretch, s));
}

double place_of(const Way& way, int period) { return way.last() - period * way.pattern.step; }

std::optional<int> first_to_cut(const Way& way, const ClearedGround& ground) {
  const std::optional<double> edge = edge_of_material(way, ground);
  if (!edge) return std::nullopt;
  const double reach = way.reach.ahead - way.reach.back + 2 * ground.tool_radius();
  const double from = std::max(-way.reach.back - way.stretch.half_room, *edge - reach);
  const double spacing = way.pattern.step / kTriesInStep;
  const double thin = kNoMaterial * way.pattern.step;
  // Places that are tried are counted as periods are, the furthest first.
  const auto place = [&](int i) { return way.last() - i * spacing; };
  const int furthest = static_cast<int>(std::ceil((way.last() - *edge) / spacing));
  int free = std::max(kTriesInStep, furthest);
  while (place(free) >= from && !is_clear(cut_at(way, place(free)), ground, thin)) ++free;
  if (place(free) < from || !has_work(way, ground, place(free - kTriesInStep))) return std::nullopt;
  return (free - 1) / kTriesInStep;
}

std::optional<double> edge_of_material(const Way& way, const ClearedGround& ground) {
  bool was_clear = false;
  for (double s = 0; s <= way.stretch.middle.length(); s += kMiddleLook * ground.tool_radius()) {
    const bool clear = ground.is_cleared_point(pose_on(way.stretch, s).p);
    if (was_clear && !clear) return s;
    was_clear = clear;
  }
  return std::nullopt;
}

bool has_work(const Way& way, const ClearedGround& ground, double s) {
  const double inside = ground.tool_radius() - kScallop * way.pattern.step;
  for (const Segment& move : cut_at(way, s)) {
    const Vec2 p = move.point(0.5), right = -left_normal(move.tangent(0.5));
    if (!ground.is_cleared_point(p + inside * right) &&
        std::abs(dot(right, unit(pose_on(way.stretch, s).heading))) > kAcross)
      return true;
  }
  return false;
}

}  // namespace evenload
