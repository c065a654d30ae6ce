// Numbers that many tests are about.
#pragma once

#include <random>

namespace evenload {

inline constexpr double kRadius = 3;  // mm: of the tool

// In [low, high); the same on every machine, which std::uniform_real_distribution does not promise.
inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

}  // namespace evenload
