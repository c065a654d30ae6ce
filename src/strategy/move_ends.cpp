#include "strategy/move_ends.h"

#include <cstddef>

namespace evenload {

void drop_first(std::vector<Segment>& moves, double length) {
  std::size_t whole = 0;
  for (; whole + 1 < moves.size() && moves[whole].length() <= length; ++whole)
    length -= moves[whole].length();
  moves.erase(moves.begin(), moves.begin() + static_cast<std::ptrdiff_t>(whole));
  const double share = length / moves.front().length();
  if (share > 1e-9 && share < 1) moves.front() = moves.front().part(share, 1);
}

void drop_last(std::vector<Segment>& moves, double length) {
  for (; moves.size() > 1 && moves.back().length() <= length; moves.pop_back())
    length -= moves.back().length();
  const double share = 1 - length / moves.back().length();
  if (share > 0 && share < 1 - 1e-9) moves.back() = moves.back().part(0, share);
}

}  // namespace evenload
