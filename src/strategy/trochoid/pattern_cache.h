// The patterns of one call: stretches of one width and curvature share one.
#pragma once

#include <optional>
#include <vector>

#include "strategy/task/clearing_params.h"
#include "strategy/trochoid/slot.h"
#include "strategy/trochoid/slot_pattern.h"

namespace evenload {

// How tightly patterns turn, up to the wished radius.
enum class Turns {
  kQuickest,  // as removes most in a time
  kWished,    // as wished where there is room
};

class PatternCache {
 public:
  // `progress`: of which steps are made while a pattern is sought; it must outlive this object.
  PatternCache(TrochoidKind kind, const ClearingParams& params, Progress* progress = nullptr,
               Turns turns = Turns::kQuickest);

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
