#include "strategy/choose/region_work.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/box_tree.h"
#include "strategy/reach/entry.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// No stage turns more tightly than posts can write, kTightestArc, but for this share of the widest
// room's radius: a region that is narrow everywhere is turned in more tightly. The exact border
// clears what is narrower, bit by bit.
constexpr double kTightestInRoom = 0.3;
// Share of the tool's radius: the tightest turn that the walls do not need.
constexpr double kSpareTurn = 0.03;
// mm: a corner is left to the exact border once it is so short that the mean engagement over 0.1 mm
// stays low in it.
constexpr double kShortCorner = 0.055;
// mm per rad of the engagement angle: at small angles less.
constexpr double kShortCornerPerAngle = 0.143;
// There is a stage that turns as tightly as this share of the entry's radius: a first pass that
// turns less tightly than the entry's circle would run into more material than the limit allows.
constexpr double kFirstTurn = 0.5;
// Side steps in the tool's radius: so many passes a place of a wall gets for each of them. Ten
// times what was seen in the finest gaps.
constexpr double kMostPasses = 150;

// mm: of the circle that the tool's centre runs on before the first pass.
double entry_radius(const RegionTask& task, const ClearingParams& params, const Circle& widest) {
  return task.hole ? 0.5 * params.hole_diameter - 0.5 * params.tool_diameter
                   : helix_radius(params, widest);
}

StageLimits limits_of(const RegionTask& task, const ClearingParams& params, const Circle& widest,
                      bool goes_on) {
  const double radius = 0.5 * params.tool_diameter;
  const double wish = std::max(params.roll_radius, params.minimum_radius);
  const double tightest = std::max(
      kTightestPosted,
      std::min({kTightestArc, kTightestArcShare * radius, kTightestInRoom * widest.radius}));
  return {std::max(wish, tightest), tightest,
          std::min(kShortCorner, kShortCornerPerAngle * params.engagement_angle),
          std::max(kSpareTurn * radius, tightest),
          goes_on ? std::numeric_limits<double>::infinity()
                  : kFirstTurn * entry_radius(task, params, widest)};
}

// To one place of a wall: fine gaps need some hundreds at 15 degrees, and more the smaller the
// side step is.
int most_passes(const ClearingParams& params) {
  const double side_steps = 1 / (1 - std::cos(std::min(params.engagement_angle, kPi / 2)));
  return static_cast<int>(std::min(1e9, kMostPasses * std::max(1.0, side_steps)));
}

std::vector<Stage> stages_of(const RegionTask& task, const ClearingParams& params,
                             const StageLimits& limits, Progress& progress) {
  std::vector<Stage> all = make_stages(task.centres, limits, &progress);
  if (!params.wall_pass && all.size() > 1) all.pop_back();  // the exact border
  return all;
}

}  // namespace

RegionWork::RegionWork(Plan& plan_of_it, const RegionTask& its_task,
                       const ClearingParams& its_params, Progress& progress)
    : plan(plan_of_it),
      ground(plan.ground()),
      task(its_task),
      params(its_params),
      radius(0.5 * params.tool_diameter),
      goes_on(!plan.is_empty()),
      exact({task.centres}),
      around(task.around.empty() ? std::vector<Region>{task.centres} : task.around),
      widest(largest_circle(task.centres, kEntryTolerance)),
      limits(limits_of(task, params, widest, goes_on)),
      stages(stages_of(task, params, limits, progress)),
      samples(stages, ground, most_passes(params)) {
  ground.tell(progress);
}

void RegionWork::look_everywhere() {
  const Bounds everywhere = bounds_of({task.centres});
  samples.update(everywhere.low, everywhere.high);
}

void RegionWork::look_again(const std::vector<Segment>& moves) {
  Vec2 low = plan.here().p, high = low;
  for (const Segment& move : moves)
    for (int i = 0; i <= 4; ++i) {
      const Vec2 p = move.point(i / 4.0);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  samples.update(low, high);
}

void RegionWork::look_again(const Descent& descent) {
  Bounds box{descent.at, descent.at};
  if (descent.kind == DescentKind::kHelix) {
    const Vec2 opposite = 2 * descent.centre - descent.at;
    box = joined(box, {opposite, opposite});
  }
  for (const Vec2 p : descent.ramp_by) box = joined(box, {p, p});
  samples.update(box.low, box.high);
}

}  // namespace evenload
