#include "strategy/slots/slot_junctions.h"

#include <utility>

#include "strategy/slots/slot_rooms.h"

namespace evenload {
namespace {

// Half rooms: so far beyond the corner inside where two ways meet both walls of a way are there.
constexpr double kPastCorner = 1.1;

}  // namespace

std::optional<Region> corner_behind(const std::vector<Segment>& front, const std::vector<Way>& ways,
                                    const Region& region, const Area& centres, double tool_radius) {
  std::optional<Region> best;
  for (const Way& other : ways) {
    // The tool goes round the corner between the two ways by its radius.
    const double s =
        other.stretch.middle.length() - kPastCorner * other.stretch.half_room - tool_radius;
    if (s < 0) continue;
    std::optional<Region> room = room_between(region, centres, other.stretch, s, front);
    if (room && (!best || room->area() < best->area())) best = std::move(room);
  }
  return best;
}

bool is_mostly_clear(const Way& way, const Region& room, const std::vector<Way>& ways,
                     const ClearedGround& ground) {
  const double look = kMiddleLook * ground.tool_radius();
  double left = 0;
  for (const Way& other : ways)
    for (double s = 0; s <= other.stretch.middle.length(); s += look) {
      const Vec2 p = pose_on(other.stretch, s).p;
      if (!ground.is_cleared_point(p) && room.contains(p)) left += 0.5 * look;  // either way
    }
  return left < way.reach.ahead - way.reach.back + 2 * ground.tool_radius() +
                    kLongestJunction * way.stretch.half_room;
}

}  // namespace evenload
