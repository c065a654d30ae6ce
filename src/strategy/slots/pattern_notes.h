// What is told of the patterns that are repeated in one region.
#pragma once

#include <optional>
#include <vector>

#include "strategy/plan/plan.h"
#include "strategy/slots/slot_way.h"

namespace evenload {

class PatternNotes {
 public:
  // The references must outlive this object. `report`: of all regions of one call.
  PatternNotes(const RegionTask& task, const ClearingParams& params, Plan& plan,
               TrochoidReport& report)
      : task_(task), params_(params), plan_(plan), report_(report), length_before_(report.length) {}

  // Along `length` mm of a way; `cut`: of one of its periods.
  void repeated(const Way& way, double length, const std::vector<Segment>& cut);
  bool is_repeated() const { return report_.length > length_before_; }

  // The middle of the first way along which circles are repeated.
  const std::optional<Vec2>& circles_at() const { return circles_at_; }

 private:
  void note_turns(const std::vector<Segment>& cut);
  // Once for all ways of one pattern.
  void note_residual(const Way& way);

  const RegionTask& task_;
  const ClearingParams& params_;
  Plan& plan_;
  TrochoidReport& report_;
  double length_before_;  // mm, of the report
  std::optional<Vec2> circles_at_;
};

}  // namespace evenload
