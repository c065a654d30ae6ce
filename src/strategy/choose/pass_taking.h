// Takes the passes of a region into its plan: joined, with wider turns, led to by links or ways
// back, or from above.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "strategy/choose/made_passes.h"
#include "strategy/choose/region_work.h"
#include "strategy/moves/pass.h"

namespace evenload {

class PassTaking {
 public:
  explicit PassTaking(RegionWork& work)
      : work_(work), plan_(work.plan), ground_(work.ground), params_(work.params) {}

  // A pass that begins where the tool stands; its moves are the newest of the ground. False when it
  // cuts next to nothing.
  bool take_from_here(Pass pass, double turn_radius);
  // A pass from somewhere, made since the ground had `before` moves: the tool goes to where it
  // meets material. False when it cuts next to nothing, or cannot be come to; also where just this
  // pass has been made before, and then nothing is made.
  bool take_new(const Pass& pass, double turn_radius, std::size_t before);

  // Of the turns tighter than wished where walls are close together.
  void tell_tightest_turn();

 private:
  // Joins the moves of the newest pass, here and in the ground. Returns the way to be posted, with
  // wider turns; what these leave is too little to come back for.
  std::vector<Segment> smooth(Pass& pass);
  // Goes to where the pass meets material, and takes it into the result. `before`: the size of the
  // ground before the pass. False when it cuts next to nothing.
  bool go_and_take(Pass pass, double turn_radius, std::size_t before);
  // Takes a pass that begins where the tool stands into the result. False when it cuts next to
  // nothing.
  bool take(Pass pass, double turn_radius);
  bool link_to(const Pose& to, std::size_t before);
  // Back along the cuts since the last link: the only links that turn about at their ends. False
  // where these did not run through `to`, or where to go up and down is quicker.
  bool back_to(const Pose& to);
  // Up, and down where the ground is clear. Between what earlier operations left the tool comes
  // down off the wall, where there is such a place, so that no edge brushes it. False when it
  // cannot come down there.
  bool come_down_at(const Pose& to);
  // Whether the walls are so close together that no wished turn fits. In corners none does, and
  // nobody needs to be told.
  bool is_narrow_at(Vec2 p);

  RegionWork& work_;
  Plan& plan_;
  ClearedGround& ground_;
  const ClearingParams& params_;
  std::size_t settled_ = 0;  // moves of the ground that stay
  MadePasses made_;
  std::optional<Area> narrow_;                                 // where no wished turn fits
  double tightest_ = std::numeric_limits<double>::infinity();  // mm, the tightest turn made there
  Vec2 tightest_at_;
};

}  // namespace evenload
