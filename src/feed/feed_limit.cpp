#include "feed/feed_limit.h"

#include <algorithm>

namespace evenload {

void find_feed_limits(std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                      double feed, double nominal_width) {
  for (const LoadSample& sample : profile) {
    PlanarMove& move = runs[sample.run].moves[sample.move];
    if (move.passage < 0 || sample.width <= nominal_width) continue;
    const double limit = feed * nominal_width / sample.width;
    move.feed_limit = move.feed_limit > 0 ? std::min(move.feed_limit, limit) : limit;
  }
}

void apply_feed_limits(std::vector<PlanarRun>& runs) {
  for (PlanarRun& run : runs)
    for (PlanarMove& move : run.moves)
      if (move.feed_limit > 0) move.feed = std::min(move.feed, move.feed_limit);
}

}  // namespace evenload
