// Ways of moves: joined where one goes on as the other, shortened at their ends.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace evenload {

double length_of(const std::vector<Segment>& moves);  // mm

// Whether `b` goes on along the line or circle of `a`, and the two as one move.
bool continues(const Segment& a, const Segment& b);
Segment joined(const Segment& a, const Segment& b);
// All moves that go on along one line or circle as one.
std::vector<Segment> joined(const std::vector<Segment>& moves);

// Take `length` mm from the way's beginning, or its end, but never its last move, and nothing of an
// arc of which the rest would be posted as lines (machinable.h) while the whole is not. Condition:
// not empty.
void drop_first(std::vector<Segment>& moves, double length);
void drop_last(std::vector<Segment>& moves, double length);

// The move that turns most tightly, the first of several. Condition: not empty.
const Segment& sharpest_of(const std::vector<Segment>& moves);

}  // namespace evenload
