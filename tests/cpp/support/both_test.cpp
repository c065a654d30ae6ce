// Two calculations at once, and how they are cancelled.
#include "support/both.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/progress.h"

namespace evenload {
namespace {

TEST(Both, ReturnsWhatEachFound) {
  const auto [number, word] = both([] { return 7; }, [] { return std::string("seven"); });
  EXPECT_EQ(number, 7);
  EXPECT_EQ(word, "seven");
}

TEST(Both, ThrowsWhatEitherThrowsOnceTheOtherHasEnded) {
  for (const bool is_first : {true, false}) {
    bool has_ended = false;
    const auto fails = []() -> int { throw std::runtime_error("no pattern"); };
    const auto works = [&] {
      has_ended = true;
      return 1;
    };
    EXPECT_THROW(is_first ? both(fails, works) : both(works, fails), std::runtime_error);
    EXPECT_TRUE(has_ended);
  }
}

TEST(Progress, TellsTheLastShareAgainByStepsUntilItIsCancelled) {
  std::vector<double> shares;
  Progress progress([&](double share) {
    shares.push_back(share);
    return shares.size() < 4;
  });
  progress.step();
  EXPECT_TRUE(progress.report(0.5));
  progress.step();
  EXPECT_THROW(progress.step(), Cancelled);
  EXPECT_TRUE(progress.cancelled());
  EXPECT_THROW(progress.step(), Cancelled);
  EXPECT_EQ(shares, (std::vector<double>{0, 0.5, 0.5, 0.5}));
}

TEST(Progress, IsAskedByTheThreadThatMadeItAloneAndStopsOthersToo) {
  const std::thread::id here = std::this_thread::get_id();
  int asked = 0;
  Progress progress([&](double) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    return ++asked < 3;
  });
  // The other core works on and on: it is this one, which has nothing to do, that hears of it.
  const auto works_on = [&]() -> int {
    for (;;) progress.step();
  };
  EXPECT_THROW(both(
                   works_on, [] { return 1; }, &progress),
               Cancelled);
  EXPECT_EQ(asked, 3);
}

TEST(Progress, APartIsStoppedWithTheWholeWhichHearsOfNoShareOfIt) {
  std::vector<double> shares;
  Progress whole([&](double share) {
    shares.push_back(share);
    return shares.size() < 3;
  });
  whole.report(0.5);
  Progress part = part_of(whole);
  EXPECT_TRUE(part.report(0.1));
  EXPECT_THROW(part.step(), Cancelled);
  EXPECT_TRUE(whole.cancelled());
  EXPECT_EQ(shares, (std::vector<double>{0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace evenload
