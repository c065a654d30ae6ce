// What the files that change or join moves ask of them, and the figures that more than one file of
// the strategy measures engagement by.
#pragma once

#include <cstddef>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/curve.h"
#include "strategy/places/area.h"

namespace evenload {

// Into how many parts a move is divided by looks along it.
inline constexpr int kMoveLooks = 8;

// True where `b` goes on as `a` ends; their unit tangents differ by less than `difference`.
bool is_tangent(const Segment& a, const Segment& b, double difference);

// True where `move`, looked at after each quarter, lies on the border of `centres`.
bool follows_border(const Segment& move, const Area& centres);

// True where no place of `move` is more than `tolerance` mm outside; but what is outside for less
// than 0.02 mm of its way may not be seen.
bool is_inside(const Segment& move, const Area& centres, double tolerance);

// The first of the moves to which a pass does not come back: from there on it turns by less than
// kComesBack. 0 where that is all of it. Were it led elsewhere before, its next turn would meet
// more or less than it was steered for.
std::size_t first_left_behind(const std::vector<Segment>& moves);
inline constexpr double kComesBack = 1.75 * kPi;

// mm at the end of the moves along which the tool touches nothing, `most` at most. `ground`: before
// the moves, and again in the end.
double idle_end_of(const std::vector<Segment>& moves, double most, ClearedGround& ground);

}  // namespace evenload
