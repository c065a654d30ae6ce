// The feeds of a planned path, as ClearingParams want them.
#pragma once

#include <functional>
#include <vector>

#include "feed/load_profile.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

// What the feed control holds along the path; none for a constant feed. `mirrored`: the path is
// planned as the mirror image of the one that is cut. Throws std::invalid_argument for a constant
// force without what it needs.
LoadShare load_share(const ClearingParams& params, bool mirrored);

// Sets every feed of `runs`, and splits moves where the feed changes. `profile`: made with
// `load_share`; an empty one gives constant feeds. Adds to the report's findings what a user of the
// control should know: how thick chips get at a constant removal rate, and where a constant force
// could not be held. `shown`: where a place of the path is shown to the user. Throws Cancelled by
// the steps of `progress` that it makes; `runs` are as they were then.
void set_feeds(std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
               const ClearingParams& params, const std::function<Vec2(Vec2)>& shown, Report& report,
               Progress& progress);

}  // namespace evenload
