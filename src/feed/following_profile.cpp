#include "feed/following_profile.h"

#include <algorithm>
#include <utility>

#include "support/both.h"

namespace evenload {

FollowingProfile::FollowingProfile(ClearedGround& ground, double spacing, LoadShare share)
    : ground_(ground), spacing_(spacing), share_(std::move(share)) {}

FollowingProfile::~FollowingProfile() { stop(); }

void FollowingProfile::stop() {
  is_wanted_ = false;
  end();
}

std::vector<FollowingProfile::Step> FollowingProfile::steps_of(const std::vector<PlanarRun>& runs) {
  std::vector<Step> steps;
  for (const PlanarRun& run : runs) {
    steps.push_back(run.descent);
    steps.insert(steps.end(), run.moves.begin(), run.moves.end());
  }
  return steps;
}

void FollowingProfile::follow(const std::vector<PlanarRun>& runs, std::size_t first) {
  {
    const std::lock_guard lock(mutex_);
    has_gap_ |= first > runs_;
    if (has_gap_) return;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::size_t run = first + i;
      if (run + 1 < runs_) continue;
      if (run >= runs_) {
        told_.push_back(runs[i].descent);
        runs_ = run + 1;
        moves_ = 0;
      }
      for (; moves_ < runs[i].moves.size(); ++moves_) told_.push_back(runs[i].moves[moves_]);
    }
  }
  is_told_.notify_one();
  if (looking_.valid()) return;
  followed_.emplace(ground_);
  profiler_.emplace(*followed_, spacing_, share_);
  looking_ = std::async(std::launch::async, [this] { look_along_told(); });
}

void FollowingProfile::look_along_told() {
  std::vector<Step> steps;
  for (std::size_t done = 0;; done += steps.size()) {
    {
      std::unique_lock lock(mutex_);
      is_told_.wait(lock, [&] { return is_whole_ || done < told_.size(); });
      steps.assign(told_.begin() + static_cast<std::ptrdiff_t>(done), told_.end());
    }
    if (steps.empty()) return;
    for (const Step& step : steps) {
      if (!is_wanted_) return;
      look_along(step);
    }
  }
}

void FollowingProfile::look_along(const Step& step) {
  if (const Descent* descent = std::get_if<Descent>(&step))
    profiler_->come_down(*descent);
  else
    profiler_->look_along(std::get<PlanarMove>(step));
}

void FollowingProfile::say_all_is_told() {
  {
    const std::lock_guard lock(mutex_);
    is_whole_ = true;
  }
  is_told_.notify_one();
}

// Waits until all that was told has been looked at, or is not wanted.
void FollowingProfile::end() {
  say_all_is_told();
  if (looking_.valid()) looking_.wait();
}

// Whether what was told is how the path begins, and no small part of it.
bool FollowingProfile::begins(const std::vector<Step>& steps) const {
  return told_.size() <= steps.size() && 2 * told_.size() >= steps.size() &&
         std::equal(told_.begin(), told_.end(), steps.begin());
}

std::vector<LoadSample> FollowingProfile::looked_at_anew(const std::vector<PlanarRun>& runs,
                                                         Progress& progress) {
  profiler_.reset();
  followed_.reset();
  ground_.tell(progress);
  return load_profile(runs, ground_, spacing_, share_, &progress);
}

std::vector<LoadSample> FollowingProfile::finish(const std::vector<PlanarRun>& runs,
                                                 Progress& progress) {
  const std::vector<Step> steps = steps_of(runs);
  is_wanted_ = looking_.valid() && begins(steps);
  if (!is_wanted_) {
    end();
    return looked_at_anew(runs, progress);
  }
  say_all_is_told();
  while (looking_.wait_for(kPatience) != std::future_status::ready) progress.step();
  looking_.get();  // throws what was thrown there
  followed_->tell(progress);
  std::for_each(steps.begin() + static_cast<std::ptrdiff_t>(told_.size()), steps.end(),
                [&](const Step& step) { look_along(step); });
  ground_ = std::move(*followed_);
  return profiler_->taken();
}

}  // namespace evenload
