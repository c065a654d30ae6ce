// Which passages of a pocket are narrow, and what the report says of them.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "feed/load_profile.h"
#include "strategy/places/narrow_passages.h"
#include "strategy/places/passage_axis.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

// One narrow passage, as the user is told of it.
struct PassageReport {
  Region centres;         // of the tool; mouths straight, so that the border has no cusps
  Vec2 at;                // a place in its middle
  double width = 0;       // mm: of the pocket, where the passage is narrowest
  double engagement = 0;  // rad, the most that a cut in it meets
  double feed = 0;        // mm/min, the lowest in it; 0: it is not cut
  bool no_turns = false;  // it was to be cut by trochoids, but is too narrow for them
};

struct DividedRegion {
  NarrowPlaces places;
  std::vector<PassageAxis> axes;  // of the passages
};

// The rooms and passages of a region of tool centres for the set minimum radius. With
// NarrowPassages::kReducedFeed passages are no wider than kWidestPassage allows; with kTrochoid
// they are those where trochoids are no way to cut: short necks between rooms that are too narrow
// for turns of kTightestArc, or where one of those is long, or none has a room beside it, what is
// too narrow for turns of kTightestTrochoid, if one is longer than the tool's radius, or without a
// room beside it; all of a region that has such a passage and nowhere a tenth of the tool's radius
// of room to either side, as a stroke about as wide as the tool.
DividedRegion divide(const Region& centres, const ClearingParams& params);
// Share of the tool's radius, half of the free width: what wider passages hold cannot all be
// reached from their middle and along their walls.
inline constexpr double kWidestPassage = 0.9;

std::vector<PassageReport> reports_of(const DividedRegion& region, const ClearingParams& params);

bool is_in_passage(Vec2 p, const std::vector<PassageReport>& passages);

// Notes the engagement in each passage. `profile`: of these very runs.
void note_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                     std::vector<PassageReport>& passages);
// Notes the lowest feed in each passage.
void note_feeds(const std::vector<PlanarRun>& runs, std::vector<PassageReport>& passages);

// One finding per passage; adds to `report` what is left in them. `ground`: cleared by the whole
// path. `mirror`: the regions are mirror images.
void tell(const std::vector<PassageReport>& passages, const ClearedGround& ground, bool mirror,
          Report& report);

}  // namespace evenload
