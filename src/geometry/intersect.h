// Where two lines or arcs meet.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/curve.h"

namespace evenload {

struct Meeting {
  double ta = 0, tb = 0;  // parameters on the two pieces, in [0, 1]
  Vec2 p;
};

struct Meetings {
  std::array<Meeting, 2> at;
  std::size_t count = 0;

  void add(const Meeting& m) { at[count++] = m; }
  const Meeting* begin() const { return at.data(); }
  const Meeting* end() const { return at.data() + count; }
};

// The points that both pieces pass, crossing or touching, ends included. Ends reach `tolerance` mm
// further than they are, and arcs that miss a tangency by no more than `tolerance` touch. Pieces of
// one line or one circle, to within `tolerance`, meet nowhere in this sense: their common stretch
// begins and ends at ends of theirs.
Meetings meetings(const Segment& a, const Segment& b, double tolerance);

}  // namespace evenload
