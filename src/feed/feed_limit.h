// Caps of the feed in narrow passages, where the tool may meet more than the engagement angle.
//
// The cap holds the removal rate at its nominal value. That is the stricter of the two caps that
// suggest themselves: with the whole tool engaged it is (1 - cos theta) / 2 of the feed, while the
// chip would be as thick as nominal at sin theta of it (up to 90 degrees, at all of it beyond),
// which is more up to 126 degrees; above, chips are up to f_z thick with either.
#pragma once

#include <vector>

#include "feed/load_profile.h"
#include "toolpath/planar.h"

namespace evenload {

// Sets feed_limit of every move in a passage whose widest place removes more than the nominal
// width, `nominal_width` mm, which is cut at `feed` mm/min. `profile`: of these very moves.
void find_feed_limits(std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                      double feed, double nominal_width);

// Lowers feeds to their limits: after feed control.
void apply_feed_limits(std::vector<PlanarRun>& runs);

}  // namespace evenload
