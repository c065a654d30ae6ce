// Two calculations that know nothing of each other, at once.
#pragma once

#include <future>
#include <utility>

namespace evenload {

// What `first` and `second` return, which run on a core each. What one throws is thrown once both
// have ended, the second's before the first's. Conditions: neither writes what the other reads;
// starting a thread, some 50 microseconds, is little beside either.
template <typename First, typename Second>
auto both(First first, Second second) {
  auto started = std::async(std::launch::async, std::move(first));
  auto of_second = second();
  return std::pair(started.get(), std::move(of_second));
}

}  // namespace evenload
