// Many chips at once, on all cores.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "ball_end/bent_surface.h"
#include "ball_end/chip.h"
#include "ball_end/part_profile.h"
#include "support/progress.h"

namespace evenload {

using Worked = std::variant<PartProfile, BentPlace>;

struct WantedChip {
  std::size_t worked;  // the number of its surface in a list
  double y;            // on a PartProfile: plan ordinate of the tool
  ChipCase task;
};

// Laws: the same numbers on any number of threads; 0: all. Throws as chip(), for a place beyond a
// section's ends, and Cancelled where `progress` says so.
std::vector<Chip> chips(const std::vector<Worked>& surfaces, Steps steps,
                        const std::vector<WantedChip>& wanted, int threads, Progress& progress);

}  // namespace evenload
