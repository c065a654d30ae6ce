#include "strategy/trochoid/pattern_cache.h"

#include <algorithm>
#include <cmath>

#include "strategy/places/narrow_passages.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// Half rooms and curvatures are rounded, half rooms down, so that a slot that is turned or moved
// has the same pattern: which of several is best may hang on the last digit.
double rounded(double value, double to) { return std::round(value / to) * to; }

}  // namespace

PatternCache::PatternCache(TrochoidKind kind, const ClearingParams& params, Progress* progress,
                           Turns turns)
    : kind_(kind) {
  slot_.progress = progress;
  slot_.tool_radius = 0.5 * params.tool_diameter;
  slot_.engagement = params.engagement_angle;
  slot_.turn_radius = std::max(params.roll_radius, params.minimum_radius);
  if (turns == Turns::kWished) slot_.least_turn = slot_.turn_radius;
  slot_.feed = params.feed;
  slot_.maximum_feed =
      params.feed_control == FeedControl::kConstantFeed ? params.feed : params.maximum_feed;
  slot_.link_feed = params.link_feed;
  if (params.narrow_passages != NarrowPassages::kTrochoid)
    least_room_ = params.minimum_radius;
  else if (kind == TrochoidKind::kConstantEngagement)
    least_room_ = tightest_trochoid(slot_.tool_radius);
}

std::optional<SlotPattern> PatternCache::pattern_of(const SlotStretch& stretch) {
  const double half_room = rounded(stretch.half_room, kSame) - kSame,
               curvature = rounded(stretch.middle.curvature(), kRounding);
  for (const Known& known : known_)
    if (known.half_room == half_room && known.curvature == curvature) return known.pattern;
  TrochoidParams slot = slot_;
  slot.width = 2 * (slot.tool_radius + half_room);
  slot.curvature = curvature;
  Known known{half_room, curvature, std::nullopt};
  if (half_room > least_room_ && std::abs(curvature) * 0.5 * slot.width < 1)
    known.pattern = slot_pattern(kind_, slot);
  known_.push_back(std::move(known));
  return known_.back().pattern;
}

}  // namespace evenload
