// The pattern for slots of one width and curvature.
//
// Two walls that a trochoid has to touch in every period cost it more than two passes along them:
// beside the walls its cut is thin, and its way back is the longer the wider it is. So the pattern
// of constant engagement is made as wide as the slot, and narrower, with walls that are left to one
// pass each at no more than the limit; that which removes most in a time is taken. Our own; the
// source's pattern is as wide as its slot. Circles and cycloids always are.
#pragma once

#include <optional>
#include <vector>

#include "strategy/trochoid/trochoid_period.h"

namespace evenload {

enum class TrochoidKind { kConstantEngagement, kCircular, kCycloid };

// Share of the tool's radius: circles smaller than that meet too much once posts round them.
inline constexpr double kLeastCircle = 0.03;

// Nothing where the slot is too narrow for it. Throws as check() does.
std::optional<TrochoidPattern> make_pattern(TrochoidKind kind, const TrochoidParams& params);

struct SlotPattern {
  TrochoidKind kind = TrochoidKind::kConstantEngagement;
  TrochoidPattern pattern;
  PeriodReach reach;
  // Across all of the slot, from the right wall to the left one, in the pattern's frame: where what
  // lies behind it is cleared a pattern as wide as the slot goes on at the limit.
  std::vector<Segment> front;
  double front_ahead = 0;  // mm along the middle that it reaches, from the pattern's origin
  double beside = 0;       // mm left along each wall
  // Places of circles as wide as the slot, mm along the middle from the pattern's origin: the
  // furthest behind the front, and the first that holds all that the cut reaches ahead of it.
  double circle_behind = 0, circle_ahead = 0;
  double removal = 0;  // mm^2/min, passes along the walls and all
};

// Whether posts would write turns of the pattern as lines with corners.
bool has_corners(const SlotPattern& pattern);

// `slot.width`: of the slot; `slot.finish_walls` is set here. In place of a pattern of constant
// engagement that turns at corners, in slots hardly wider than the tool, circles that do not.
std::optional<SlotPattern> slot_pattern(TrochoidKind kind, const TrochoidParams& slot);

// mm: so much can be left beside both walls for one pass each at the limit.
double most_beside(const TrochoidParams& slot);

}  // namespace evenload
