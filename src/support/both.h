// Two calculations that know nothing of each other, at once.
#pragma once

#include <chrono>
#include <future>
#include <utility>

#include "support/progress.h"

namespace evenload {

// Between two questions whether the work is cancelled, while one thread waits for another.
inline constexpr std::chrono::milliseconds kPatience{20};

// What `first` and `second` return, which run on a core each. What one throws is thrown once both
// have ended, the second's before the first's. Conditions: neither writes what the other reads;
// starting a thread, some 50 microseconds, is little beside either. Where a `progress` is given
// both make steps of it; while `second` has ended and `first` has not, they are made here.
template <typename First, typename Second>
auto both(First first, Second second, Progress* progress = nullptr) {
  auto started = std::async(std::launch::async, std::move(first));
  auto of_second = second();
  while (progress && started.wait_for(kPatience) != std::future_status::ready) progress->step();
  return std::pair(started.get(), std::move(of_second));
}

}  // namespace evenload
