// Two calculations at once.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/both.h"

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

}  // namespace
}  // namespace evenload
