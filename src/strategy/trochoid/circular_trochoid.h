// The circular and the cycloidal trochoid, to compare the pattern of constant engagement with, and
// to choose where a controller or a habit wants them [Jacsó 2021, Thesis IV, names both].
//
// Circular: whole circles between the walls, a straight piece of one step along the right wall from
// circle to circle. Cycloid: the circle's centre moves evenly all the time, so the loops are
// trochoids in the sense of geometry, made of bi-arcs. In both the part of the loop on the cleared
// side, a little less than half of it, cuts nothing and counts as the link. The step is the
// greatest that keeps the limit; on the way through the front the engagement changes all the time
// and is at the limit in one place only.
#pragma once

#include <optional>

#include "strategy/trochoid/trochoid_period.h"

namespace evenload {

// `params.turn_radius` and `params.finish_walls` mean nothing here: the circle has half the room
// for its radius. Nothing where no step keeps the limit. Throw as check() does.
std::optional<TrochoidPattern> circular_pattern(const TrochoidParams& params);
std::optional<TrochoidPattern> cycloid_pattern(const TrochoidParams& params);
}  // namespace evenload
