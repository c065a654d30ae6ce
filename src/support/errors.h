// Errors of the core.
//
// A bad argument throws std::invalid_argument at the public function that takes it. Geometry that
// cannot be worked on throws GeometryError, which says what is wrong and where. Incomplete but
// usable work is no error: it stands in Report.
#pragma once

#include <stdexcept>
#include <string>

#include "geometry/vec2.h"

namespace evenload {

enum class GeometryErrorCode {
  kNotFinite,      // a coordinate or bulge is NaN or infinite
  kTooFewPoints,   // a closed curve that bounds no area
  kOpen,           // a chain that should be closed is not
  kSelfCrossing,   // a curve crosses or touches itself, or two curves of one region cross
  kIslandOutside,  // an island that does not lie inside its outer boundary
  kToolTooLarge,   // the tool fits nowhere
  kEntryOutside,   // an entry point or pre-drilled hole that cannot be used
  kNoLameCurve,    // a pocket that no Lamé curve resembles
};

class GeometryError : public std::runtime_error {
 public:
  GeometryError(GeometryErrorCode code, Vec2 where, const std::string& sentence)
      : std::runtime_error(sentence), code_(code), where_(where) {}
  GeometryErrorCode code() const { return code_; }
  Vec2 where() const { return where_; }

 private:
  GeometryErrorCode code_;
  Vec2 where_;
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
