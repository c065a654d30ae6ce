#include "strategy/move_checks.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm between two looks for contact.
constexpr double kContactLook = 0.02;

}  // namespace

bool is_tangent(const Segment& a, const Segment& b, double difference) {
  return norm(a.tangent(1) - b.tangent(0)) < difference;
}

bool follows_border(const Segment& move, const Area& centres) {
  for (const double t : {0.25, 0.5, 0.75})
    if (std::abs(centres.signed_distance(move.point(t))) > kOnBorder) return false;
  return true;
}

bool is_inside(const Segment& move, const Area& centres, double tolerance, int looks) {
  for (int i = 0; i <= looks; ++i)
    if (centres.signed_distance(move.point(static_cast<double>(i) / looks)) < -tolerance)
      return false;
  return true;
}

std::size_t first_left_behind(const std::vector<Segment>& moves) {
  double turn = 0;
  std::size_t first = moves.size();
  for (; first > 0; --first) {
    turn += moves[first - 1].sweep;
    if (std::abs(turn) > kComesBack) break;
  }
  return first;
}

double idle_end_of(const std::vector<Segment>& moves, double most, ClearedGround& ground) {
  const std::size_t before = ground.size();
  for (const Segment& move : moves) ground.add(move);
  std::vector<AngularInterval> arcs;
  double idle = 0, behind = 0;
  for (std::size_t i = moves.size(); i-- > 0 && arcs.empty() && behind < most;) {
    const Segment& move = moves[i];
    const double length = move.length();
    const int looks = std::max(1, static_cast<int>(std::ceil(length / kContactLook)));
    for (int k = looks; k >= 0 && arcs.empty(); --k) {
      const double t = static_cast<double>(k) / looks;
      const double right = angle_of(move.tangent(t)) - kPi / 2;
      ground.uncovered(move.point(t), right, right + kPi, arcs, kCoverTolerance, before + i);
      if (arcs.empty()) idle = behind + (1 - t) * length;
    }
    behind += length;
  }
  while (ground.size() > before) ground.remove_last();
  return std::min(idle, most);
}

}  // namespace evenload
