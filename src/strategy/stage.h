// Where the tool's centre may be, and how tightly it may turn there.
//
// The region of the tool's centres is cleared in stages. Stage 0 takes all that can be reached with
// the wished turn radius: the region's opening by it, so that every concave corner of its border is
// an arc that the tool can follow. Each later stage turns more tightly and takes what the one
// before could not enter, narrow channels and corners; the last follows the exact border. Our own;
// the source bounds its turns by one roll radius [Jacsó 2021, hybrid path].
#pragma once

#include <vector>

#include "strategy/area.h"
#include "support/progress.h"

namespace evenload {

struct Stage {
  double turn_radius = 0;     // mm, of left turns; 0: the exact border, sharp corners and all
  std::vector<Region> rooms;  // where the tool's centre may be, piece by piece
  Area centres;  // the same: where the tool's centre may be; its border is the wall to follow
  Area turns;    // where the centre of a left turn may be
};

struct StageLimits {
  double widest = 0.9;      // mm, the turn radius of the first stage
  double tightest = 0.003;  // mm, the smallest turn radius
  double rest = 0.02;       // mm: few further stages once the corners that are left are shorter,
  double spare = 0.09;      // mm: down to this turn radius
  double first_turn = 1e9;  // mm: the first pass must be able to turn as tightly as this
};

// The walls of a stage are opened by this much more than the turn radius, so that a pass in the
// narrowest channel of its stage still has room between its roll-in and its roll-out.
inline constexpr double kOpeningRatio = 1.25;

// The stages of one connected region of tool centres, from the widest turn radius to the exact
// border. Stages in which nothing could be turned in are left out. Each is a step of `progress`.
// Condition: 0 < tightest <= widest.
std::vector<Stage> make_stages(const Region& centres, const StageLimits& limits,
                               Progress* progress = nullptr);

}  // namespace evenload
