// Errors of the core.
//
// A bad argument throws std::invalid_argument at the public function that takes it. Geometry that
// cannot be worked on throws GeometryError, which tells what is wrong and where, in codes and
// numbers. Incomplete but usable work is no error: it stands in Report.
#pragma once

#include <stdexcept>
#include <vector>

#include "geometry/vec2.h"
#include "support/refusal.h"

namespace evenload {

class GeometryError : public std::runtime_error {
 public:
  // of_several: it is one of several regions that is refused, the one at the place.
  GeometryError(Refusal refusal, Vec2 where, std::vector<double> numbers = {},
                bool of_several = false);

  GeometryErrorCode code() const { return code_of(refusal_); }
  Refusal refusal() const { return refusal_; }
  Vec2 where() const { return where_; }  // mm, as the user sees it
  const std::vector<double>& numbers() const { return numbers_; }
  bool is_of_several() const { return is_of_several_; }

 private:
  Refusal refusal_;
  Vec2 where_;
  std::vector<double> numbers_;
  bool is_of_several_;
};

// A broken invariant of ours: never the user's fault.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

#define EVENLOAD_ASSERT(condition)                                                      \
  do {                                                                                  \
    if (!(condition)) throw ::evenload::InternalError("broken invariant: " #condition); \
  } while (false)

}  // namespace evenload
