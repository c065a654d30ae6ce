// Where the ways along a region's slots begin: beside the stock, about a pre-drilled hole, or in a
// room at an end of the slot.
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/region.h"
#include "strategy/places/area.h"
#include "strategy/plan/region_task.h"
#include "strategy/slots/slot_rooms.h"
#include "strategy/slots/slot_ways.h"
#include "strategy/task/clearing_params.h"

namespace evenload {

// A room from which `way` can begin once it is cleared.
struct WayBegin {
  StartRoom start;
  const Way* way = nullptr;
};

class SlotStart {
 public:
  // The references must outlive this object. `found`: the ways, which are told where they are too
  // short for a start.
  SlotStart(const RegionTask& task, const ClearingParams& params, const Area& centres,
            SlotWays& found)
      : task_(task), params_(params), centres_(centres), found_(found) {}

  // Where along a way its first room ends.
  enum class Place { kBegin, kPastJunction };

  // Whether the way that is followed first begins beside the stock.
  bool is_outside(const ClearedGround& ground) const;
  // The room about the task's hole, where a way leads on from there.
  std::optional<Region> about_hole() const;
  // Of the ways [first, last), which are equally long: an end of the slot if there is one, of these
  // the smallest.
  std::optional<WayBegin> smallest_end(std::size_t first, std::size_t last, Place place);
  // The first place of a period that leaves room behind its front for a helix as wide as the slot.
  double first_place(const Way& way) const;

 private:
  // Where a way begins in a junction, as the sides of a frame do in its corners: as soon as it has
  // both walls.
  std::optional<StartRoom> past_junction(const Way& way) const;
  std::optional<StartRoom> room_of(const Way& way, double s) const;

  const RegionTask& task_;
  const ClearingParams& params_;
  const Area& centres_;
  SlotWays& found_;
};

}  // namespace evenload
