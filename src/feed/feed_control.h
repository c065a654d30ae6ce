// Feeds along a path: constant, or so that the material removal rate stays at its nominal value
// [Jacsó 2021, feed control].
#pragma once

#include <vector>

#include "feed/load_profile.h"
#include "toolpath/planar.h"

namespace evenload {

struct FeedParams {
  double feed = 255;           // mm/min, at the nominal width
  double nominal_width = 1.5;  // mm, r (1 - cos theta)
  double maximum_feed = 510;   // mm/min
  double link_feed = 1500;     // mm/min
};

// Every cut at `feed`, every link at `link_feed`.
void set_constant_feed(std::vector<PlanarRun>& runs, const FeedParams& params);

// Cuts at the feed that holds the removal rate, up to `maximum_feed`. Moves are split where the
// feed changes, as few times as pays: the sum of the time and of a fixed price per added block is
// the least possible (dynamic programming over the samples).
void set_constant_removal_rate(std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                               const FeedParams& params);

}  // namespace evenload
