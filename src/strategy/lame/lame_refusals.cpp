#include "strategy/lame/lame_refusals.h"

namespace evenload {

Refusal no_curve(const Curve& outline, const LameWishes& w) {
  if (w.centre && !outline.contains(*w.centre)) return Refusal::kCentreOutside;
  if (w.centre || w.segments || w.semi_axis_a || w.semi_axis_b || w.exponent || w.rotation)
    return Refusal::kNoCurveAsSet;
  return Refusal::kNoCurve;
}

Refusal too_small(const LameParams& lame) {
  if (lame.centre) return Refusal::kSpiralTooSmallAtCentre;
  if (lame.segments || lame.exponent_end || lame.rotation) return Refusal::kSpiralTooSmallAsSet;
  return Refusal::kSpiralTooSmall;
}

}  // namespace evenload
