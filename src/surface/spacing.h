// Where parallel passes lie side by side.
#pragma once

#include <vector>

#include "support/progress.h"
#include "surface/finish_params.h"
#include "surface/ground.h"

namespace evenload {

// The ground that passes may have to cover, seen along them: what has to do with a pass at the
// ordinate `v` to the left lies on the line through v * across.
struct PassFrame {
  Vec2 along, across;                    // of length 1; across is to the left
  double begin = 0, end = 0;             // mm, along: of all passes
  double first = 0, last = 0;            // mm, across: of the picked faces
  double first_pass = 0, last_pass = 0;  // mm, across: where a pass may touch them yet
  PlanLine line(double v) const { return {v * across, along}; }
};

// Throws std::invalid_argument where nothing is picked that can be seen from above.
PassFrame pass_frame(const Ground& ground, double angle);

// Ordinates of passes at a constant distance of `stepover` or just below it, of which the first and
// the last are half of it off the borders of the picked faces.
std::vector<double> even_spacing(const PassFrame& frame, double stepover);

// Ordinates of passes between which `cusp_height` mm stand at the highest place of each strip,
// by CuspRule. Condition: the corner is not 0. Throws Cancelled.
std::vector<double> spacing_by_cusp(const Ground& ground, const PassFrame& frame,
                                    double cusp_height, double deflection, Progress& progress);

}  // namespace evenload
