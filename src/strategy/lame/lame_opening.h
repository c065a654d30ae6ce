// The spiral of one connected region of tool centres, and how the tool comes to it: the opening
// from which the region is cleared further. The spiral is its last pass.
#pragma once

#include <optional>

#include "strategy/lame/lame_clearing.h"
#include "strategy/plan/plan.h"
#include "strategy/plan/region_task.h"

namespace evenload {

struct LameOpening {
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

// In an empty plan. Conditions as for clear_region; `params` and `lame` checked, no rest machining.
// Throws GeometryError where no spiral can be made.
LameOpening lame_opening(Plan& plan, const RegionTask& task, const ClearingParams& params,
                         const LameParams& lame, Progress& progress);

}  // namespace evenload
