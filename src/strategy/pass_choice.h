// Which pass to cut from a place where one can start: how tightly it turns, and whether it leaves
// the wall. Passes are steered for trial, and the best of them is left in the ground. Our own; the
// source has one roll radius [Jacsó 2021, hybrid path].
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/constant_engagement.h"
#include "strategy/entry.h"
#include "strategy/stage.h"
#include "strategy/steering.h"
#include "strategy/wall_samples.h"

namespace evenload {

// mm, of turns.
struct TurnLimits {
  double widest = 0.9;      // of the first stage
  double tightest = 0.003;  // to the right
};

// False for an empty pass, and for one that removes next to nothing.
bool is_progress(const Pass& pass, double tool_radius);

class PassChoice {
 public:
  // All references must outlive this object; `stages` are there at the latest when it is used.
  PassChoice(ClearedGround& ground, const std::vector<Stage>& stages, const ClearingParams& params,
             const TurnLimits& limits);

  // Each returns a pass, whose moves are the newest of the ground, and the turn radius of its
  // stage, mm; or an empty pass where none can be cut.
  //
  // From a free pose, with the widest turn that can be made there.
  Pass from_pose(const Pose& start, double* turn_radius);
  // The same where the tool came down, with the widest turn whose pass leads out of the material
  // again. Beside a ramp's slot a wide turn may end at once in the middle of a front, and in a
  // narrow room no other pass would find a start then. Where none leads out, with the widest turn.
  Pass from_entry(const Pose& start, double* turn_radius);
  // Along a wall: in a corner the pass that is worth most, elsewhere the one with the widest turn,
  // no wider than its stage's, that can enter there.
  Pass from_wall(const PassStart& start, double* turn_radius);

  // Whether there is material where an entry ends, but the pass from there gets next to nothing of
  // it. The ground is left as it was.
  bool leads_nowhere(const Entry& entry);

 private:
  Steering steering_on(const Stage& stage);
  Steering steering_at(std::size_t k);
  std::size_t widest_stage_at(const Pose& pose) const;
  double worth(const Pass& pass) const;
  Pass best_corner_pass(const PassStart& start, double* turn_radius);
  Pass latest_wall_pass(const PassStart& start, double* turn_radius);
  std::optional<Pose> clear_before(Vec2 p) const;
  Pass across_gap(const PassStart& start, double* turn_radius);

  ClearedGround& ground_;
  const std::vector<Stage>& stages_;
  const ClearingParams& params_;
  TurnLimits limits_;
  double radius_;
  std::size_t best_in_corner_ = 0;   // the stage of the last pass into a corner
  Vec2 tried_at_;                    // where it began
  int since_tried_;                  // passes
  std::size_t latest_followed_ = 0;  // the stage of the last pass along a wall
  std::optional<Vec2> followed_at_;  // where it began
};

// Takes the moves of `pass`, the newest, back from the ground.
void take_back(ClearedGround& ground, const Pass& pass);

}  // namespace evenload
