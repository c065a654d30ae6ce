#include "strategy/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Each stage turns this much more tightly than the one before: small enough that what a stage
// leaves in a corner is one pass for the next, large enough that a channel of any width finds a
// stage that uses most of it.
constexpr double kStageRatio = 0.9;

// The same for stages that the walls do not need.
constexpr double kSpareRatio = 0.5;

// mm: how far the exact border lies beyond the border of a stage, in corners or along the walls of
// necks that the stage does not enter.
double deepest_rest(const Region& exact, const Area& stage) {
  double deepest = 0;
  for (const Curve& curve : exact.curves())
    for (const Segment& segment : curve.segments())
      for (const double t : {0.0, 0.5})
        deepest = std::max(deepest, -stage.signed_distance(segment.point(t)));
  return deepest;
}

}  // namespace

std::vector<Stage> make_stages(const Region& centres, const StageLimits& limits,
                               Progress* progress) {
  EVENLOAD_ASSERT(limits.tightest > 0 && limits.tightest <= limits.widest);
  std::vector<Stage> stages;
  bool spare = false;
  for (double turn = limits.widest; turn > (spare ? limits.spare : limits.tightest) * kStageRatio;
       turn *= spare ? kSpareRatio : kStageRatio) {
    if (progress) progress->step();
    const double opening = kOpeningRatio * turn;
    const std::vector<Region> eroded = offset({centres}, -opening);
    if (eroded.empty()) continue;
    Stage stage;
    stage.turn_radius = turn;
    const std::vector<Region> opened = offset(eroded, opening);
    stage.centres = Area(opened);
    stage.turns = Area(offset(opened, -turn));
    if (stage.turns.empty()) continue;
    stage.rooms = opened;
    const double left = deepest_rest(centres, stage.centres);
    stages.push_back(std::move(stage));
    // Whatever a pass cannot enter is left to tighter turns, though the walls need none.
    spare = spare || (left < limits.rest && turn <= limits.first_turn);
  }
  Stage exact;
  exact.rooms = {centres};
  exact.centres = Area({centres});
  stages.push_back(std::move(exact));
  return stages;
}

}  // namespace evenload
