// Passes along chains of straight lines in plan: outlines, turns of spirals, lines between guides.
// Where at least four of these lie within kChords of an arc they are one, unless there are to be no
// arcs. Corners within half of kChords of a line between others are none.
#pragma once

#include <vector>

#include "support/progress.h"
#include "surface/finish_params.h"
#include "surface/ground.h"
#include "surface/passes.h"

namespace evenload {

inline constexpr double kChords = 0.002;    // mm, in plan, of chords off arcs, and arcs off chords
inline constexpr double kSamePlace = 1e-9;  // mm, in plan and in space

struct Polyline {
  std::vector<Vec2> corners;
  bool is_closed = false;
};

// What the passes along some lines cut, each line's pieces in their order with its row's number;
// pieces of a line that meet are one. Throws Cancelled.
std::vector<PassPart> passes_along(const Ground& ground,
                                   const std::vector<std::vector<Polyline>>& rows,
                                   const FinishParams& params, Progress& progress);

}  // namespace evenload
