// The path through a region while it is made: its runs, the ground that they clear, and where the
// tool stands, in step. Patterns, spirals, ways along passages and passes at constant engagement
// add to it, one after the other. Passes that are steered are tried in its ground before they are
// posted.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/moves/pass.h"
#include "strategy/places/area.h"
#include "strategy/plan/region_task.h"
#include "strategy/task/clearing_params.h"
#include "strategy/task/turn_report.h"
#include "support/progress.h"
#include "toolpath/finding.h"
#include "toolpath/planar.h"

namespace evenload {

// What was made of one region, and what is to be told of it.
struct RegionResult {
  std::vector<PlanarRun> runs;
  double uncut_area = 0;  // mm^2
  int passes = 0;
  int links = 0;
  TightTurns tight_turns;
  std::vector<Finding> findings;
};

// What moves are told apart by, as PlanarMove has it.
struct MoveTags {
  int passage = -1;
  bool in_pattern = false;
};

class Plan {
 public:
  // Nothing is made; of the ground a pre-drilled hole is clear. `params` must outlive this object
  // and its copies; `progress`, of which looks at the ground are steps, as long as anything is
  // asked of them.
  Plan(const RegionTask& task, const ClearingParams& params, Progress& progress);

  const RegionResult& made() const { return made_; }
  const std::vector<PlanarRun>& runs() const { return made_.runs; }
  bool is_empty() const { return made_.runs.empty(); }
  const ClearedGround& ground() const { return ground_; }
  // For passes that are steered, which clear it while they are tried.
  ClearedGround& ground() { return ground_; }
  const Pose& here() const { return here_; }
  // True where the tool stands as it came down: it may set out in any direction.
  bool may_turn() const { return runs().back().moves.empty(); }

  // ---- ways; links run over cleared ground and are no part of it ----

  // Comes down; what a helix or ramp clears is cleared. The tool stands as `here`.
  void come_down(const Descent& descent, const Pose& here);
  void come_down(const Descent& descent) { come_down(descent, {descent.at, 0}); }
  // Straight down where nothing stands; `again`: because moves of ours cleared the place.
  void plunge(const Pose& to, bool again);
  // Goes on by moves of this kind; cuts clear the ground.
  void add(MoveKind kind, const std::vector<Segment>& moves, MoveTags tags = {});
  // A pass for which the ground has what was steered, while turns in `moves` may be wider and ends
  // cut off: what that leaves is too little to come back for.
  void add_steered(const std::vector<Segment>& moves);
  // To `to` over ground that was clear before the move numbered `before`, inside `around`; false
  // where nothing is made yet, where there is no such way, or to go up and down is quicker.
  bool link_to(const Pose& to, const Area& around, double turn_radius, std::size_t before);
  bool link_to(const Pose& to, const Area& around, double turn_radius) {
    return link_to(to, around, turn_radius, ground_.size());
  }
  // What the moves do not say: the tool stands as `pose` before it comes down, or turns there.
  void stand(const Pose& pose) { here_ = pose; }

  // ---- what others made ----

  // Only the ground is cleared by them.
  void know(const std::vector<PlanarRun>& runs);
  // Another room of the region, all of it.
  void append(RegionResult room);
  // The same where it goes on from here: its first run has no descent of its own.
  void go_on_by(RegionResult end);
  // In place of all this what has grown out of it; its ground has the moves as they are posted.
  void adopt(RegionResult grown);

  // ---- what is told ----

  void count_pass() { ++made_.passes; }
  void tell(Finding finding) { made_.findings.push_back(std::move(finding)); }
  // A turn tighter than wished, `radius` mm; the region counts once.
  void note_turn(double radius, Vec2 shown_at);
  void leave(double uncut_area) { made_.uncut_area = uncut_area; }

  // ---- marks ----

  struct Mark {
    std::size_t runs = 0, moves = 0;  // of the last run
    std::size_t ground = 0;           // moves
    int passes = 0, links = 0;
    std::size_t findings = 0;
    Pose here;
  };
  Mark mark() const;
  // As it was, but for what was told. Condition: the ground was not settled since.
  void roll_back(const Mark& mark);

  RegionResult take() { return std::move(made_); }

 private:
  void go(const PlanarMove& move);
  void clear(const PlanarRun& run);
  void clear(const std::vector<PlanarMove>& moves, std::size_t from);
  void stand_at_end();
  void count(const RegionResult& more);

  const ClearingParams* params_;
  ClearedGround ground_;
  RegionResult made_;
  Pose here_;
};

// What of `made` came since `mark` was set: runs, of which the first goes on from there, without a
// descent of its own, passes, links and findings.
RegionResult since(const Plan::Mark& mark, RegionResult made);

}  // namespace evenload
