#include "strategy/move_checks.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm between two looks for contact.
constexpr double kContactLook = 0.02;
// mm between two looks at the border, where one between them might see the move beyond it.
constexpr double kFinestLook = 0.02;

// A place of a move, and where it is to a border.
struct BorderLook {
  double t = 0;
  BoundaryIndex::Hit hit;
  double inside = 0;  // mm; negative: outside
};

}  // namespace

bool is_tangent(const Segment& a, const Segment& b, double difference) {
  return norm(a.tangent(1) - b.tangent(0)) < difference;
}

bool follows_border(const Segment& move, const Area& centres) {
  for (const double t : {0.25, 0.5, 0.75})
    if (std::abs(centres.signed_distance(move.point(t))) > kOnBorder) return false;
  return true;
}

bool is_inside(const Segment& move, const Area& centres, double tolerance) {
  const double length = move.length();
  // Between two looks the distance falls by no more than the way between them, and below the chord
  // by what the move and the border bend towards each other.
  const double bend = std::abs(move.curvature()) + centres.inward_curvature();
  const auto look_at = [&](double t) -> BorderLook {
    const Vec2 p = move.point(t);
    const BoundaryIndex::Hit hit = centres.nearest(p);
    return {t, hit, centres.signed_distance(p, hit)};
  };
  const auto is_sure_between = [&](const BorderLook& a, const BorderLook& b) {
    const double way = (b.t - a.t) * length;
    const double least = std::max(0.5 * (a.inside + b.inside - way),
                                  std::min(a.inside, b.inside) - bend * way * way / 8);
    return way <= kFinestLook || least >= -tolerance;
  };
  const auto follow_one_piece = [](const BorderLook& a, const BorderLook& b, const BorderLook& c) {
    return std::max({std::abs(a.inside), std::abs(b.inside), std::abs(c.inside)}) < kOnBorder &&
           a.hit.curve == b.hit.curve && b.hit.curve == c.hit.curve &&
           a.hit.segment == b.hit.segment && b.hit.segment == c.hit.segment;
  };
  std::vector<BorderLook> ahead{look_at(1)};
  BorderLook here = look_at(0);
  if (here.inside < -tolerance || ahead.back().inside < -tolerance) return false;
  while (!ahead.empty()) {
    const BorderLook& next = ahead.back();
    if (!is_sure_between(here, next)) {
      const BorderLook middle = look_at(0.5 * (here.t + next.t));
      if (middle.inside < -tolerance) return false;
      if (!follow_one_piece(here, middle, next)) {
        ahead.push_back(middle);
        continue;
      }
    }
    here = next;
    ahead.pop_back();
  }
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
