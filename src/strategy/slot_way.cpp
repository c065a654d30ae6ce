#include "strategy/slot_way.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Steps between two places that are tried for a first period: how much of a step may be lost.
constexpr double kTrySpacing = 0.25;
// Share of the tool's radius: between two looks along a cut that shall be clear.
constexpr double kLook = 0.1;
// Share of a step: what is thinner in front of a period is a scallop.
constexpr double kScallop = 0.25;
// Share of a step: what is thinner is no material where a period shall cut nothing.
constexpr double kThin = 0.002;
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

std::optional<double> first_free(const Way& way, const ClearedGround& ground) {
  const std::optional<double> edge = edge_of_material(way, ground);
  if (!edge) return std::nullopt;
  const double reach = way.reach.ahead - way.reach.back + 2 * ground.tool_radius();
  std::optional<double> last;
  const double from = -way.reach.back - way.stretch.half_room;
  for (double s = std::max(from, *edge - reach); s <= std::min(way.last(), *edge);
       s += kTrySpacing * way.pattern.step)
    if (is_clear(cut_at(way, s), ground, kThin * way.pattern.step))
      last = s;
    else if (last)
      break;
  return last && has_work(way, ground, *last + way.pattern.step) ? last : std::nullopt;
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
