// How the tool comes down to a level in one region: from outside, by a helix, or by a ramp.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/medial_axis.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

struct Entry {
  Descent descent;
  Pose start;  // from which the first pass begins
};

// mm: of the tool centre's helix within `room`, a circle of places of the centre: the wished one,
// or what fits. Law: at most widest_helix().
double helix_radius(const ClearingParams& params, const Circle& room);
// mm: the largest radius of a helix that leaves no post in its middle.
double widest_helix(const ClearingParams& params);
// What to tell the user where a helix of `runs` had to be narrower than wished for that reason.
std::optional<Finding> narrowed_helix(const std::vector<PlanarRun>& runs,
                                      const ClearingParams& params);

// A helix in `room`. Where none fits, or the room is tiny and not round, a ramp round the border of
// `centres` where that is short: it leaves nothing to be cut beside walls, where half the tool
// would be engaged at once. Where it is longer, or a ramp is asked for, a ramp from the room's
// centre along the longest free line. Empty when there is not even room for a ramp: the tool never
// plunges. Laws: the descent stays inside `centres`; a ramp is no longer than kLongestRamp tool
// diameters, one way.
std::optional<Entry> descend_within(const Area& centres, const Circle& room,
                                    const ClearingParams& params);
inline constexpr double kLongestRamp = 1.5;
// mm: by which a ramp's lines in place of the arcs of a border leave them, and as much again where
// lines are joined; together a part of kWallGap.
inline constexpr double kRampChord = 2e-4;
// A ramp once round a closed border; `ramp_by` is empty for one of kRampChord or so. Lines that are
// so short that they would descend by less than kLeastDescent are a part of others, unless that
// moves the ramp by more than kRampChord.
Descent ramp_along(const Curve& border, const ClearingParams& params);
// The same entry, but a helix stretched in the direction with the most room, until it removes as
// much in a time as a cut at the engagement angle, or as far as there is room: it goes down no
// faster than a circle, but clears more on the way. Law: a helix that is stretched clears no more
// than kMostCleared times the area of a circle with the tool's diameter for its radius.
void stretch_helix(Entry& entry, const Area& centres, const ClearingParams& params);
// Ground that no pass has cleared at the engagement angle; twice the area is too much of it.
inline constexpr double kMostCleared = 1.8;
// Whether a helix is narrower than wished for want of room.
bool is_shrunk(const Descent& helix, const ClearingParams& params);
// mm: by how much, where there is room.
double wished_stretch(double helix_radius, const ClearingParams& params);
// mm^2: of what a helix or ramp clears, the part that nothing did before. As a share of the whole,
// which is exact, found on a grid of points.
double area_cut_by(const Descent& descent, const ClearedGround& before);
// A helix, whatever entry the parameters ask for; empty where none fits.
std::optional<Entry> helix_within(const Area& centres, const Circle& room, ClearingParams params);

// In a room of some hundredths of a millimetre a helix gets as wide as the room or as asked for,
// unless it is stretched: from a smaller one the first pass would turn outwards in pieces so short
// that posts write them as lines.
void fill_narrow_room(Entry& entry, const Circle& room, const ClearingParams& params);

// A place outside the stock, beside the longest open edge of `material` from which the tool can go
// straight in, or beside the edge that is nearest to a place, as near to that as it may; the
// heading is along the edge. Empty when there is none.
std::optional<Pose> start_outside(const Area& centres, const std::vector<Region>& material,
                                  const ClearedGround& ground,
                                  std::optional<Vec2> near = std::nullopt);

}  // namespace evenload
