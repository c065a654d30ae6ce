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

// What stands between two passes of a ball, or of a rounded corner, on level ground, mm; and how
// far passes may be apart, in mm, where a height is wished. stepover: up to twice the corner.
double cusp_of(double corner, double stepover);
double stepover_for(double corner, double cusp_height);

// Ordinates of passes at a constant distance of `stepover` or just below it, of which the first and
// the last are half of it off the borders of the picked faces.
std::vector<double> even_spacing(const PassFrame& frame, double stepover);

// Ordinates of passes between which `cusp_height` mm stand at the highest place of each strip.
//
// Between the centres c1, c2 of the corner's circle on two passes and cm midway, at one place along
// them, stand r - sqrt(r^2 - w^2/4) - e: w is the distance of c1 and c2 across the feed, e how far
// cm lies above their middle, along the normal. This is exact for a ball on all ground whose
// curvature is the same across the strip, and more than what stands for a tool with a flat. w and e
// are found on a wider strip, so that `deflection`, by which triangles leave the part, in mm,
// counts for little. Condition: the corner is not 0. Throws Cancelled.
std::vector<double> spacing_by_cusp(const Ground& ground, const PassFrame& frame,
                                    double cusp_height, double deflection, Progress& progress);

}  // namespace evenload
