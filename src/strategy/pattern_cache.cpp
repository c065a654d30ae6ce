#include "strategy/pattern_cache.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm and 1/mm: of half rooms and curvatures.
constexpr double kAlike = 1e-9;

}  // namespace

PatternCache::PatternCache(TrochoidKind kind, const ClearingParams& params) : kind_(kind) {
  slot_.tool_radius = 0.5 * params.tool_diameter;
  slot_.engagement = params.engagement_angle;
  slot_.turn_radius = std::max(params.roll_radius, params.minimum_radius);
  slot_.feed = params.feed;
  slot_.maximum_feed =
      params.feed_control == FeedControl::kConstantFeed ? params.feed : params.maximum_feed;
  slot_.link_feed = params.link_feed;
}

std::optional<SlotPattern> PatternCache::pattern_of(const SlotStretch& stretch) {
  const double half_room = stretch.half_room, curvature = stretch.middle.curvature();
  for (const Known& known : known_)
    if (std::abs(known.half_room - half_room) < kAlike &&
        std::abs(known.curvature - curvature) < kAlike)
      return known.pattern;
  TrochoidParams slot = slot_;
  slot.width = 2 * (slot.tool_radius + half_room);
  slot.curvature = curvature;
  Known known{half_room, curvature, std::nullopt};
  if (std::abs(curvature) * 0.5 * slot.width < 1) known.pattern = slot_pattern(kind_, slot);
  known_.push_back(std::move(known));
  return known_.back().pattern;
}

}  // namespace evenload
