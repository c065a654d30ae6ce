// The middle of a narrow passage, cut along every branch. Our own.
#pragma once

#include <cstddef>

#include "strategy/moves/pass.h"
#include "strategy/passage/passage_path.h"
#include "strategy/places/passage_axis.h"
#include "support/progress.h"

namespace evenload {

// At a point of the middle, on the way to its neighbour.
Pose pose_at(const PassageAxis& axis, std::size_t point, std::size_t neighbour);

// Cuts every branch once, from forks that are reached already: from the point `root`, where the
// tool stands or may come to. `number`: the passage's.
void follow_middle(const PassageAxis& axis, std::size_t root, int number, PassagePath& path,
                   const Progress& progress);

}  // namespace evenload
