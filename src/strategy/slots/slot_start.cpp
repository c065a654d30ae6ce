#include "strategy/slots/slot_start.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/reach/entry.h"
#include "strategy/slots/slot_junctions.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// Half rooms: a little narrower than expected, a helix needs so much more for as many turns.
constexpr double kHelixRoom = 0.01;

}  // namespace

bool SlotStart::is_outside(const ClearedGround& ground) const {
  for (const Way& way : found_.ways) {
    const std::optional<int> first = first_to_cut(way, ground);
    if (!first) continue;
    const Vec2 p = cut_at(way, place_of(way, *first)).front().a;
    return std::none_of(task_.material.begin(), task_.material.end(),
                        [&](const Region& region) { return region.contains(p); });
  }
  return false;
}

std::optional<Region> SlotStart::about_hole() const {
  for (const Way& way : found_.ways) {
    const Segment& middle = way.stretch.middle;
    if (middle.distance_to(*task_.hole) > way.stretch.half_room) continue;
    const double at = middle.nearest(*task_.hole) * middle.length();
    // The way back has it nearer.
    if (at > 0.5 * way.length() + kOnWall) continue;
    const std::optional<StartRoom> start = room_of(way, std::max(first_place(way), at));
    if (start && start->room.contains(*task_.hole)) return start->room;
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<WayBegin> SlotStart::smallest_end(std::size_t first, std::size_t last, Place place) {
  std::optional<WayBegin> best;
  for (std::size_t i = first; i < last; ++i) {
    const Way& way = found_.ways[i];
    if (first_place(way) > way.last()) {
      found_.is_too_short = true;
      continue;
    }
    std::optional<StartRoom> room =
        place == Place::kBegin ? room_of(way, first_place(way)) : past_junction(way);
    if (!room) continue;
    const bool is_better = !best || (room->is_end != best->start.is_end
                                         ? room->is_end
                                         : room->room.area() < best->start.room.area() - kSame);
    if (is_better) best = WayBegin{std::move(*room), &way};
  }
  return best;
}

double SlotStart::first_place(const Way& way) const {
  const double h = way.stretch.half_room, helix = helix_radius(params_, {{}, h});
  const double stretch = task_.hole ? 0 : wished_stretch(helix, params_) + kHelixRoom * h;
  return std::max(-way.reach.back, stretch - way.circle_behind);
}

std::optional<StartRoom> SlotStart::past_junction(const Way& way) const {
  const double first = first_place(way),
               furthest = std::min(way.last(), first + kLongestJunction * way.stretch.half_room);
  std::optional<StartRoom> room;
  for (double s = first; !room && s < furthest; s += 0.5 * kMiddleLook * params_.tool_diameter)
    room = room_of(way, s);
  return room;
}

std::optional<StartRoom> SlotStart::room_of(const Way& way, double s) const {
  return start_room(task_.centres, centres_, way.stretch, s,
                    placed(way.front, pose_on(way.stretch, s)));
}

}  // namespace evenload
