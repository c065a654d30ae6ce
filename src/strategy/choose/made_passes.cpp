#include "strategy/choose/made_passes.h"

#include <algorithm>
#include <cmath>

#include "strategy/moves/move_ends.h"
#include "support/tolerances.h"

namespace evenload {
MadePasses::Key MadePasses::key_of(const Pass& pass) {
  const Vec2 from = pass.moves.front().a, to = pass.moves.back().b;
  const std::array<double, 6> values{from.x,       from.y, to.x, to.y, length_of(pass.moves),
                                     pass.cut_area};
  Key key;
  std::transform(values.begin(), values.end(), key.begin(),
                 [](double value) { return std::llround(value / kSame); });
  return key;
}

}  // namespace evenload
