// Closed rows with the step to the next one at each corner, and what lies within these steps.
#pragma once

#include <vector>

#include "geometry/united.h"
#include "support/progress.h"

namespace evenload {

// A closed row's outline with the step at each corner, inwards to the left.
struct Stepped {
  std::vector<Vec2> corners;
  std::vector<double> steps;
};

// All outlines of patches, with corners no further apart than kStationsApart, and no steps yet.
std::vector<Stepped> outlines_of(const std::vector<Patch>& patches);

// What lies within a share of the steps of rows, to their left (side 1) or right (-1). Throws
// Cancelled, as the next.
std::vector<Patch> bands(const std::vector<Stepped>& rows, double share, int side,
                         Progress& progress);

// Rows with the steps of the ones before, which have made their distance.
std::vector<Stepped> outwards(const std::vector<Stepped>& rows, const std::vector<Stepped>& before,
                              Progress& progress);

}  // namespace evenload
