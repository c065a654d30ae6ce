// Turns that are tighter than wished: the tightest of all rooms, for the report.
#pragma once

#include <limits>
#include <optional>

#include "geometry/vec2.h"
#include "toolpath/finding.h"

namespace evenload {

struct TightTurns {
  int rooms = 0;                                            // in which there are such turns
  double radius = std::numeric_limits<double>::infinity();  // mm, the tightest
  Vec2 at;

  void add(const TightTurns& more);
};

// One finding, however many rooms there are; nothing where no turn was too tight. `wish` mm.
std::optional<Finding> finding_of(const TightTurns& turns, double wish);

}  // namespace evenload
