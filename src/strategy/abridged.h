// Work whose path can be made from that of smaller work, in which less of the same is to be done: a
// long slot is cut as a short one is, but for more periods of its trochoid.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "geometry/region.h"
#include "strategy/constant_engagement.h"
#include "toolpath/planar.h"

namespace evenload {

// What the path of the whole has more than that of the abridged work, at one level.
struct Unabridged {
  int passes = 0, links = 0;
  double area = 0;  // mm^2 that are cleared
};

// mm^2 by the numbers of the periods, PlanarMove::period.
using RemovedByPeriod = std::map<int, double>;

struct Abridged {
  std::vector<Region> regions;
  std::optional<Vec2> entry_point;
  std::function<Vec2(Vec2)> whole_place;  // where a place of the abridged work is in the whole
  // Makes the path of the whole from that of the abridged work, feeds and all. Nothing, and `runs`
  // of no use, where that cannot be done exactly.
  std::function<std::optional<Unabridged>(std::vector<PlanarRun>& runs, const RemovedByPeriod&)>
      unabridge;
};

// Nothing where there is nothing to leave out. `regions`: of tool centres are `centres`.
using Abridge = std::function<std::optional<Abridged>(
    const std::vector<Region>& regions, const std::vector<Region>& centres, const ClearingParams&)>;

}  // namespace evenload
