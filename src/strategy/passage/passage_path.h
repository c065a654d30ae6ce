// The path through a region with narrow passages while it grows: ways along passages, cut where
// they meet material, joined by links that are tangent to them, or by retracts. Our own.
#pragma once

#include <vector>

#include "strategy/places/area.h"
#include "strategy/plan/plan.h"
#include "strategy/plan/region_task.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

class PassagePath {
 public:
  PassagePath(const RegionTask& task, const ClearingParams& params, Progress& progress);

  const Area& centres() const { return centres_; }
  Plan& plan() { return plan_; }
  const Pose& here() const { return plan_.here(); }
  bool may_turn() const { return plan_.may_turn(); }
  bool is_clear(Vec2 p) const { return plan_.ground().is_clear(p); }

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

  const ClearingParams& params_;
  Area centres_;
  Plan plan_;
};

}  // namespace evenload
