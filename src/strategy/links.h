// Links: moves at depth over cleared ground that join one pass to the next, tangent to both
// [Dubins, American Journal of Mathematics 79, 1957: shortest paths of bounded curvature].
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"
#include "strategy/steering.h"

namespace evenload {

// The shortest turn-straight-turn path from `from` to `to` with turns of `turn_radius` mm, or of
// half of that, that stays inside `centres` and meets no material; empty when there is none no
// longer than `longest` mm.
std::vector<Segment> shortest_link(const ClearedGround& ground, const Area& centres,
                                   const Pose& from, const Pose& to, double turn_radius,
                                   double longest);

// True when the tool can go along `moves` inside `centres` without meeting material.
bool is_free(const ClearedGround& ground, const Area& centres, const std::vector<Segment>& moves);

double length_of(const std::vector<Segment>& moves);

}  // namespace evenload
