#include "strategy/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/round_necks.h"
#include "strategy/move_checks.h"
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

// Necks narrower than twice this much more than the turn radius keep their corners.
constexpr double kNeckRatio = 1.02;

// mm: below this the turns of a steered pass, pieces of a fifth of a radian and more, are posted as
// lines with corners between them; only one arc that leads all round the corner stays an arc.
const double kSteeredTurn = std::sqrt(kLeastSpan / std::sin(0.2));
// There stages follow each other so closely that such an arc, along the wall of the next, meets no
// more than this share of the engagement angle; in corners in which they would have to follow more
// closely than kFinestRatio, passes would be many: steered ones it is.
constexpr double kHeldShare = 0.95;
constexpr double kFinestRatio = 0.986;
constexpr double kRatioStep = 1e-3;  // rad, to which such corners are told apart
constexpr double kExactRatio = 1e-5;
constexpr int kCornerLooks = 24;  // along a turn

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

// rad: half the angle of the sharpest corner that the tool turns into, of those no sharper than
// twice `sharp`.
double sharpest_corner(const Region& region, double sharp) {
  double least = kPi / 2;
  for (const Curve& curve : region.curves()) {
    const std::vector<Segment> pieces = curve.segments();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Segment& next = pieces[(i + 1) % pieces.size()];
      const double turn = wrap_signed(angle_of(next.tangent(0)) - angle_of(pieces[i].tangent(1)));
      const double half = 0.5 * (kPi - turn);
      if (half >= sharp) least = std::min(least, half);
    }
  }
  return least;
}

// rad: the most that is met along the wall of a stage in a corner of twice `half` rad, where the
// pass before followed the wall of one that turns 1 / `ratio` times as widely. That pass left a
// disc clear, about its turn's centre; beside it the tool, which is wide, meets what lies within
// acos(its radius / distance) of the direction from there, and of that what lies ahead.
double met_in_corner(double ratio, double half) {
  const double apart = (1 - ratio) / std::sin(half);  // of the two turns' centres
  double most = 0;
  for (int i = 0; i <= kCornerLooks; ++i) {
    const double right = i * (kPi / 2 - half) / kCornerLooks;  // of the tool, from the bisector
    const Vec2 from_disc = Vec2{apart, 0} + ratio * unit(right);
    const double to_side = std::acos(std::min(1.0, 1 / norm(from_disc)));
    most = std::max(most, to_side + right - angle_of(from_disc));
  }
  return most;
}

// Where `is_low` changes from true to false, within `exact`.
template <typename IsLow>
double change_between(double low, double high, double exact, IsLow is_low) {
  while (high - low > exact) {
    const double middle = 0.5 * (low + high);
    (is_low(middle) ? low : high) = middle;
  }
  return high;
}

// How far apart the turn radii of two stages may be, as a ratio, for passes along the walls of the
// second to keep to kHeldShare of `engagement` in all corners but those so sharp that it would have
// to be above kFinestRatio.
double held_ratio_of(const Region& region, double engagement) {
  const double most = kHeldShare * engagement;
  const double sharp = change_between(0, kPi / 2, kRatioStep, [&](double half) {
    return met_in_corner(kFinestRatio, half) > most;
  });
  return held_ratio(sharpest_corner(region, sharp), engagement);
}

}  // namespace

double held_ratio(double half, double engagement) {
  const double most = kHeldShare * engagement;
  return change_between(0, 1, kExactRatio,
                        [&](double ratio) { return met_in_corner(ratio, half) > most; });
}

std::vector<Stage> make_stages(const Region& centres, const StageLimits& limits,
                               Progress* progress) {
  EVENLOAD_ASSERT(limits.tightest > 0 && limits.tightest <= limits.widest);
  std::vector<Stage> stages;
  const Area exact_area({centres});
  bool spare = false;
  const double held = held_ratio_of(centres, limits.engagement);
  const auto next = [&](double turn) {
    const double ratio = spare ? kSpareRatio : kStageRatio;
    return turn * (ratio * turn < kSteeredTurn ? std::max(ratio, held) : ratio);
  };
  for (double turn = limits.widest; turn > (spare ? limits.spare : limits.tightest) * kStageRatio;
       turn = next(turn)) {
    if (progress) progress->step();
    const double opening = kOpeningRatio * turn;
    const std::vector<Region> eroded = offset({centres}, -opening);
    if (eroded.empty()) continue;
    Stage stage;
    stage.turn_radius = turn;
    const auto is_within = [&](const Segment& arc) {
      return is_inside(arc, exact_area, kOnBorder);
    };
    // A neck that is rounded must leave room for turns, or its walls lead where none can end.
    const std::vector<Region> opened = without_tight_corners(
        with_round_necks(offset(eroded, opening), opening, kNeckRatio * turn, is_within),
        exact_area);
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
