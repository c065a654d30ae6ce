// Clears the slots of one region of tool centres at one level by repeated patterns, and what they
// leave pass by pass: steps 1 to 4 of trochoid.h.
#pragma once

#include <optional>
#include <vector>

#include "strategy/constant_engagement.h"
#include "strategy/pattern_cache.h"
#include "strategy/region_clearing.h"
#include "support/progress.h"

namespace evenload {

// Of the longest way along which a pattern was repeated at once, in any region; all 0 where none
// was.
struct TrochoidReport {
  double step = 0;          // mm, of its pattern
  int iterations = 0;       // passes that were steered; 0 for patterns found in one go
  double residual = 0;      // mm, at the end of the iteration
  double removal_rate = 0;  // mm^3/min at the first level: the slot's width times its depth over
                            // the time per mm, links and wall passes in it, entry and ends not
  double longest = 0;       // mm, of this way
  double length = 0;        // mm of slot along which patterns are repeated, all regions together
};

// Slots wider than this many tool diameters are pockets: they are cleared pass by pass.
inline constexpr double kWidestSlot = 4;

// Conditions as for clear_region. `report`: of all regions of one call; this one is added.
RegionResult clear_slots_of(const RegionTask& task, const ClearingParams& params,
                            PatternCache& patterns, TrochoidReport& report, Progress& progress);

// The same for pockets, some of which are slots in part: nothing where no pattern is repeated, for
// such as posts would write with corners are not, nor are those in hardly any room. What patterns
// leave is cleared as in any pocket.
std::optional<RegionResult> clear_where_patterns_serve(const RegionTask& task,
                                                       const ClearingParams& params,
                                                       PatternCache& patterns,
                                                       TrochoidReport& report, Progress& progress);

}  // namespace evenload
