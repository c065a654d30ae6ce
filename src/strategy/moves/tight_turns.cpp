#include "strategy/moves/tight_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "strategy/moves/move_checks.h"
#include "strategy/moves/turn_demands.h"
#include "strategy/moves/wider_bi_arc.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm, and of the engagement angle: the thickest that may be left, and the longest arc on which the
// tool meets it.
constexpr double kThickest = 0.004;
constexpr double kArcShare = 0.04;
// rad: such an arc may be as long as this however small the angle is; links may meet no more.
constexpr double kLeastArc = 0.9 * kPi / 180;
// mm: what the first turn of a pass may leave, where no pass runs along: beside an entry, or on the
// wall that the pass leaves.
constexpr double kThickestAtStart = 0.0015;
// mm along the path: where the first new arc that is tried begins before the old ones, and by how
// much further each next one does.
constexpr double kFirstReach = 0.002;
constexpr double kReachGrowth = 1.15;
// mm: the furthest. A right angle that is turned at a radius of nothing reaches so far.
constexpr double kFurthestReach = 0.3;
// Of the reach before: the least behind, and by how much further each next one is that is tried.
constexpr double kLeastShare = 0.1;
constexpr double kShareGrowth = 1.5;
// mm: to which the reach behind is found.
constexpr double kSameReach = 1e-10;

// Of unit vectors: where a new arc ends, and along what follows it.
constexpr double kSameDirection = 1e-5;

// A place `reach` mm before the end of the moves [0, n), or after the start of the moves from n on.
std::optional<MoveCut> cut_before(const std::vector<Segment>& moves, std::size_t n, double reach) {
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n && !is_tangent(moves[i], moves[i + 1], kSmoothJoint)) return std::nullopt;
    const double length = moves[i].length();
    if (reach <= length) return MoveCut{i, 1 - reach / length};
    reach -= length;
  }
  return std::nullopt;
}

std::optional<MoveCut> cut_after(const std::vector<Segment>& moves, std::size_t n, double reach) {
  for (std::size_t i = n; i < moves.size(); ++i) {
    if (i > n && !is_tangent(moves[i - 1], moves[i], kSmoothJoint)) return std::nullopt;
    const double length = moves[i].length();
    if (reach <= length) return MoveCut{i, reach / length};
    reach -= length;
  }
  return std::nullopt;
}

// Turned from the direction of `from` to the chord, less what is turned from there to `to`: 0 where
// one arc leads from the one to the other.
double imbalance(const Segment& from, double t0, const Segment& to, double t1) {
  const Vec2 chord = to.point(t1) - from.point(t0), a = from.tangent(t0), b = to.tangent(t1);
  return std::atan2(cross(a, chord), dot(a, chord)) - std::atan2(cross(chord, b), dot(chord, b));
}

class Widening {
 public:
  Widening(const std::vector<Segment>& moves, std::size_t first, std::size_t last,
           const TurnDemands& demands)
      : moves_(moves), first_(first), last_(last), demands_(demands) {}

  // The moves with the tight ones replaced; empty where that cannot be.
  std::vector<Segment> widened() {
    if (first_ == 0 || last_ == moves_.size()) return {};
    for (double reach = kFirstReach; reach <= kFurthestReach; reach *= kReachGrowth) {
      const std::optional<MoveCut> from = cut_before(moves_, first_, reach);
      if (!from) return {};
      if (!can_stay(moves_[from->move], 0, from->t)) continue;
      const std::optional<MoveCut> to = end_of_arc(*from, reach);
      if (!to || !can_stay(moves_[to->move], to->t, 1)) continue;
      std::vector<Segment> result = with_arc(*from, *to);
      if (!result.empty()) return result;
      if (too_far_) return {};
    }
    return {};
  }

 private:
  // Where an arc that begins at `from` ends tangentially.
  std::optional<MoveCut> end_of_arc(const MoveCut& from, double reach) const {
    const auto off = [&](const MoveCut& to) {
      return imbalance(moves_[from.move], from.t, moves_[to.move], to.t);
    };
    const std::optional<MoveCut> first = cut_after(moves_, last_, 0);
    if (!first) return std::nullopt;
    const bool falls = off(*first) > 0;
    double low = 0, high = kLeastShare * reach;
    for (;; low = high, high *= kShareGrowth) {
      const std::optional<MoveCut> to = cut_after(moves_, last_, high);
      if (!to || high > kFurthestReach) return std::nullopt;
      if ((off(*to) > 0) != falls) break;
    }
    while (high - low > kSameReach) {
      const double middle = 0.5 * (low + high);
      ((off(*cut_after(moves_, last_, middle)) > 0) == falls ? low : high) = middle;
    }
    return cut_after(moves_, last_, high);
  }

  std::vector<Segment> with_arc(const MoveCut& from, const MoveCut& to) {
    const Segment& before = moves_[from.move];
    const Segment& after = moves_[to.move];
    const Vec2 a = before.point(from.t), b = after.point(to.t), along = before.tangent(from.t);
    const double half = std::atan2(cross(along, b - a), dot(along, b - a));
    if (std::abs(half) >= 0.5 * kPi) return {};
    const Segment arc = Segment::from_bulge(a, b, std::tan(half / 2));
    if (is_tight(arc)) return {};
    if (norm(arc.tangent(1) - after.tangent(to.t)) > kSameDirection) return {};
    too_far_ = !is_near({arc}, parts_between(moves_, from, to), demands_);
    if (too_far_ || !is_inside(arc, demands_.centres, kSame)) return {};
    const std::vector<Segment> kept = parts_between(moves_, {0, 0}, from);
    too_far_ = meets_too_much(kept, {arc}, demands_);
    if (too_far_) return {};
    return replaced(moves_, from, to, {arc});
  }

  const std::vector<Segment>& moves_;
  std::size_t first_, last_;  // of the tight moves, last excluded
  const TurnDemands& demands_;
  bool too_far_ = false;
};

// The moves with those of [first, last) replaced, or else those and an arc beside them: no one arc
// leads from an arc on past a wider one to a straight.
std::vector<Segment> with_wider(const std::vector<Segment>& moves, std::size_t first,
                                std::size_t last, const TurnDemands& demands) {
  std::vector<Segment> wider = Widening(moves, first, last, demands).widened();
  if (wider.empty() && first > 0 && may_give_way(moves[first - 1], demands) &&
      is_tangent(moves[first - 1], moves[first], kSmoothJoint))
    wider = Widening(moves, first - 1, last, demands).widened();
  if (wider.empty() && last < moves.size() && may_give_way(moves[last], demands) &&
      is_tangent(moves[last - 1], moves[last], kSmoothJoint))
    wider = Widening(moves, first, last + 1, demands).widened();
  if (wider.empty()) {
    TurnDemands bi_arc_demands = demands;
    if (first == 0) bi_arc_demands.widening = std::max(demands.widening, kThickestAtStart);
    wider = with_wider_bi_arc(moves, first, last, bi_arc_demands);
  }
  return wider;
}

std::vector<Segment> widened(const std::vector<Segment>& moves, const TurnDemands& demands) {
  std::vector<Segment> result = moves;
  for (std::size_t i = 0; i < result.size();) {
    std::size_t end = i;
    while (end < result.size() && is_tight(result[end]) && may_give_way(result[end], demands) &&
           (end == i || is_tangent(result[end - 1], result[end], kSmoothJoint)))
      ++end;
    if (end == i) {
      ++i;
      continue;
    }
    std::vector<Segment> wider = with_wider(result, i, end, demands);
    if (wider.empty())
      i = end;
    else
      result = std::move(wider);  // what follows has moved up: look here again
  }
  return result;
}

}  // namespace

double most_widening(double engagement, double tool_radius, double tolerance) {
  const double arc = std::max(kArcShare * engagement, kLeastArc);
  return std::min({tolerance, kThickest, 0.5 * tool_radius * arc * arc});
}

std::vector<Segment> without_tight_turns(const std::vector<Segment>& moves, const TurnRoom& room,
                                         ClearedGround& ground, double engagement,
                                         double widening) {
  return widened(moves, {room.centres, room.walls, widening, kThickest, ground, engagement});
}

}  // namespace evenload
