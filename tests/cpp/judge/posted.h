// Paths as posts write them.
#pragma once

#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

// The moves of the program that is posted, read from its commands. Commands do not say what a move
// is for: moves for one purpose are written together.
std::vector<Move> posted(const std::vector<Move>& moves);

}  // namespace evenload
