// A bi-arc: two arcs that share their tangent where they meet and begin and end at given places in
// given directions; of the family of such pairs the one whose joint lies `ratio` times as far along
// the first end's tangent as along the last one's. [Bolton 1975, Biarc curves]
#pragma once

#include <optional>

#include "geometry/curve.h"

namespace evenload {

struct PlanePoint {
  Vec2 p;
  Vec2 direction;  // of travel, of unit length
};

struct BiArc {
  Segment first, second;
};

// Laws: the pair leads from one point to the other without a corner; nearly straight arcs are
// lines. Nothing where there is no such pair of which neither arc turns by more than `most_turn`
// rad. Condition: ratio > 0.
std::optional<BiArc> bi_arc(const PlanePoint& from, const PlanePoint& to, double most_turn,
                            double ratio = 1);

}  // namespace evenload
