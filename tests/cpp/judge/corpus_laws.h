// What is asked of every path through a pocket of the corpus.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "judge/judged.h"

namespace evenload::corpus {

// A test that runs for each case bears the name of the case.
inline std::string name_of(const testing::TestParamInfo<std::string>& info) { return info.param; }

inline constexpr double kMostOver = 2 * kPi / 180;    // rad above the engagement angle
inline constexpr double kMostLinked = 1 * kPi / 180;  // rad, of a link
inline constexpr double kDeepestGouge = 0.005;        // mm
inline constexpr double kMostLeft = 0.0005;           // of the area within reach
inline constexpr double kLeastClimb = 0.995;          // of the cuts' length

void expect_within_limits(const Case& pocket, const Toolpath& path,
                          const path_check::Findings& found);
// Clears the moved case, and expects of it what is asked of every path, and the time and the length
// of the path at home.
void expect_same_when_moved(const Case& original, const Toolpath& at_home, double angle,
                            bool mirrored, Vec2 shift);
void expect_same_bytes(const Toolpath& a, const Toolpath& b);

}  // namespace evenload::corpus
