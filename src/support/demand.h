#pragma once

#include <stdexcept>

namespace evenload {

// What is asked of arguments: the sentence goes to the user. Throws std::invalid_argument.
inline void demand(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

}  // namespace evenload
