// What a pocket is cleared with: the tool, its engagement, feeds, heights and the user's wishes.
#pragma once

#include <optional>
#include <vector>

#include "cutting/force.h"
#include "feed/feed_control.h"
#include "geometry/region.h"
#include "toolpath/assemble.h"
#include "toolpath/machinable.h"

namespace evenload {

enum class CutMode { kClimb, kConventional };
enum class FeedControl {
  kConstantFeed,
  kConstantRemovalRate,
  kConstantChipThickness,
  kConstantForce
};
enum class EntryKind { kAutomatic, kHelix, kRamp, kPredrilledHole };
// Where the free width is under twice the minimum radius.
enum class NarrowPassages { kTrochoid, kReducedFeed, kSkip };

// mm: the tool stays this far from the wall, so that rounding to three decimals never takes it in.
inline constexpr double kWallGap = 8e-4;

struct ClearingParams {
  double tool_diameter = 6;           // mm, > 0
  double engagement_angle = kPi / 3;  // rad, 0 < angle < pi: target and limit
  CutMode cut_mode = CutMode::kClimb;
  FeedControl feed_control = FeedControl::kConstantFeed;
  double feed = 255;          // mm/min, > 0: feed at the engagement angle
  double plunge_feed = 255;   // mm/min, > 0: entries descend with it
  double link_feed = 1500;    // mm/min, > 0
  double maximum_feed = 510;  // mm/min, >= feed: cap of the feed control
  double least_load = 0;      // 0 to kMostLeastLoad, of the nominal, where slower than the cap
  double most_blocks_per_metre = 0;        // of path, that the controller takes; 0: any number
  double rapid_feed = 5000;                // mm/min, > 0: only for the report's times
  FeedSteps feed_steps;                    // of the feed control
  double move_price = block_price::kMove;  // s: what one move more, for a change of feed, must save
  double roll_radius = 0.9;                // mm, > 0: a wish
  double minimum_radius = 0.9;             // mm, > 0: a wish
  EntryKind entry = EntryKind::kAutomatic;
  double helix_angle = 3 * kPi / 180;  // rad, 0 < angle < pi/2
  double helix_diameter =
      5.4;  // mm, of the tool centre's helix, > 0: shrinks where it does not fit
  std::optional<Vec2> entry_point;  // of the pre-drilled hole
  // Near the open side over which the tool comes in first, where there is one; unset: over the
  // longest, or where a wall leads in.
  std::optional<Vec2> open_side;
  double hole_diameter = 0;   // mm
  double stock_to_leave = 0;  // mm, >= 0, radially
  bool wall_pass = true;
  double tolerance = 0.005;  // mm, > 0
  bool arcs = true;          // false: lines only
  OrderBy order_by = OrderBy::kRegion;
  NarrowPassages narrow_passages = NarrowPassages::kTrochoid;
  double link_lift = 0;                 // mm, >= 0, stays below the level's top
  double top = 0;                       // mm: z of the stock's top
  std::vector<double> levels = {-3.0};  // mm: z of each level, strictly descending, all below top;
                                        // the last is the final depth
  double safe_height = 5;               // mm: rapids down to here are free
  double clearance_height = 10;         // mm: rapids from region to region
  // For a constant force only:
  ForceCoefficients force_coefficients;      // of the material, one at least > 0
  int teeth = 1;                             // >= 1
  double tool_helix_angle = 30 * kPi / 180;  // rad, 0 <= angle < pi/2: of the flutes
  double spindle_speed = 0;                  // rev/min, > 0
  // Where material stands at the levels; unset: all over the regions. Where none stands the ground
  // counts as cleared down to the last level, holes drilled before among it.
  std::optional<std::vector<Region>> stock;
};

}  // namespace evenload
