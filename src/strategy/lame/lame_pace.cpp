#include "strategy/lame/lame_pace.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cutting/engagement.h"
#include "feed/load_profile.h"
#include "strategy/pocket/feeds.h"

namespace evenload {
namespace {

// Engagements, evenly up to half a turn, whose feeds are asked for.
constexpr int kPaces = 48;

}  // namespace

std::optional<MonotoneSpline> pace_of(const ClearingParams& params, bool mirrored) {
  const LoadShare share = load_share(params, mirrored);
  if (!share || params.feed_control == FeedControl::kConstantRemovalRate) return {};
  std::vector<double> widths{0}, paces{1 / params.maximum_feed};
  for (int i = 1; i <= kPaces; ++i) {
    const double engaged = i * kPi / kPaces;
    const AngularInterval arc{-kPi / 2, engaged - kPi / 2};
    const double chip = engaged < kPi / 2 ? std::sin(engaged) : 1;
    widths.push_back(side_step(engaged, 0.5 * params.tool_diameter));
    const double load = share({engaged, widths.back(), chip, 0}, {arc});
    paces.push_back(std::max(load / params.feed, 1 / params.maximum_feed));
  }
  return MonotoneSpline(std::move(widths), std::move(paces));
}

}  // namespace evenload
