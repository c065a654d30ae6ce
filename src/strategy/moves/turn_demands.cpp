#include "strategy/moves/turn_demands.h"

#include <algorithm>
#include <cmath>

#include "cutting/load_budget.h"
#include "cutting/probe.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/move_ends.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm of path between two looks at the engagement.
constexpr double kEngagementSpacing = 0.005;

struct Look {
  double met = 0, length = 0;  // rad, mm
};

// Looks along the move from its share `from` on, added to `looks`. The ground: before the move.
void look_along(const Segment& move, double from, const ClearedGround& ground,
                std::vector<Look>& looks) {
  Probe probe(ground);
  const double length = (1 - from) * move.length();
  const int n = std::max(1, static_cast<int>(std::lround(length / kEngagementSpacing)));
  for (int i = 0; i < n; ++i) {
    const double t = from + (1 - from) * (i + 0.5) / n;
    looks.push_back({probe.engagement(move, t, kThin), length / n});
  }
}

// rad: the highest mean over `window` mm, or all there is, that ends with one of the looks from
// `first` on.
double highest_mean(const std::vector<Look>& looks, std::size_t first, double window) {
  double highest = 0, sum = 0, length = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    sum += looks[i].met * looks[i].length;
    length += looks[i].length;
    while (length - looks[begin].length >= window) {
      sum -= looks[begin].met * looks[begin].length;
      length -= looks[begin++].length;
    }
    if (i < first || (length < window && i + 1 < looks.size())) continue;
    const double excess = std::max(0.0, length - window);
    highest = std::max(highest, (sum - excess * looks[begin].met) / (length - excess));
  }
  return highest;
}

}  // namespace

bool can_stay(const Segment& move, double from, double to) {
  const double share = to - from;
  return share * move.length() >= kShortestMove &&
         !(move.is_arc() && becomes_corners(move.radius, share * move.sweep));
}

bool may_give_way(const Segment& move, const TurnDemands& demands) {
  return move.is_arc() && !follows_border(move, demands.exact);
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
  ClearedGround& ground = demands.ground;
  std::vector<Look> looks;
  double until_way = length_of(before);  // mm
  for (const Segment& move : before) {
    const double length = move.length(), left_out = until_way - kMeanLength;
    if (left_out < length) look_along(move, std::max(0.0, left_out / length), ground, looks);
    ground.add(move);
    until_way -= length;
  }
  const std::size_t first = looks.size();
  for (const Segment& move : way) {
    look_along(move, 0, ground, looks);
    ground.add(move);
  }
  for (std::size_t i = 0; i < before.size() + way.size(); ++i) ground.remove_last();
  const std::vector<Look> own(looks.begin() + static_cast<std::ptrdiff_t>(first), looks.end());
  const double most = std::max(highest_mean(looks, first, kMeanLength),
                               highest_mean(own, 0, std::min(kMeanLength, length_of(way))));
  return most > demands.engagement + load_budget::kSmooth;
}

}  // namespace evenload
