// Turns that are tighter than wished: the tightest of all rooms, for the report.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "geometry/vec2.h"

namespace evenload {

struct TightTurns {
  int rooms = 0;                                            // in which there are such turns
  double radius = std::numeric_limits<double>::infinity();  // mm, the tightest
  Vec2 at;

  void add(const TightTurns& more);
};

// One sentence, however many rooms there are; nothing where no turn was too tight. `wish` mm.
std::optional<std::string> tight_turns_note(const TightTurns& turns, double wish);

}  // namespace evenload
