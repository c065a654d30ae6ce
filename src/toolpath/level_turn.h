// Feeds of a helix's last turn. It is level, and takes what the slope left: a layer as wide as the
// tool, which thins out to nothing towards the turn's end.
#pragma once

#include <vector>

#include "toolpath/planar.h"

namespace evenload {

struct LevelTurnFeeds {
  double plunge = 255;  // mm/min: of the slope; the level turn is never slower
  double highest = 0;   // mm/min: not more where the layer is thin
  double rate = 0;      // mm^2/min: ground that a cut of the whole depth clears
};

// A part of the turn at one feed.
struct LevelPiece {
  double end = 0;   // mm along the turn
  double feed = 0;  // mm/min
};

// Pieces of the level turn of `helix`, which fell by `steepness` mm per mm of its way through a
// layer of `depth` mm: each as fast as what is to be cut at its beginning may be at the removal
// rate of a cut of that depth. The pieces reach to the turn's end, and their feeds rise.
std::vector<LevelPiece> level_pieces(const Descent& helix, double depth, double steepness,
                                     double tool_radius, const LevelTurnFeeds& feeds);

// min
double duration(const std::vector<LevelPiece>& pieces);

}  // namespace evenload
