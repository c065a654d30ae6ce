// The same work on several threads.
#include "support/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace evenload {
namespace {

TEST(ParallelFor, DoesEachPieceOnceOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<int> done(1000, 0);
    Progress progress;
    parallel_for(
        done.size(), threads, [&](std::size_t i) { ++done[i]; }, progress);
    EXPECT_EQ(done, std::vector<int>(1000, 1));
  }
  Progress progress;
  parallel_for(
      0, 4, [](std::size_t) { FAIL(); }, progress);
}

TEST(ParallelFor, ThrowsWhatTheWorkThrowsAndStops) {
  Progress progress;
  std::atomic<int> calls{0};
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 3) throw std::runtime_error("no value");
  };
  EXPECT_THROW(parallel_for(100000000, 2, work, progress), std::runtime_error);
  EXPECT_LT(calls, 100000000);
}

TEST(ParallelFor, TellsItsShareAndIsCancelled) {
  std::vector<double> shares;
  Progress progress([&](double share) {
    shares.push_back(share);
    return shares.size() < 5;
  });
  EXPECT_THROW(parallel_for(
                   100, 1, [](std::size_t) {}, progress),
               Cancelled);
  EXPECT_EQ(shares, (std::vector<double>{0, 0.01, 0.02, 0.03, 0.04}));
}

TEST(ParallelFor, IsCancelledHoweverSoonTheOtherThreadsAreThroughWithIt) {
  for (int turn = 0; turn < 300; ++turn) {
    Progress progress([](double) { return false; });
    std::atomic<int> calls{0};
    EXPECT_THROW(parallel_for(
                     8, 8, [&](std::size_t) { ++calls; }, progress),
                 Cancelled);
    EXPECT_EQ(calls, 0);
  }
}

}  // namespace
}  // namespace evenload
