// The spiral of one connected region of tool centres, and how the tool comes to it: the opening
// from which the region is cleared further.
#pragma once

#include <optional>

#include "strategy/choose/region_clearing.h"
#include "strategy/lame/lame_clearing.h"

namespace evenload {

struct LameOpening {
  RegionResult result;                 // its runs, with the spiral as the last pass
  double spiral_area = 0;              // mm^2 within reach that the spiral leaves cleared
  double cleared_area = 0;             // the same with what was cleared on the way to it
  double reached_area = 0;             // mm^2 within reach at all
  std::optional<LameFigures> figures;  // nothing where it was cancelled before
};

// The parameters with which clear_region clears what a spiral does not: constant engagement is kept
// to a degree and a little more, spirals to less than one; so it aims a little lower.
ClearingParams beside_spiral(ClearingParams params);

// Of the progress that is reported, up to the spiral's end.
inline constexpr double kFirstHalf = 0.5;

// Conditions as for clear_region; `params` and `lame` checked, no rest machining. Throws
// GeometryError where no spiral can be made.
LameOpening lame_opening(const RegionTask& task, const ClearingParams& params,
                         const LameParams& lame, Progress& progress);

}  // namespace evenload
