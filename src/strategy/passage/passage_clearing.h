// Clears a region whose rooms are joined by narrow passages, which are cut at a reduced feed: once
// along their middle with the tool's whole width where need be, then along their walls.
//
// It begins in one room, or in a passage where there is none; a passage is cut once a room beside
// it is cleared. Every room has its own entry, since no pass within the engagement limit can begin
// at the round end that the tool leaves in a mouth; with a pre-drilled hole in another room it is
// begun there all the same, by many short cuts along its walls. Our own.
#pragma once

#include <vector>

#include "strategy/choose/region_clearing.h"
#include "strategy/places/narrow_passages.h"
#include "strategy/places/passage_axis.h"
#include "strategy/task/clearing_params.h"
#include "support/progress.h"

namespace evenload {

// Laws: no move leaves task.centres; cuts in passage k carry the number first_number + k, and no
// other moves carry one; links meet no material. Conditions as for clear_region.
RegionResult clear_with_passages(const RegionTask& task, const NarrowPlaces& places,
                                 const std::vector<PassageAxis>& axes, int first_number,
                                 const ClearingParams& params, Progress& progress);

}  // namespace evenload
