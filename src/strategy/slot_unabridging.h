// The path along a slot from that along what slot_abridging.h left of it: one period, in a place
// where the pattern repeats itself, is made as often more as it was left out, and passes along the
// walls there are made longer, as are links past it. All other moves go with the ground.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "strategy/abridged.h"
#include "strategy/slot_abridging.h"
#include "toolpath/planar.h"

namespace evenload {

// A pattern's periods along a stretch, one after the other. Their moves, each cut with the link
// that leads to it, have the numbers of the periods in PlanarMove::period.
struct RepeatedPeriods {
  SlotStretch stretch;  // in the direction of the periods
  PeriodReach reach;
  double half_width = 0;  // mm to both sides of the middle that the tool's centre comes to
  double step = 0;
  double begin = 0;  // mm along the stretch, the place of the first one
  int first = 0, count = 0;
};

// Turns `runs`, feeds and all, from those of what is left after all cuts into those of the whole.
// `patterns`: in the order in which they were made. Laws: moves are tangent where they were; links
// past the place are no longer than a retract would be. Nothing, and `runs` of no use, where that
// cannot be done, as where the period removes less than others of its pattern, since something else
// has cleared a part of it: `spared` then gets the pieces in which no pattern repeats itself, or
// one in which it does so the other way, or something else leads past.
std::optional<Unabridged> unabridge(std::vector<PlanarRun>& runs, const RemovedByPeriod& removed,
                                    const std::vector<SlotCut>& cuts,
                                    std::vector<RepeatedPeriods> patterns,
                                    const ClearingParams& params, std::vector<SlotPiece>& spared);

}  // namespace evenload
