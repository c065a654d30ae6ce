// Links: moves at depth over cleared ground that join one pass to the next, tangent to both
// [Dubins, American Journal of Mathematics 79, 1957: shortest paths of bounded curvature].
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"
#include "strategy/constant_engagement.h"
#include "strategy/steering.h"

namespace evenload {

// The ground as it was before the move numbered `last`.
struct GroundBefore {
  const ClearedGround& ground;
  std::size_t last;
};

// How near a link may come to what is not cleared, but at its ends.
enum class LinkSpace {
  kClear,   // so far that rounded G-code meets nothing
  kGrazing  // along walls and fronts
};

// The cheapest path of turn, straight and turn, or of two turns, from `from` to `to`, that stays
// inside `centres` and meets no material: the shortest, where each piece counts a little besides.
// It turns by `turn_radius` mm or half of that; where there is no such path by a fifth, then by a
// twentieth, then, as gaps of hundredths of a millimetre need it, by 0.008 mm. Empty when there is
// none no longer than `longest` mm.
std::vector<Segment> shortest_link(const GroundBefore& ground, const Area& centres,
                                   const Pose& from, const Pose& to, double turn_radius,
                                   double longest, LinkSpace space = LinkSpace::kClear);

// The same where that is quicker than to go up and come down again; clear of everything, or where
// there is no such way, along walls and fronts. Empty where a retract is quicker. `price`: mm of a
// link in the clear that would cost as much as what is chosen.
std::vector<Segment> quicker_link(const GroundBefore& ground, const Area& centres, const Pose& from,
                                  const Pose& to, double turn_radius, const ClearingParams& params,
                                  double* price = nullptr);

// mm of a link that takes as long as to go up, `gap` mm across and down again, with what that costs
// besides.
double length_of_retract(double gap, const ClearingParams& params);

// True when the tool can go along `moves` inside `centres` without meeting material. Within `ends`
// mm of both ends of the way it may graze.
bool is_free(const GroundBefore& ground, const Area& centres, const std::vector<Segment>& moves,
             double ends);

double length_of(const std::vector<Segment>& moves);

}  // namespace evenload
