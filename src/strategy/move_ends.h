// Ways of moves: joined where one goes on as the other, shortened at their ends.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

// Whether `b` goes on along the line or circle of `a`, and the two as one move.
bool continues(const Segment& a, const Segment& b);
Segment joined(const Segment& a, const Segment& b);
// All moves that go on along one line or circle as one.
std::vector<Segment> joined(const std::vector<Segment>& moves);

// The move that begins `length` mm before `move`, on its line or circle, and ends with it.
Segment begun_before(const Segment& move, double length);
// The same, beyond its end.
Segment ended_after(const Segment& move, double length);

// mm: by how much an arc is too short for posts not to write it as lines (small_arc.h); 0 where it
// is not, they would at any length, or it is a little longer than half a turn.
double lacking_length(const Segment& move);

// Take `length` mm from the way's beginning, or its end, but never its last move, and nothing of an
// arc of which the rest would be posted as lines (small_arc.h) while the whole is not. Condition:
// not empty.
void drop_first(std::vector<Segment>& moves, double length);
void drop_last(std::vector<Segment>& moves, double length);

}  // namespace evenload
