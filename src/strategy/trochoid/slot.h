// Stretches of slots in a region of tool centres: places where the tool's centre runs between two
// walls that stay equally far apart, straight or as arcs about one centre. Our own; the source has
// straight slots, and the branches of a medial axis for the rest [Jacsó 2021, hybrid path].
#pragma once

#include <vector>

#include "geometry/region.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"

namespace evenload {

struct SlotStretch {
  Segment middle;
  double half_room = 0;  // mm, from the middle to the walls of the tool's centre
  // Either way along the stretch is as good.
  SlotStretch reversed() const { return {middle.reversed(), half_room}; }
};

// Where the middle is after `s` mm.
Pose pose_on(const SlotStretch& stretch, double s);

// The longest first. Laws: a disc of `half_room` about any place of the middle lies within the
// centres and touches them on both sides somewhere along the stretch; a stretch goes on through
// junctions as far as the disc fits; none has more than `widest` mm of half_room, nor is shorter
// than twice its half_room. Walls whose distance changes by less than kSameWidth mm count, at the
// narrowest place's; what that leaves beside them is no part of the stretch.
std::vector<SlotStretch> find_slots(const Area& centres, double widest);
inline constexpr double kSameWidth = 5e-3;

// The part of the outer border from one of its places on to another, without closing it.
std::vector<Segment> border_between(const Curve& border, const WallPlace& from,
                                    const WallPlace& to);

}  // namespace evenload
