#include "strategy/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/tight_turns.h"
#include "support/errors.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// Each stage turns this much more tightly than the one before: small enough that what a stage
// leaves in a corner is one pass for the next, large enough that a channel of any width finds a
// stage that uses most of it.
constexpr double kStageRatio = 0.9;

// The same for stages that the walls do not need.
constexpr double kSpareRatio = 0.5;

// mm: below this the turns of a steered pass, pieces of a fifth of a radian and more, are posted as
// lines with corners between them; only one arc that leads all round the corner stays an arc.
const double kSteeredTurn = std::sqrt(kLeastSpan / std::sin(0.2));
// There stages follow each other so closely that such an arc, along the wall of the next, meets no
// more than this share of the engagement angle; where they would have to follow more closely than
// kFinestRatio, passes would be many: steered ones it is.
constexpr double kHeldShare = 0.8;
constexpr double kFinestRatio = 0.986;
// rad: nor at smaller engagement angles, where even right angles would need many stages, and narrow
// pockets take twice as long to compute.
constexpr double kLeastAngle = 25 * kPi / 180;

// The walls are opened by this much more than the turn radius, so that a pass in the narrowest
// channel of its stage still has room between its roll-in and its roll-out.
constexpr double kOpeningRatio = 1.25;

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

// rad: half the angle of the sharpest corner that the tool turns into.
double sharpest_corner(const Region& region) {
  double least = kPi / 2;
  for (const Curve& curve : region.curves()) {
    const std::vector<Segment> pieces = curve.segments();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Segment& next = pieces[(i + 1) % pieces.size()];
      const double turn = wrap_signed(angle_of(next.tangent(0)) - angle_of(pieces[i].tangent(1)));
      least = std::min(least, 0.5 * (kPi - turn));
    }
  }
  return least;
}

// Of the turn radii of two stages whose walls in the sharpest corner are so far apart that the pass
// along the second meets what it may. Where the first pass turned with radius a about its centre,
// the second does with q a about one that lies (1 - q) a / sin(half the corner) further in, and
// cos(angle met) is a over the largest distance of its path from the first centre.
double corner_ratio(const Region& region, double engagement) {
  if (engagement < kLeastAngle) return kStageRatio;
  const double half_corner = sharpest_corner(region);
  const double held = 1 / std::cos(std::min(kHeldShare * engagement, kPi / 3)) - 1;
  const double ratio = 1 - held / std::max(1e-9, 1 / std::sin(half_corner) - 1);
  return ratio > kFinestRatio ? kStageRatio : std::max(ratio, kStageRatio);
}

}  // namespace

std::vector<Stage> make_stages(const Region& centres, const StageLimits& limits) {
  EVENLOAD_ASSERT(limits.tightest > 0 && limits.tightest <= limits.widest);
  std::vector<Stage> stages;
  const Area exact_area({centres});
  bool spare = false;
  const double in_corner = corner_ratio(centres, limits.engagement);
  const auto next = [&](double turn) {
    if (spare) return turn * kSpareRatio;
    return turn * (turn < kSteeredTurn ? in_corner : kStageRatio);
  };
  for (double turn = limits.widest; turn > (spare ? limits.spare : limits.tightest) * kStageRatio;
       turn = next(turn)) {
    const double opening = kOpeningRatio * turn;
    const std::vector<Region> eroded = offset({centres}, -opening);
    if (eroded.empty()) continue;
    Stage stage;
    stage.turn_radius = turn;
    const std::vector<Region> opened = without_tight_corners(offset(eroded, opening), exact_area);
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
