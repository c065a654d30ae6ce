// What the parts of a region's clearing share: its plan, the places of the tool's centre, the
// stages of turn radii, and what of their walls is cleared.
#pragma once

#include <vector>

#include "geometry/medial_axis.h"
#include "strategy/places/area.h"
#include "strategy/plan/plan.h"
#include "strategy/plan/region_task.h"
#include "strategy/steer/stage.h"
#include "strategy/steer/wall_samples.h"
#include "strategy/task/clearing_params.h"
#include "support/progress.h"

namespace evenload {

// mm: of the place of an entry.
inline constexpr double kEntryTolerance = 1e-3;

// `plan`, `task` and `params` must outlive it. Making the stages is steps of `progress`.
struct RegionWork {
  RegionWork(Plan& plan, const RegionTask& task, const ClearingParams& params, Progress& progress);
  RegionWork(const RegionWork&) = delete;
  RegionWork& operator=(const RegionWork&) = delete;

  // The walls' samples are looked at again: all, beside moves from where the tool stands, beside a
  // descent.
  void look_everywhere();
  void look_again(const std::vector<Segment>& moves);
  void look_again(const Descent& descent);

  // mm: of the turns of links.
  double link_turn() const { return stages.size() > 1 ? stages.front().turn_radius : radius; }

  Plan& plan;
  ClearedGround& ground;  // the plan's
  const RegionTask& task;
  const ClearingParams& params;
  double radius;  // mm, of the tool
  bool goes_on;   // from what the plan has made of this region
  Area exact;     // where the tool's centre may be
  Area around;    // where links may go
  Circle widest;  // the largest among the places of the tool's centre
  StageLimits limits;
  std::vector<Stage> stages;
  WallSamples samples;
};

}  // namespace evenload
