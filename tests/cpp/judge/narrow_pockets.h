// Pockets with narrow passages, and what is asked of every path through them.
#pragma once

#include <string>
#include <vector>

#include "judge/judged.h"

namespace evenload::narrow_pockets {

using corpus::Case;

// For a tool of 6 mm at 60 degrees.
Case pocket_of(std::vector<Vertex> outer, std::vector<Curve> islands = {});
Case slot(double width, double angle = 0);  // 40 mm long
// The middle line of a straight one, from (0, 0) along x.
inline Curve line(double length) { return Curve({{{0, 0}}, {{length, 0}}}, false); }
// Two rooms of 18 x 20 mm, 12 mm apart.
Case two_rooms(double width);
Case ring(double width);
Case dead_end(double width);
// Two slots that cross.
Case cross(double width);
Case open_slot(double width);

Toolpath clear(const Case& pocket, NarrowPassages choice,
               FeedControl control = FeedControl::kConstantFeed);
// Answers what the judge found.
path_check::Findings expect_cleared(const Case& pocket, const Toolpath& path);
int entries(const Toolpath& path);
// How many passages it skipped, or cut at a reduced feed, says its report.
int skipped(const Toolpath& path);
int reduced(const Toolpath& path);

}  // namespace evenload::narrow_pockets
