// Passes that were made, as they were steered: to make one of them again would take nothing. What
// it seems to take is a film of micrometres that its smoothing leaves each time.
#pragma once

#include <array>
#include <set>

#include "strategy/steer/steering.h"

namespace evenload {

class MadePasses {
 public:
  // Conditions: the pass is not empty. The same are passes whose ends, length (mm) and area (mm^2)
  // differ by less than rounding does, a millionth.
  void add(const Pass& pass) { made_.insert(key_of(pass)); }
  bool contains(const Pass& pass) const { return made_.count(key_of(pass)) > 0; }

 private:
  using Key = std::array<long long, 6>;
  static Key key_of(const Pass& pass);

  std::set<Key> made_;
};

}  // namespace evenload
