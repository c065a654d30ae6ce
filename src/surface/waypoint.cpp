#include "surface/waypoint.h"

#include <algorithm>
#include <cmath>

namespace evenload {

std::vector<Waypoint> turned_round(const std::vector<Waypoint>& way) {
  std::vector<Waypoint> result(way.rbegin(), way.rend());
  for (std::size_t i = result.size(); i-- > 1;) result[i].sweep = -result[i - 1].sweep;
  if (!result.empty()) result.front().sweep = 0;
  return result;
}

double plan_length(SpacePoint before, const Waypoint& end) {
  const double chord = norm(plan(end - before)), half = 0.5 * std::abs(end.sweep);
  return half > 0 ? chord * half / std::sin(half) : chord;
}

double way_length(SpacePoint before, const Waypoint& end) {
  return std::hypot(plan_length(before, end), end.z - before.z);
}

Vec2 centre_of(SpacePoint before, const Waypoint& end) {
  const Vec2 from = plan(before), to = plan(end);
  return 0.5 * (from + to) + (0.5 / std::tan(0.5 * end.sweep)) * left_normal(to - from);
}

SpacePoint place_on(SpacePoint before, const Waypoint& end, double share) {
  const SpacePoint straight = before + share * (end - before);
  if (end.sweep == 0) return straight;
  const Vec2 centre = centre_of(before, end), arm = plan(before) - centre;
  const double turn = share * end.sweep;
  const Vec2 at = centre + std::cos(turn) * arm + std::sin(turn) * left_normal(arm);
  return {at.x, at.y, straight.z};
}

double nearest_share(SpacePoint before, const Waypoint& end, Vec2 place) {
  const double to_start = norm(place - plan(before)), to_end = norm(place - plan(end));
  if (end.sweep != 0) {
    const Vec2 centre = centre_of(before, end);
    const Vec2 arm = plan(before) - centre, wanted = place - centre;
    const double turn = std::atan2(cross(arm, wanted), dot(arm, wanted));
    const double sense = end.sweep > 0 ? 1 : -1;
    const double ahead = sense * turn < 0 ? sense * turn + 2 * kPi : sense * turn;
    if (ahead < std::abs(end.sweep)) return ahead / std::abs(end.sweep);
  }
  return to_start <= to_end ? 0 : 1;
}

SpacePoint beginning_of(SpacePoint start, const Waypoint& next) {
  const Vec2 chord = plan(next - start);
  const double half = 0.5 * next.sweep, length = plan_length(start, next);
  const double level = norm(chord);
  const Vec2 along =
      level > 0 ? (1 / level) * (std::cos(half) * chord - std::sin(half) * left_normal(chord))
                : Vec2{};
  const SpacePoint way{length * along.x, length * along.y, next.z - start.z};
  return (1 / norm(way)) * way;
}

}  // namespace evenload
