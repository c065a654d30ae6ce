// What passes leave that the plan counts as cleared: slivers of some micrometres in corners, where
// a turn is posted more widely than it was planned (tight_turns.h), or as lines (small_arc.h). The
// next pass meets them; a link must not.
#pragma once

#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/curve.h"

namespace evenload {

class LeftBehind {
 public:
  explicit LeftBehind(double tool_radius) : radius_(tool_radius) {}

  // What a pass that is cut next will leave, posted one way, planned another. `ground`: as planned,
  // without the pass.
  void expect(const std::vector<Segment>& planned, const std::vector<Segment>& posted,
              const ClearedGround& ground);
  // The pass is cut, along `moves`.
  void cut(const std::vector<Segment>& moves);
  // True where the tool, on its way along `moves`, meets more of a sliver than counts as contact.
  bool is_met_along(const std::vector<Segment>& moves) const;

 private:
  // Points of a sliver's side towards the tool, side by side.
  using Sliver = std::vector<Vec2>;

  double radius_;
  std::vector<Sliver> slivers_, ahead_;
};

}  // namespace evenload
