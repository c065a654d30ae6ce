#include "strategy/moves/move_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "toolpath/machinable.h"

namespace evenload {
namespace {

// What is left of a move between two shares of it; the whole where the rest alone would be
// tight.
Segment shortened(const Segment& move, double from, double to) {
  const Segment rest = move.part(from, to);
  return is_tight(rest) && !is_tight(move) ? move : rest;
}

}  // namespace

double length_of(const std::vector<Segment>& moves) {
  double length = 0;
  for (const Segment& move : moves) length += move.length();
  return length;
}

bool continues(const Segment& a, const Segment& b) {
  if (a.is_arc() != b.is_arc()) return false;
  if (!a.is_arc()) return norm(a.tangent(1) - b.tangent(0)) < 1e-9;
  return distance(a.centre, b.centre) < 1e-9 && std::abs(a.radius - b.radius) < 1e-9 &&
         (a.sweep > 0) == (b.sweep > 0) && std::abs(a.sweep + b.sweep) < kLargestSweep;
}

Segment joined(const Segment& a, const Segment& b) {
  return a.is_arc() ? Segment::arc(a.centre, a.radius, a.start_angle, a.sweep + b.sweep)
                    : Segment::line(a.a, b.b);
}

std::vector<Segment> joined(const std::vector<Segment>& moves) {
  std::vector<Segment> result;
  for (const Segment& move : moves)
    if (!result.empty() && continues(result.back(), move))
      result.back() = joined(result.back(), move);
    else
      result.push_back(move);
  return result;
}

void drop_first(std::vector<Segment>& moves, double length) {
  std::size_t whole = 0;
  for (; whole + 1 < moves.size() && moves[whole].length() <= length; ++whole)
    length -= moves[whole].length();
  moves.erase(moves.begin(), moves.begin() + static_cast<std::ptrdiff_t>(whole));
  const double share = length / moves.front().length();
  if (share > 1e-9 && share < 1) moves.front() = shortened(moves.front(), share, 1);
}

void drop_last(std::vector<Segment>& moves, double length) {
  for (; moves.size() > 1 && moves.back().length() <= length; moves.pop_back())
    length -= moves.back().length();
  const double share = 1 - length / moves.back().length();
  if (share > 0 && share < 1 - 1e-9) moves.back() = shortened(moves.back(), 0, share);
}

const Segment& sharpest_of(const std::vector<Segment>& moves) {
  return *std::max_element(moves.begin(), moves.end(), [](const Segment& a, const Segment& b) {
    return std::abs(a.curvature()) < std::abs(b.curvature());
  });
}

}  // namespace evenload
