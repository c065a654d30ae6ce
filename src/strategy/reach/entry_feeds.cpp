#include "strategy/reach/entry_feeds.h"

#include <algorithm>
#include <cmath>

#include "cutting/engagement.h"

namespace evenload {

LevelTurnFeeds entry_feeds(const ClearingParams& params) {
  const double radius = 0.5 * params.tool_diameter;
  LevelTurnFeeds feeds;
  feeds.plunge = params.plunge_feed;
  feeds.rate = side_step(params.engagement_angle, radius) * params.feed;
  if (params.feed_control != FeedControl::kConstantRemovalRate) return feeds;
  // The engagement at which a cut is as fast as may be, and its chips, which a slot's are as thick
  // as at this feed.
  const double angle =
      engagement_angle(std::min(2 * radius, feeds.rate / params.maximum_feed), radius);
  feeds.highest = params.maximum_feed * largest_chip_thickness(angle, 1);
  return feeds;
}

std::vector<LevelPiece> level_turn(const Descent& helix, double depth,
                                   const ClearingParams& params) {
  return level_pieces(helix, depth, std::tan(params.helix_angle), 0.5 * params.tool_diameter,
                      entry_feeds(params));
}

}  // namespace evenload
