// Sentences for the report of a trochoidal path: what was not done as asked, where, and why.
#pragma once

#include <string>

#include "geometry/vec2.h"
#include "strategy/trochoid/slot_pattern.h"

namespace evenload {

// Of a region in which no pattern is repeated. `why`: begins with "where".
std::string fallback_note(TrochoidKind kind, Vec2 place, const std::string& why);

// Of circles in place of a pattern of constant engagement.
std::string circles_note(Vec2 place);

// Of a pattern whose advance still differed by `residual` mm after the most passes.
std::string unsettled_note(int passes, double residual);

}  // namespace evenload
