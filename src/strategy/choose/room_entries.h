// How the tool comes into the rooms of a region: over an open edge, by a pre-drilled hole, by a
// helix or a ramp.
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/medial_axis.h"
#include "strategy/choose/pass_choice.h"
#include "strategy/choose/pass_taking.h"
#include "strategy/choose/region_work.h"
#include "strategy/moves/pass.h"

namespace evenload {

class RoomEntries {
 public:
  RoomEntries(RegionWork& work, PassChoice& choice, PassTaking& passes)
      : work_(work),
        plan_(work.plan),
        ground_(work.ground),
        params_(work.params),
        choice_(choice),
        passes_(passes) {}

  // Comes down, and cuts the first pass, a spiral, as far as it goes.
  void enter();
  // Comes down anew in a room that no pass has reached, because the way there is too narrow to be
  // cut within the limit. A room that needs no entry never needs one later.
  bool enter_untouched();
  // The same where passes got no further than the room's mouth, and nothing else will do.
  bool enter_touched() { return enter_next(touched_, true); }

 private:
  // A room by the number of its stage.
  struct NextRoom {
    std::size_t stage = 0, room = 0;
  };

  // Where a wall leads from ground that was cut before into the material.
  void enter_from_before();
  // Over an open edge: where a wall leads into the material, or straight at it; of both what is
  // nearer to the place that is wished. False when the tool finds no room outside.
  bool enter_from_outside();
  void enter_hole();
  // By a helix, or a ramp where none fits. Returns the pose from which the first pass, a spiral,
  // starts; nothing where there is not even room for a ramp.
  std::optional<Pose> descend_in(const Circle& room);
  // Rooms are looked at once, stage by stage.
  bool enter_next(NextRoom& next, bool touched_too);
  // False when the room needs no entry, or is too narrow for one.
  bool enter_room(const Region& room, bool touched_too);
  bool has_cleared_wall(const Region& room) const;
  // A pass from the free pose where the tool came down.
  void cut_from(const Pose& start);

  RegionWork& work_;
  Plan& plan_;
  ClearedGround& ground_;
  const ClearingParams& params_;
  PassChoice& choice_;
  PassTaking& passes_;
  NextRoom untouched_, touched_;  // the first rooms that may need an entry
};

}  // namespace evenload
