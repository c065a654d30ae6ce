// The patterns of one call: stretches of one width and curvature share one.
#pragma once

#include <optional>
#include <vector>

#include "strategy/constant_engagement.h"
#include "strategy/slot.h"
#include "strategy/slot_pattern.h"

namespace evenload {

class PatternCache {
 public:
  PatternCache(TrochoidKind kind, const ClearingParams& params);

  TrochoidKind kind() const { return kind_; }

  // Nothing where the tool has too little room to turn, or where the place is a narrow passage that
  // is not to be cleared by trochoids.
  std::optional<SlotPattern> pattern_of(const SlotStretch& stretch);

 private:
  struct Known {
    double half_room = 0, curvature = 0;
    std::optional<SlotPattern> pattern;
  };
  TrochoidKind kind_;
  TrochoidParams slot_;    // but for the width and the curvature
  double least_room_ = 0;  // mm, half of it
  std::vector<Known> known_;
};

}  // namespace evenload
