#include "strategy/left_behind.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/box_tree.h"

namespace evenload {
namespace {

// rad, seen from the turn's centre: between two points of a sliver. Less contact than from one to
// the next is none.
constexpr double kSpacing = 0.5 * kPi / 180;
constexpr std::size_t kContact = 2;  // points
// mm: what is thinner, or meets the tool less deeply, does not count.
constexpr double kThinnest = 2e-5;
// mm: arcs with centres this near are one.
constexpr double kSameCentre = 1e-9;

bool has_arc_about(const std::vector<Segment>& moves, Vec2 centre) {
  return std::any_of(moves.begin(), moves.end(), [&](const Segment& move) {
    return move.is_arc() && distance(move.centre, centre) < kSameCentre;
  });
}

}  // namespace

bool LeftBehind::is_met(Vec2 point, const std::vector<Segment>& moves) const {
  const double deep = radius_ - kThinnest;
  return std::any_of(moves.begin(), moves.end(), [&](const Segment& move) {
    const Bounds box = grown(move.bounds(), deep);
    return point.x > box.low.x && point.x < box.high.x && point.y > box.low.y &&
           point.y < box.high.y && move.distance_to(point) < deep;
  });
}

void LeftBehind::expect(const std::vector<Segment>& planned, const std::vector<Segment>& posted,
                        const ClearedGround& ground) {
  ahead_.clear();
  for (const Segment& turn : posted) {
    if (!turn.is_arc() || has_arc_about(planned, turn.centre)) continue;
    Sliver sliver;
    const int n = static_cast<int>(std::ceil(std::abs(turn.sweep) / kSpacing));
    for (int i = 0; i <= n; ++i) {
      const Vec2 at = turn.point(static_cast<double>(i) / n);
      const Vec2 point = at + radius_ / turn.radius * (at - turn.centre);
      if (is_met(point, planned) && !ground.is_cleared_point(point)) sliver.push_back(point);
    }
    if (sliver.size() >= kContact) ahead_.push_back(std::move(sliver));
  }
}

void LeftBehind::cut(const std::vector<Segment>& moves) {
  for (Sliver& sliver : slivers_)
    std::erase_if(sliver, [&](Vec2 point) { return is_met(point, moves); });
  std::erase_if(slivers_, [](const Sliver& sliver) { return sliver.size() < kContact; });
  std::move(ahead_.begin(), ahead_.end(), std::back_inserter(slivers_));
  ahead_.clear();
}

bool LeftBehind::is_met_along(const std::vector<Segment>& moves) const {
  return std::any_of(slivers_.begin(), slivers_.end(), [&](const Sliver& sliver) {
    const auto met = std::count_if(sliver.begin(), sliver.end(),
                                   [&](Vec2 point) { return is_met(point, moves); });
    return static_cast<std::size_t>(met) >= kContact;
  });
}

}  // namespace evenload
