#include "strategy/turn_demands.h"

#include <algorithm>
#include <cmath>

#include "strategy/links.h"
#include "strategy/move_checks.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// mm: no rest of a move is shorter; rounded to 0.0001 mm it would be turned by half a degree.
constexpr double kShortestRest = 0.01;
// mm of path between two looks at the engagement.
constexpr double kEngagementSpacing = 0.005;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;

}  // namespace

bool can_stay(const Segment& move, double from, double to) {
  const double share = to - from;
  return share * move.length() >= kShortestRest &&
         !(move.is_arc() && becomes_corners(move.radius, share * move.sweep));
}

bool may_give_way(const Segment& move, const TurnDemands& demands) {
  return move.is_arc() && std::abs(move.sweep) >= demands.least_turn &&
         !follows_border(move, demands.exact);
}

std::vector<Segment> parts_between(const std::vector<Segment>& moves, const MoveCut& from,
                                   const MoveCut& to) {
  std::vector<Segment> parts;
  for (std::size_t k = from.move; k <= to.move && k < moves.size(); ++k) {
    const double t0 = k == from.move ? from.t : 0, t1 = k == to.move ? to.t : 1;
    if (t1 > t0) parts.push_back(moves[k].part(t0, t1));
  }
  return parts;
}

std::vector<Segment> replaced(const std::vector<Segment>& moves, const MoveCut& from,
                              const MoveCut& to, const std::vector<Segment>& way) {
  std::vector<Segment> result = parts_between(moves, {0, 0}, from);
  result.insert(result.end(), way.begin(), way.end());
  const std::vector<Segment> after = parts_between(moves, to, {moves.size(), 0});
  result.insert(result.end(), after.begin(), after.end());
  return result;
}

bool is_near(const std::vector<Segment>& way, const std::vector<Segment>& old,
             const TurnDemands& demands) {
  const auto is_near_to = [&](const Segment& move, Vec2 p) {
    const double t = move.nearest(p);
    const Vec2 off = p - move.point(t);
    const bool is_left = cross(move.tangent(t), off) > 0;
    return norm(off) <= (is_left ? demands.deepening : demands.widening);
  };
  return std::all_of(old.begin(), old.end(), [&](const Segment& move) {
    for (int i = 0; i <= kMoveLooks; ++i) {
      const Vec2 p = move.point(static_cast<double>(i) / kMoveLooks);
      if (std::none_of(way.begin(), way.end(), [&](const Segment& s) { return is_near_to(s, p); }))
        return false;
    }
    return true;
  });
}

bool meets_too_much(const std::vector<Segment>& before, const std::vector<Segment>& way,
                    const TurnDemands& demands) {
  if (!demands.ground) return false;
  ClearedGround& ground = *demands.ground;
  for (const Segment& move : before) ground.add(move);
  const double length = length_of(way), window = std::min(kMeanLength, length);
  const double spacing = std::min(kEngagementSpacing, length);
  const auto in_window = static_cast<std::size_t>(std::max(1.0, std::round(window / spacing)));
  std::vector<double> met;
  std::vector<AngularInterval> pieces;
  double sum = 0, most = 0;
  for (const Segment& move : way) {
    const int n = std::max(1, static_cast<int>(std::lround(move.length() / spacing)));
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, right = angle_of(move.tangent(t)) - kPi / 2;
      ground.uncovered(move.point(t), right, right + kPi, pieces, kThin, ground.size());
      met.push_back(0);
      for (const AngularInterval& piece : pieces) met.back() += piece.width();
      sum += met.back();
      if (met.size() > in_window) sum -= met[met.size() - 1 - in_window];
      most = std::max(most, sum / static_cast<double>(in_window));
    }
    ground.add(move);
  }
  for (std::size_t i = 0; i < before.size() + way.size(); ++i) ground.remove_last();
  return most > demands.engagement + kSmoothOverload;
}

}  // namespace evenload
