// The ways of a region along which a pattern is worth repeating, or why there is none.
#pragma once

#include <optional>
#include <vector>

#include "strategy/places/area.h"
#include "strategy/plan/region_task.h"
#include "strategy/slots/slot_way.h"
#include "strategy/task/clearing_params.h"
#include "strategy/trochoid/pattern_cache.h"
#include "toolpath/finding.h"

namespace evenload {

// Fewer periods are not worth a pattern.
inline constexpr int kFewestPeriods = 4;

class SlotWays {
 public:
  // Slots take any pattern that there is; pockets only what serves them better than passes do.
  enum class Use { kSlots, kPockets };

  // The references must outlive this object.
  SlotWays(const RegionTask& task, const ClearingParams& params, const Area& centres,
           PatternCache& patterns)
      : task_(task), params_(params), centres_(centres), patterns_(patterns) {}

  void find(Use use);

  // The longest first, both directions of each; where an open side is wished the nearest first.
  std::vector<Way> ways;
  bool is_too_short = false;  // a stretch with a pattern, and no other one serves

  // Where no pattern is repeated.
  Finding why_none() const;

 private:
  void add(const SlotStretch& stretch, Use use);
  FindingCode reason() const;

  const RegionTask& task_;
  const ClearingParams& params_;
  const Area& centres_;
  PatternCache& patterns_;
  std::optional<SlotStretch> longest_stretch_;
};

}  // namespace evenload
