// The load along a path that is still being made: looked at on a second core, behind the one that
// makes it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <future>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

#include "feed/load_profile.h"

namespace evenload {

class FollowingProfile {
 public:
  // As load_profile() takes them. `ground`: before the first move; it must outlive this object, and
  // stays as it is until finish().
  FollowingProfile(ClearedGround& ground, double spacing, LoadShare share);
  // What was not looked at yet is forgotten.
  ~FollowingProfile();
  FollowingProfile(const FollowingProfile&) = delete;
  FollowingProfile& operator=(const FollowingProfile&) = delete;

  // `runs`: the path so far, from its run numbered `first` on. What was told before is not looked
  // for again; after runs that were left out nothing is followed any more. Not from several threads
  // at once.
  void follow(const std::vector<PlanarRun>& runs, std::size_t first);

  // No more is wanted; waits for the second core to end.
  void stop();

  // The same as load_profile() of the whole path, whatever was told before: where that is not how
  // the path begins, or less than half of it, all is looked at anew. Throws what the share throws
  // on the path, and Cancelled by the steps of `progress` that it makes. To be called once, at the
  // end, and not after stop().
  std::vector<LoadSample> finish(const std::vector<PlanarRun>& runs, Progress& progress);

 private:
  using Step = std::variant<Descent, PlanarMove>;

  static std::vector<Step> steps_of(const std::vector<PlanarRun>& runs);
  bool begins(const std::vector<Step>& steps) const;
  void look_along(const Step& step);
  void look_along_told();
  void say_all_is_told();
  void end();
  std::vector<LoadSample> looked_at_anew(const std::vector<PlanarRun>& runs, Progress& progress);

  ClearedGround& ground_;
  const double spacing_;
  const LoadShare share_;
  std::size_t runs_ = 0, moves_ = 0;  // told of, of the last run
  bool has_gap_ = false;

  std::mutex mutex_;
  std::condition_variable is_told_;
  std::vector<Step> told_;  // grows only
  bool is_whole_ = false;   // nothing more will be told
  std::atomic<bool> is_wanted_ = true;

  // Of the second core until it has ended.
  std::optional<ClearedGround> followed_;  // the ground behind the last move that was looked at
  std::optional<LoadProfiler> profiler_;
  std::future<void> looking_;
};

}  // namespace evenload
