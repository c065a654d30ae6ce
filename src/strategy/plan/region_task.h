// One connected region of tool centres at one level: what is to be cleared there, and how.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/region.h"
#include "toolpath/planar.h"

namespace evenload {

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
  // Told of the runs so far after every pass, unless they are a part or go on from others.
  std::function<void(const std::vector<PlanarRun>&)> follow;
};

// Where a place of the task is shown to the user.
inline Vec2 shown_place(const RegionTask& task, Vec2 p) {
  return {task.mirrored ? -p.x : p.x, p.y};
}

}  // namespace evenload
