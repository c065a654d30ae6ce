// The corners of a way through space whose pieces are straight lines or helices.
#pragma once

#include <vector>

#include "surface/space_point.h"

namespace evenload {

inline constexpr double kSecondsPerMinute = 60;  // feeds are in mm/min

struct Waypoint : SpacePoint {
  // rad, counter-clockwise positive: by how much the piece that leads here from the corner before
  // turns, seen from above, at an even slope; 0: it is a line.
  double sweep = 0;
};

// The same way backwards.
std::vector<Waypoint> turned_round(const std::vector<Waypoint>& way);

// mm, in plan and in space, from the corner before.
double plan_length(SpacePoint before, const Waypoint& end);
double way_length(SpacePoint before, const Waypoint& end);

// The centre of a piece that turns, in plan.
Vec2 centre_of(SpacePoint before, const Waypoint& end);

// Where the piece is after a share of its length, from 0 to 1.
SpacePoint place_on(SpacePoint before, const Waypoint& end, double share);

// The share of the piece at which it is nearest to a place in plan; of a line the nearer end's.
double nearest_share(SpacePoint before, const Waypoint& end, Vec2 place);

// Of length 1, the direction in which a way begins.
SpacePoint beginning_of(SpacePoint start, const Waypoint& next);

}  // namespace evenload
