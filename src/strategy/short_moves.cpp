#include "strategy/short_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/bi_arc.h"
#include "strategy/move_checks.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// Of unit vectors along moves that are tangent to each other: posts turn moves of any length in use
// by more, and the shorter of two by what kPosted mm are of its length, up to a quarter of a
// degree.
constexpr double kSameDirection = 2e-4;
constexpr double kPosted = 5e-5;
constexpr double kMostPosted = 5e-3;
// mm: what kPosted mm turn by a degree and more, at both ends.
constexpr double kTurnedByPosts = 4e-3;
// The moves of a bi-arc are so many times as long as the shorter of those that it replaces, or
// kShortest.
constexpr double kWorthwhile = 4;
// The same along the border, where they stay arcs in posted programs and the shorter one did not.
constexpr double kWider = 1.5;
// Of the lengths to the joint of a bi-arc along both ends: what is tried next, and the least.
constexpr double kNextShare = 0.4, kLeastShare = 0.02;
// rad: of either arc of a bi-arc.
constexpr double kMostTurn = kPi;
// rad: a way off the border and back that turns by less, all in all, is none.
constexpr double kDetourTurn = 0.01;

// True when every look along `way` is within `smoothing` mm of one of `others`.
bool is_near(const std::vector<Segment>& way, const std::vector<Segment>& others,
             double smoothing) {
  for (const Segment& move : way)
    for (int i = 1; i < kMoveLooks; ++i) {
      const Vec2 p = move.point(static_cast<double>(i) / kMoveLooks);
      if (std::none_of(others.begin(), others.end(),
                       [&](const Segment& s) { return s.distance_to(p) <= smoothing; }))
        return false;
    }
  return true;
}

// What can come in place of `a` and `b`; empty where nothing can. Walls are followed, but for what
// posts cannot tell from them where a move would be turned.
std::vector<Segment> instead_of(const Segment& a, const Segment& b, const Area& centres,
                                const Area& walls, double smoothing) {
  const double posted =
      std::clamp(kPosted / std::min(a.length(), b.length()), kSameDirection, kMostPosted);
  if (!is_tangent(a, b, posted)) return {};
  const bool on_wall = follows_border(a, walls) || follows_border(b, walls);
  const Segment& shorter = a.length() < b.length() ? a : b;
  if (on_wall && shorter.length() > kTurnedByPosts && !is_tight(shorter)) return {};
  const double beyond = on_wall ? kPosted : kOnBorder;
  if (on_wall) smoothing = std::min(smoothing, kPosted);
  // Where the border is no wall.
  const bool on_border = !on_wall && (follows_border(a, centres) || follows_border(b, centres));
  const auto may_be_cut = [&](const Segment& move) {
    return on_border ? is_inside(move, centres, smoothing) && is_inside(move, walls, beyond)
                     : is_inside(move, centres, beyond);
  };
  const PlanePoint from{a.a, a.tangent(0)}, to{b.b, b.tangent(1)};
  const auto serves = [&](const std::vector<Segment>& way) {
    return is_near(way, {a, b}, smoothing) && is_near({a, b}, way, smoothing) &&
           std::all_of(way.begin(), way.end(), may_be_cut);
  };
  const Vec2 chord = to.p - from.p;
  const double half_turn = std::atan2(cross(from.direction, chord), dot(from.direction, chord));
  if (std::abs(2 * half_turn) <= kMostTurn) {
    const Segment one = Segment::from_bulge(from.p, to.p, std::tan(half_turn / 2));
    if (norm(one.tangent(1) - to.direction) < posted && serves({one})) return {one};
  }
  const auto of_two = [&](double ratio, bool as_arcs) -> std::vector<Segment> {
    const std::optional<BiArc> two = bi_arc(from, to, kMostTurn, ratio);
    if (!two) return {};
    const bool is_wide = !is_tight(two->first) && !is_tight(two->second);
    if (as_arcs && !is_wide) return {};
    const bool is_wider = on_wall && is_tight(shorter) && is_wide;
    const double shortest =
        std::min(kShortest, (is_wider ? kWider : kWorthwhile) * shorter.length());
    if (std::min(two->first.length(), two->second.length()) < shortest) return {};
    const std::vector<Segment> way{two->first, two->second};
    return serves(way) ? way : std::vector<Segment>{};
  };
  std::vector<Segment> way = of_two(1, false);
  // A bi-arc whose arc on the side of the shorter move is the shorter one is nearer to both.
  if (shorter.length() < kTurnedByPosts)
    for (double share = kNextShare; way.empty() && share > kLeastShare; share *= kNextShare)
      way = of_two(&shorter == &a ? share : 1 / share, true);
  return way;
}

// Two moves along one line, or arcs of one circle, with what lies between them.
std::optional<Segment> bridged(const Segment& a, const Segment& b) {
  if (a.is_arc() != b.is_arc()) return std::nullopt;
  if (!a.is_arc()) {
    const Vec2 along = a.tangent(0);
    const bool is_one = std::abs(cross(along, b.a - a.a)) < kOnBorder &&
                        std::abs(cross(along, b.b - a.a)) < kOnBorder;
    if (!is_one || dot(along, b.a - a.b) < 0 || dot(along, b.tangent(0)) < 0) return std::nullopt;
    return Segment::line(a.a, b.b);
  }
  const double gap = wrap_signed(b.start_angle - a.start_angle - a.sweep);
  if (distance(a.centre, b.centre) > kOnBorder || std::abs(a.radius - b.radius) > kOnBorder ||
      a.sweep * b.sweep <= 0 || a.sweep * gap < 0)
    return std::nullopt;
  return Segment::arc(a.centre, a.radius, a.start_angle, a.sweep + gap + b.sweep);
}

// Without tiny ways off the border and back to it.
std::vector<Segment> without_detours(const std::vector<Segment>& moves, const Area& centres) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    result.push_back(moves[i]);
    const bool is_short_next = i + 1 < moves.size() && moves[i + 1].length() < kShortest;
    if (!is_short_next || !follows_border(moves[i], centres)) continue;
    double length = 0, turn = 0;
    for (std::size_t j = i + 1; j < moves.size() && length < kShortest && turn < kDetourTurn; ++j) {
      const std::optional<Segment> wall = j > i + 1 && follows_border(moves[j], centres)
                                              ? bridged(result.back(), moves[j])
                                              : std::nullopt;
      if (wall) {
        result.back() = *wall;
        i = j;
        length = turn = 0;
        continue;
      }
      length += moves[j].length();
      turn += std::abs(moves[j].sweep);
    }
  }
  return result;
}

}  // namespace

std::vector<Segment> without_short_moves(const std::vector<Segment>& moves, const Area& centres,
                                         const Area& walls, double smoothing) {
  const std::vector<Segment> whole = without_detours(moves, centres);
  std::vector<Segment> result;                              // the moves so far
  std::vector<Segment> rest(whole.rbegin(), whole.rend());  // the moves to come, the last first
  const auto join_before = [&](const Segment& move) {
    if (result.empty()) return false;
    const std::vector<Segment> way = instead_of(result.back(), move, centres, walls, smoothing);
    if (way.empty()) return false;
    result.pop_back();
    result.insert(result.end(), way.begin(), way.end());
    return true;
  };
  const auto join_after = [&](const Segment& move) {
    if (rest.empty()) return false;
    const std::vector<Segment> way = instead_of(move, rest.back(), centres, walls, smoothing);
    if (way.empty()) return false;
    rest.pop_back();
    rest.insert(rest.end(), way.rbegin(), way.rend());
    return true;
  };
  while (!rest.empty()) {
    const Segment move = rest.back();
    rest.pop_back();
    if (move.length() < kShortest) {
      const bool before_is_longer =
          !result.empty() && (rest.empty() || result.back().length() >= rest.back().length());
      if (before_is_longer ? join_before(move) || join_after(move)
                           : join_after(move) || join_before(move))
        continue;
    }
    result.push_back(move);
  }
  return result;
}

}  // namespace evenload
