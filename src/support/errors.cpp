#include "support/errors.h"

#include <cstdio>
#include <string>
#include <utility>

namespace evenload {
namespace {

// For those who debug: users read the sentences of evenload.refusals.
std::string terse(Refusal refusal, Vec2 where) {
  char place[64];
  std::snprintf(place, sizeof place, " at (%.6g, %.6g)", where.x, where.y);
  return name_of(refusal) + std::string(place);
}

}  // namespace

GeometryError::GeometryError(Refusal refusal, Vec2 where, std::vector<double> numbers,
                             bool of_several)
    : std::runtime_error(terse(refusal, where)),
      refusal_(refusal),
      where_(where),
      numbers_(std::move(numbers)),
      is_of_several_(of_several) {}

}  // namespace evenload
