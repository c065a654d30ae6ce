// Narrow passages: places of the tool's centre that are too narrow to turn in, told from the rooms
// that they join.
//
// The region of tool centres is opened by a disc (shrunk by its radius, then grown again). The arcs
// of the opened border that do not lie on the region's own border are mouths: behind each lies a
// patch that the disc cannot reach. A patch behind one mouth only that is no deeper than a given
// depth is a mere corner and stays with its room; every other is a passage. Our own.
#pragma once

#include <vector>

#include "geometry/region.h"

namespace evenload {

// A piece of a passage's border, with the passage on its left.
struct PassageBorder {
  Segment segment;
  bool is_mouth = false;  // of a room; else a wall of the region
};

struct Passage {
  std::vector<std::vector<PassageBorder>> loops;  // the outer one first
  std::vector<std::size_t> rooms;                 // that it opens into; may name one twice
  // The same as a region. Walls and mouths meet in cusps, so that make_region need not accept it.
  Region centres;
  bool by_ramp = false;  // short: to be cleared by a ramp round its border
};

struct NarrowPlaces {
  std::vector<Region> rooms;  // corners and all
  std::vector<Passage> passages;
};

// Laws: rooms and passages share nothing but mouths and together are `centres`; a region that the
// disc cannot enter is one passage; one in which it leaves nothing but corners is one room per
// piece. A disc whose mouths have no clear order gives way to a smaller one, and one no wider than
// kShallow to none: all is one room then. Condition: radius > 0. Tolerance: kOffsetTolerance;
// passages less deep than kShallow mm are not told from walls.
NarrowPlaces find_narrow_places(const Region& centres, double radius, double corner_depth);
// The same, where corners are no deeper than the disc's radius, as all of 60 degrees and more are.
NarrowPlaces find_narrow_places(const Region& centres, double radius);
inline constexpr double kShallow = 1e-5;

}  // namespace evenload
