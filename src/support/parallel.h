// The same work for many numbers, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "support/progress.h"

namespace evenload {

// Calls work(i) once for every i below `count`, on `threads` threads of which this is one, in no
// order. What `work` throws first is thrown once all have stopped; Cancelled where `progress` says
// so, which hears the share that is done. Condition: called by the thread that made `progress`;
// work(i) writes nothing that another call reads, so that the result does not depend on `threads`.
template <typename Work>
void parallel_for(std::size_t count, int threads, const Work& work, Progress& progress) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr error;
  std::atomic<bool> has_error{false};
  const auto take = [&](bool is_owner) {
    try {
      for (std::size_t i = next++; i < count && !stop; i = next++) {
        if (is_owner && i > 0) progress.report(static_cast<double>(i) / static_cast<double>(count));
        if (progress.cancelled()) throw Cancelled();
        work(i);
      }
    } catch (...) {
      stop = true;
      if (!has_error.exchange(true)) error = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  // Asked before the others begin: small work may be done by them before this thread has its turn.
  if (count > 0) progress.report(0);
  const auto wanted = std::min<std::size_t>(count, static_cast<std::size_t>(std::max(1, threads)));
  for (std::size_t i = 1; i < wanted; ++i) others.emplace_back(take, false);
  take(true);
  for (std::thread& other : others) other.join();
  if (error) std::rethrow_exception(error);
}

// As many as the machine runs at once, where `threads` is 0.
inline int thread_count(int threads) {
  if (threads > 0) return threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace evenload
