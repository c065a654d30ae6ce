// Why no Lamé spiral is made: which of the set values is in the way.
#pragma once

#include "strategy/lame/lame_clearing.h"
#include "strategy/lame/lame_fit.h"
#include "support/refusal.h"

namespace evenload {

// Where no curve fits into an outline with these wishes.
Refusal no_curve(const Curve& outline, const LameWishes& wishes);
// Where the spiral would clear too small a share.
Refusal too_small(const LameParams& lame);

}  // namespace evenload
