// Passes whose first or last move posts could not write in its direction: they begin a little
// earlier on its line or circle, or end a little later.
#pragma once

#include <vector>

#include "strategy/area.h"
#include "strategy/links.h"

namespace evenload {

// For a first move shorter than 0.03 mm, or an arc too short to be posted as one (small_arc.h).
// `ground`: before the pass. `way` stays as it is where the ground is not clear, or not inside of
// `centres`. Condition: not empty.
void begin_earlier(std::vector<Segment>& way, const GroundBefore& ground, const Area& centres);
// The same for a last arc. `ground`: after the pass.
void end_later(std::vector<Segment>& way, const GroundBefore& ground, const Area& centres);

}  // namespace evenload
