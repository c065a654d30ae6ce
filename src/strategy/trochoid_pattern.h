// The pattern of constant engagement along a slot [Jacsó 2021, Thesis IV].
//
// Passes are steered one after the other along the slot from a round front on, each from the
// right wall to the left one. Each changes the front that the next one meets, and their shape
// settles; the pattern repeats it with the greatest step that keeps the limit. The tighter the
// roll-in and roll-out the sooner a pass is at its full engagement, and the longer its way back:
// of a few turn radii up to the wish that with the greatest removal rate is taken. The source has
// one roll radius.
#pragma once

#include <optional>

#include "strategy/trochoid_period.h"

namespace evenload {

// Nothing where the slot is too narrow for a pass to turn in. Throws as check() does.
std::optional<TrochoidPattern> constant_engagement_pattern(const TrochoidParams& params);

// The passes from the round front on, for pictures and tests: cuts without links, in the frame
// of the first, and how their advance differed from place to place.
struct PassSequence {
  std::vector<std::vector<Segment>> passes;
  std::vector<double> residuals;  // mm, from the second pass on
  double advance = 0;             // mm, of the last pass
};
// Until the residual is below kSettled tool radii, or `most` passes. Empty where no pass can turn.
PassSequence iterate_passes(const TrochoidParams& params, double turn_radius, int most);
inline constexpr double kSettled = 1e-3;

}  // namespace evenload
