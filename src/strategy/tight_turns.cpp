#include "strategy/tight_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "cutting/engagement.h"
#include "strategy/move_checks.h"
#include "strategy/turn_demands.h"
#include "strategy/wider_bi_arc.h"
#include "toolpath/small_arc.h"

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

// Turns in the open: how far they are from the border, as a share of the tool's radius, and in mm,
// which is more than what is replaced reaches; the thickest that may be left, as a share of the
// side step, and in mm: a sharp right angle needs 0.031.
constexpr double kInTheOpen = 0.1;
constexpr double kLeastInTheOpen = 0.45;
constexpr double kOpenShare = 0.25;
constexpr double kThickestInTheOpen = 0.035;

// rad: corners of a wall that turn by less are followed as they are; a pass widens them by next to
// nothing.
constexpr double kSharpCorner = 0.2;

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
  // `free_end`: the replaced moves are the last, and their end may turn by a little.
  Widening(const std::vector<Segment>& moves, std::size_t first, std::size_t last,
           const TurnDemands& demands, bool free_end = false)
      : moves_(moves), first_(first), last_(last), demands_(demands), free_end_(free_end) {}

  // The moves with the tight ones replaced; empty where that cannot be.
  std::vector<Segment> widened() {
    if (first_ == 0 || (last_ == moves_.size() && !free_end_)) return {};
    for (double reach = kFirstReach; reach <= kFurthestReach; reach *= kReachGrowth) {
      const std::optional<MoveCut> from = cut_before(moves_, first_, reach);
      if (!from) return {};
      if (!can_stay(moves_[from->move], 0, from->t)) continue;
      const std::optional<MoveCut> to =
          free_end_ ? MoveCut{moves_.size() - 1, 1} : end_of_arc(*from, reach);
      if (!to || (!free_end_ && !can_stay(moves_[to->move], to->t, 1))) continue;
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
    if (!free_end_ && norm(arc.tangent(1) - after.tangent(to.t)) > kSameDirection) return {};
    too_far_ = !is_near({arc}, parts_between(moves_, from, to), demands_);
    if (too_far_ || !is_inside(arc, demands_.centres, kOnBorder)) return {};
    const std::vector<Segment> kept = parts_between(moves_, {0, 0}, from);
    too_far_ = meets_too_much(kept, {arc}, demands_);
    if (too_far_) return {};
    return replaced(moves_, from, to, {arc});
  }

  const std::vector<Segment>& moves_;
  std::size_t first_, last_;  // of the tight moves, last excluded
  const TurnDemands& demands_;
  bool free_end_;
  bool too_far_ = false;
};

// A closed curve's pieces, the first of which is a part of the longest one, and the last the other.
std::vector<Segment> opened_up(const Curve& curve) {
  std::vector<Segment> pieces = curve.segments();
  const auto longest =
      std::max_element(pieces.begin(), pieces.end(),
                       [](const Segment& a, const Segment& b) { return a.length() < b.length(); });
  std::rotate(pieces.begin(), longest, pieces.end());
  const Segment whole = pieces.front();
  pieces.front() = whole.part(0.5, 1);
  pieces.push_back(whole.part(0, 0.5));
  return pieces;
}

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
  if (wider.empty() && demands.ground) {
    TurnDemands bi_arc_demands = demands;
    if (first == 0) bi_arc_demands.widening = std::max(demands.widening, kThickestAtStart);
    wider = with_wider_bi_arc(moves, first, last, bi_arc_demands);
    // With nothing after it but an arc at the most, a turn need not end in the same direction.
    if (wider.empty() && last + 1 >= moves.size())
      wider = Widening(moves, first, moves.size(), demands, true).widened();
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

std::vector<Segment> widened_in_the_open(const std::vector<Segment>& moves, const Area& centres,
                                         ClearedGround& ground, double engagement) {
  if (first_left_behind(moves) > 0) return moves;
  const double radius = ground.tool_radius();
  const double widening =
      std::min(kThickestInTheOpen, kOpenShare * side_step(std::min(engagement, 0.5 * kPi), radius));
  return widened(moves, {centres, centres, widening, kThickest, 0, &ground, engagement,
                         std::max(kInTheOpen * radius, kLeastInTheOpen)});
}

}  // namespace

double most_widening(double engagement, double tool_radius, double tolerance) {
  const double arc = std::max(kArcShare * engagement, kLeastArc);
  return std::min({tolerance, kThickest, 0.5 * tool_radius * arc * arc});
}

std::vector<Segment> without_tight_turns(const std::vector<Segment>& moves, const Area& centres,
                                         ClearedGround& ground, double engagement,
                                         double widening) {
  return widened(moves, {centres, centres, widening, kThickest, 0, &ground, engagement});
}

WidenedPass with_wide_turns(const std::vector<Segment>& moves, const Area& centres,
                            const Area& walls, ClearedGround& ground, double engagement,
                            double tolerance) {
  const double widening = most_widening(engagement, ground.tool_radius(), tolerance);
  const auto posted = [&](const std::vector<Segment>& cut) {
    return widened(cut, {centres, walls, widening, kThickest, 0, &ground, engagement});
  };
  WidenedPass pass{moves, posted(moves)};
  if (std::any_of(pass.posted.begin(), pass.posted.end(), is_tight)) {
    pass.cut = widened_in_the_open(moves, centres, ground, engagement);
    pass.posted = posted(pass.cut);
  }
  return pass;
}

std::vector<Region> without_tight_corners(const std::vector<Region>& regions, const Area& exact) {
  const Area inside(regions);
  const TurnDemands demands{inside,  exact, kFurthestReach, kFurthestReach, kSharpCorner,
                            nullptr, 0};
  const auto without = [&](const Curve& curve) {
    const std::vector<Segment> pieces = curve.segments();
    if (std::none_of(pieces.begin(), pieces.end(), is_tight)) return curve;
    std::vector<Vertex> vertices;
    for (const Segment& s : widened(opened_up(curve), demands))
      vertices.push_back({s.a, s.bulge(), s.open});
    return Curve(std::move(vertices), true);
  };
  std::vector<Region> result;
  for (const Region& region : regions) {
    result.push_back({without(region.outer), {}});
    for (const Curve& island : region.islands) result.back().islands.push_back(without(island));
  }
  return result;
}

}  // namespace evenload
