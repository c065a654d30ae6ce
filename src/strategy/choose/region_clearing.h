// Clears one connected region of tool centres at one level: spiral, then passes from wall to wall,
// stage by stage.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/region.h"
#include "strategy/task/clearing_params.h"
#include "strategy/task/turn_report.h"
#include "support/progress.h"
#include "toolpath/finding.h"
#include "toolpath/planar.h"

namespace evenload {

struct RegionResult {
  std::vector<PlanarRun> runs;
  double uncut_area = 0;  // mm^2
  int passes = 0;
  int links = 0;
  TightTurns tight_turns;
  std::vector<Finding> findings;
};

struct RegionTask {
  Region centres;  // where the tool's centre may be, climb milling to the right
  // What stands: the pocket's floor, or for rest machining the stock.
  std::vector<Region> material;
  bool has_open_edges = false;
  bool rest = false;         // earlier cuts left the material: the rest of the ground is cleared
  std::optional<Vec2> hole;  // centre of a pre-drilled hole in this region; not with `rest`
  // An entry's helix, along the room, though a helix was asked for and has room as wished.
  bool stretch_helix = false;
  bool round_helix = false;  // not stretched at all: other entries clear enough
  bool is_part = false;      // more is cleared later: what is left is neither measured nor noted
  bool mirrored = false;     // places of findings and errors are to be mirrored back
  // Where links may go: a superset of `centres` whose border are the walls; empty: `centres`.
  std::vector<Region> around;
  // Made already, elsewhere; with a pre-drilled hole elsewhere they are the way in.
  std::vector<PlanarRun> before;
  // Made already, in this region: taken into the result, and gone on from where its last run ends.
  // Not with `rest`.
  RegionResult opening;
  // What the opening has cleared, with the hole; nullptr: to be found anew.
  const ClearedGround* opened = nullptr;
  // Told of the runs so far after every pass, unless they are a part or go on from an opening.
  std::function<void(const std::vector<PlanarRun>&)> follow;
};

// Where a place of the task is shown to the user.
Vec2 shown_place(const RegionTask& task, Vec2 p);

// Condition: `params` checked; climb milling (the caller mirrors for conventional). Stops early
// when `progress` is cancelled.
RegionResult clear_region(const RegionTask& task, const ClearingParams& params, Progress& progress);

}  // namespace evenload
