// A cut divided into pieces of one feed.
#pragma once

#include <cstddef>
#include <vector>

#include "feed/feed_control.h"
#include "feed/mean_load.h"
#include "support/progress.h"

namespace evenload {

// s: what a change of feed must save where a move ends anyway. It costs no block; but feeds that
// hardly differ shall be one.
inline constexpr double kChangePrice = 0.0005;

// Samples [first, last) of the profile of `runs`, all of cuts, without gaps.
struct CutSamples {
  const std::vector<PlanarRun>& runs;
  const std::vector<LoadSample>& profile;
  std::size_t first = 0, last = 0;
};

// Whether the feed may change after each of the samples: where a move ends, and so far from its
// ends that neither a move shorter than `params` allows nor a tight turn is split off.
std::vector<char> places_for_change(const CutSamples& cut, const FeedParams& params);

// The pieces, in their order, whose time and blocks at params.steps.price cost least. `load` is the
// samples', `may_change` what places_for_change() says of them. Makes steps of `progress`.
std::vector<FeedPiece> best_division(const CutSamples& cut, const MeanLoad& load,
                                     const std::vector<char>& may_change, const FeedParams& params,
                                     Progress* progress);

}  // namespace evenload
