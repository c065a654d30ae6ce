// Rooms of a slot: parts of a region of tool centres that end at a front across the slot. They are
// cleared as pockets are, where a pattern cannot begin yet or not go on.
#pragma once

#include <optional>
#include <vector>

#include "geometry/region.h"
#include "strategy/places/area.h"
#include "strategy/trochoid/slot.h"

namespace evenload {

// Half a circle ahead, from the right wall to the left one, both `s` mm along the stretch.
std::vector<Segment> round_front(const SlotStretch& stretch, double s);

// All that lies behind `front`, which leads from the right wall to the left one, down to the end of
// the slot. `centres`: of `region`. Nothing where the walls do not lead from one to the other, or
// something stands in between.
std::optional<Region> room_behind(const Region& region, const Area& centres,
                                  const std::vector<Segment>& front);

// True where a room behind a front is the end of a slot, and no more. In slots hardly wider than
// the tool a front may bulge by several times the slot's room.
bool is_end(const Region& room, const SlotStretch& stretch, const std::vector<Segment>& front);

// What lies between `front` and half a circle behind `s` mm along the stretch. Nothing where the
// walls, or the stretch, end before.
std::optional<Region> room_between(const Region& region, const Area& centres,
                                   const SlotStretch& stretch, double s,
                                   const std::vector<Segment>& front);

// From the front of a period `s` mm along the stretch down to the end of the slot, or where that
// has none, no further than a helix as wide as the slot needs.
struct StartRoom {
  Region room;
  bool is_end = false;
};
std::optional<StartRoom> start_room(const Region& region, const Area& centres,
                                    const SlotStretch& stretch, double s,
                                    const std::vector<Segment>& front);

}  // namespace evenload
