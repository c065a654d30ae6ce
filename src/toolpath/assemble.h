// Planar runs to moves in space: descents, levels, retracts.
#pragma once

#include <vector>

#include "toolpath/level_turn.h"
#include "toolpath/planar.h"
#include "toolpath/toolpath.h"

namespace evenload {

enum class OrderBy {
  kRegion,  // every region down to its last level before the next
  kDepth,   // every region at one level before the next level
};

struct AssemblyParams {
  double top = 0;                // mm
  std::vector<double> levels;    // mm, descending
  double safe_height = 5;        // mm: rapids below it only over cleared ground
  double clearance_height = 10;  // mm: rapids to the first descent
  double rapid_feed = 5000;      // mm/min, for the time only
  double link_feed = 1500;       // mm/min: also down into what the same level has cleared
  LevelTurnFeeds entry;          // entries descend with its plunge feed
  double helix_angle = 0.05;     // rad
  double link_lift = 0;          // mm
  double tool_radius = 3;        // mm
  double tolerance = 0.005;      // mm, of lines in place of arcs
  bool arcs = true;
  bool wall_on_left = false;  // conventional milling
  OrderBy order_by = OrderBy::kRegion;
};

// mm above a level's top to which the tool goes straight down before a helix or ramp begins.
inline constexpr double kAboveMaterial = 0.05;

// The moves of `runs` at every level, regions in the order given, each level of a region after the
// one above it and by its own descent. Between regions the tool rises to the clearance height. Arcs
// turn by at most half a circle. No rapid goes below what the levels before have cleared: the rest
// of the way down is a feed move, which a machinist can stop. Without arcs the lines stay on the
// side of each arc that the tool may touch.
std::vector<Move> assemble(const std::vector<PlanarRun>& runs, const AssemblyParams& params);

// s, of all moves; rapids at `rapid_feed` mm/min.
double duration(const std::vector<Move>& moves, double rapid_feed);

}  // namespace evenload
