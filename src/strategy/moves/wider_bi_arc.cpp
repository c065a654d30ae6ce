#include "strategy/moves/wider_bi_arc.h"

#include <algorithm>
#include <array>
#include <optional>

#include "geometry/bi_arc.h"
#include "strategy/moves/move_checks.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// mm along the path: the furthest that a bi-arc begins before the tight turns, or ends after them.
constexpr double kFurthest = 0.4;
// Shares of a neighbour that are tried in its place, besides all of it.
constexpr std::array<double, 4> kShares{0.15, 0.3, 0.5, 0.75};
// How many times as far along the first tangent as along the last the joints lie that are tried.
constexpr std::array<double, 11> kRatios{1, 0.7, 1.4, 0.5, 2, 0.3, 3, 0.15, 7, 0.07, 14};
// rad: of either arc.
constexpr double kMostArc = kPi;
// Pairs whose engagement is looked at, which takes far longer than all else.
constexpr int kMostLooks = 6;

// Where a bi-arc may begin or end.
struct Place {
  MoveCut cut;
  PlanePoint at;
  double reach = 0;  // mm from the tight turns
};

// Before the moves from `first` on, the nearest first.
std::vector<Place> places_before(const std::vector<Segment>& moves, std::size_t first) {
  std::vector<Place> places;
  double reach = 0;
  for (std::size_t i = first;; --i) {
    places.push_back({{i, 0}, {moves[i].a, moves[i].tangent(0)}, reach});
    if (i == 0 || !is_tangent(moves[i - 1], moves[i], kSmoothJoint)) break;
    const Segment& move = moves[i - 1];
    for (const double share : kShares)
      if (can_stay(move, 0, 1 - share))
        places.push_back({{i - 1, 1 - share},
                          {move.point(1 - share), move.tangent(1 - share)},
                          reach + share * move.length()});
    reach += move.length();
    if (reach > kFurthest) break;
  }
  return places;
}

// After the moves before `last`, the nearest first.
std::vector<Place> places_after(const std::vector<Segment>& moves, std::size_t last) {
  std::vector<Place> places;
  double reach = 0;
  for (std::size_t i = last;; ++i) {
    places.push_back({{i, 0}, {moves[i - 1].b, moves[i - 1].tangent(1)}, reach});
    if (i == moves.size() || !is_tangent(moves[i - 1], moves[i], kSmoothJoint)) break;
    const Segment& move = moves[i];
    for (const double share : kShares)
      if (can_stay(move, share, 1))
        places.push_back(
            {{i, share}, {move.point(share), move.tangent(share)}, reach + share * move.length()});
    reach += move.length();
    if (reach > kFurthest) break;
  }
  return places;
}

struct Pair {
  const Place* from;
  const Place* to;
  double reach() const { return from->reach + to->reach; }
};

}  // namespace

std::vector<Segment> with_wider_bi_arc(const std::vector<Segment>& moves, std::size_t first,
                                       std::size_t last, const TurnDemands& demands) {
  const std::vector<Place> before = places_before(moves, first), after = places_after(moves, last);
  std::vector<Pair> pairs;
  for (const Place& from : before)
    for (const Place& to : after)
      if (from.reach <= kFurthest && to.reach <= kFurthest) pairs.push_back({&from, &to});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.reach() < b.reach(); });
  int looks = 0;
  for (const Pair& pair : pairs) {
    const std::vector<Segment> old = parts_between(moves, pair.from->cut, pair.to->cut);
    for (const double ratio : kRatios) {
      const std::optional<BiArc> two = bi_arc(pair.from->at, pair.to->at, kMostArc, ratio);
      if (!two || !can_stay(two->first, 0, 1) || !can_stay(two->second, 0, 1)) continue;
      const std::vector<Segment> way{two->first, two->second};
      const bool fits = is_near(way, old, demands) &&
                        std::all_of(way.begin(), way.end(), [&](const Segment& arc) {
                          return is_inside(arc, demands.centres, kSame);
                        });
      if (!fits) continue;
      if (!meets_too_much(parts_between(moves, {0, 0}, pair.from->cut), way, demands))
        return replaced(moves, pair.from->cut, pair.to->cut, way);
      if (++looks == kMostLooks) return {};
    }
  }
  return {};
}

}  // namespace evenload
