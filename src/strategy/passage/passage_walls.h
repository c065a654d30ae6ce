// The walls of a narrow passage: what a cut along its middle leaves there, taken along every loop
// of its border. The walls lie to the right. Our own.
#pragma once

#include "strategy/passage/passage_path.h"
#include "strategy/places/narrow_passages.h"
#include "strategy/places/passage_axis.h"
#include "strategy/task/clearing_params.h"

namespace evenload {

// A way along a wall begins at a mouth whose room is cleared, or outside an open end, else it rolls
// onto the wall from the middle, by two arcs. Condition: the middle is cut.
void follow_walls(const Passage& passage, const PassageAxis& axis, int number,
                  const ClearingParams& params, PassagePath& path);

}  // namespace evenload
