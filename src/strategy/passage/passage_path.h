// The path through a region with narrow passages while it grows: ways along passages, cut where
// they meet material, joined by links that are tangent to them, or by retracts. Our own.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/choose/region_clearing.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

class PassagePath {
 public:
  PassagePath(const RegionTask& task, const ClearingParams& params, Progress& progress);

  const Area& centres() const { return centres_; }
  const ClearedGround& ground() const { return ground_; }
  const std::vector<PlanarRun>& runs() const { return runs_; }
  std::vector<PlanarRun> take_runs() { return std::move(runs_); }
  const Pose& here() const { return here_; }
  // True where the tool stands as it came down: it may set out in any direction.
  bool may_turn() const { return runs_.back().moves.empty(); }
  bool is_clear(Vec2 p) const { return ground_.is_clear(p); }
  int passes() const { return passes_; }
  int links() const { return links_; }

  // A run that was made elsewhere.
  void append(PlanarRun run);
  // Comes down to `start`; the ground that the descent clears is added.
  void begin(const Descent& descent, const Pose& start, bool is_new);
  // To `to`, a clear place: over clear ground where that is quicker, else up and down.
  void reach(const Pose& to);
  // Along `way`, from where it first meets material to where it last does, as cuts in the passage
  // of that number. Between cuts the way itself is the link where it is not longer than a retract
  // takes. Condition: the way begins where the tool stands, or at a clear place.
  void follow(const std::vector<Segment>& way, int passage);
  // Where the tool meets nothing along a part of `loop`: the loop from there on all round. Empty
  // where it meets material everywhere.
  std::vector<Segment> from_clear_part(const std::vector<Segment>& loop) const;

 private:
  struct Part {
    Segment segment;
    bool clear = false;
  };
  // The move in as few parts as tell where it is clear.
  std::vector<Part> parts_of(const Segment& move) const;
  bool leads_on(const std::vector<Segment>& way) const;
  void add(MoveKind kind, const std::vector<Segment>& moves, int passage);

  const ClearingParams& params_;
  Area centres_;
  ClearedGround ground_;
  std::vector<PlanarRun> runs_;
  Pose here_;
  int passes_ = 0, links_ = 0;
};

}  // namespace evenload
