// The order of the parts of passes, links between them, and the ways over the part.
#pragma once

#include <vector>

#include "support/progress.h"
#include "surface/finish_params.h"
#include "surface/passes.h"
#include "toolpath/toolpath.h"

namespace evenload {

// The path through all parts, in the order of their rows. But for those one way: on to the nearest
// place where a part of the next row may begin, along the surface where that is within kLinkReach
// stepovers or the tool's radius; else over the part to the first that is left. Patterns to and fro
// turn parts round for that, spirals go on in the same turn or the next. One way: always over the
// part. Where the tool comes from the air it begins, and where it goes there it ends, by an upright
// arc of `lead_radius`, a smaller one or none where that would cut into the part. Condition: there
// is a part. Throws Cancelled.
Toolpath in_order(const Ground& ground, std::vector<PassPart> parts, const FinishParams& params,
                  Progress& progress);
inline constexpr double kLinkReach = 3;

}  // namespace evenload
