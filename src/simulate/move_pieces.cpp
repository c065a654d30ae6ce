#include "simulate/move_pieces.h"

#include <algorithm>
#include <cmath>

namespace evenload {

std::vector<MovePiece> pieces_of(const Move& from, const Move& to) {
  const Vec2 a{from.x, from.y}, b{to.x, to.y};
  if (to.sweep == 0) return {{Segment::line(a, b), from.z, to.z}};
  const Vec2 centre{to.cx, to.cy};
  const double begin = distance(a, centre), end = distance(b, centre);
  const double start_angle = angle_of(a - centre);
  // Sums of angles round: a full circle must not become five pieces.
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(to.sweep) / (kPi / 2) - 1e-9)));
  std::vector<MovePiece> pieces;
  Vec2 before = a;
  for (int k = 1; k <= count; ++k) {
    const double share = static_cast<double>(k) / count;
    const Vec2 after = k == count ? b
                                  : centre + (begin + share * (end - begin)) *
                                                 unit(start_angle + share * to.sweep);
    pieces.push_back({Segment::from_bulge(before, after, std::tan(to.sweep / count / 4)),
                      from.z + (to.z - from.z) * (k - 1) / count,
                      from.z + (to.z - from.z) * share});
    before = after;
  }
  return pieces;
}

}  // namespace evenload
