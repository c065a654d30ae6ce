// Rooms at junctions of slots, from which a way can go on.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/region.h"
#include "strategy/places/area.h"
#include "strategy/slots/slot_way.h"

namespace evenload {

// Half rooms: a junction reaches no further.
inline constexpr double kLongestJunction = 8;

// Between a front and the last place of another way that has walls on both sides: the smallest
// such room. `centres`: of `region`.
std::optional<Region> corner_behind(const std::vector<Segment>& front, const std::vector<Way>& ways,
                                    const Region& region, const Area& centres, double tool_radius);

// Whether nothing but a junction is left of a room behind a way: along the middles of all ways.
bool is_mostly_clear(const Way& way, const Region& room, const std::vector<Way>& ways,
                     const ClearedGround& ground);

}  // namespace evenload
