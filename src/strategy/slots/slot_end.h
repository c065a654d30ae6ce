// The end of a slot beyond the last period of its pattern, where the walls are left to passes.
//
// Periods are counted back from the last place that there is for one, and what the last of them
// leave does not depend on where the first one was. So the end can be cleared before they are, as
// they will leave it, while another core clears the slot's start or other slots.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "strategy/choose/region_clearing.h"
#include "strategy/slots/slot_way.h"

namespace evenload {

// What grows out of `plan` where `part` of a task's region is cleared. Nothing where the tool finds
// no way in, or none at its depth once it is down; then the whole region may still have one.
std::optional<RegionResult> clear_part(const Plan& plan, const RegionTask& whole,
                                       const Region& part, const ClearingParams& params,
                                       Progress& progress);

// Beyond the last period of a way, with what periods cannot reach beside it; nothing where more
// than an end of a slot is there. `centres`: of `region`.
std::optional<Region> end_room(const Region& region, const Area& centres, const Way& way,
                               int last_period);

class EarlyEnd {
 public:
  // Nothing where the way has no such end, or too few periods, which begin `from` mm along it.
  // Condition: what is given here outlives it.
  static std::unique_ptr<EarlyEnd> of(const RegionTask& task, const Area& centres, const Way& way,
                                      double from, const ClearingParams& passes);
  EarlyEnd(const EarlyEnd&) = delete;
  EarlyEnd& operator=(const EarlyEnd&) = delete;

  // Whether it is what `way` leaves whose periods are the `first` one and all after it.
  bool fits(const Way& way, int first) const { return &way == &way_ && first >= settled_; }

  // Clears it, if nobody has begun to and it has not been dropped.
  void clear(Progress& progress);
  void clear();
  // To clear it is of no use any more.
  void drop() { is_wanted_ = false; }

  // What is cut there after the last period: its runs go on from there, the first of them without a
  // descent of its own. Nothing where clear_part() says so, or `progress` that the job is
  // cancelled. Cleared here if nobody has begun to. Once.
  std::optional<RegionResult> cleared(Progress& progress);

 private:
  EarlyEnd(const RegionTask& task, const Way& way, const ClearingParams& passes, int settled,
           Region room);
  std::optional<RegionResult> cut(Progress& progress);

  const RegionTask& task_;
  const Way& way_;
  const ClearingParams& passes_;
  int settled_;  // of so many periods and the last one, that one leaves what all of them would
  Region room_;
  std::atomic<bool> is_wanted_ = true;
  std::atomic_flag is_begun_;
  std::packaged_task<std::optional<RegionResult>(Progress&)> cut_;
  std::future<std::optional<RegionResult>> result_;
};

// Ends that another core clears, one after the other.
class EarlyEnds {
 public:
  explicit EarlyEnds(std::vector<std::unique_ptr<EarlyEnd>> ends);
  ~EarlyEnds();
  EarlyEnds(const EarlyEnds&) = delete;
  EarlyEnds& operator=(const EarlyEnds&) = delete;

  // The one that fits, or nullptr.
  EarlyEnd* of(const Way& way, int first) const;

 private:
  std::vector<std::unique_ptr<EarlyEnd>> ends_;
  std::future<void> clearing_;
};

}  // namespace evenload
