#include "strategy/tight_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "strategy/move_checks.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// mm, and of the engagement angle: the thickest that may be left, and the longest arc on which the
// tool meets it.
constexpr double kThickest = 0.004;
constexpr double kArcShare = 0.04;
// mm along the path: where the first new arc that is tried begins before the old ones, and by how
// much further each next one does.
constexpr double kFirstReach = 0.002;
constexpr double kReachGrowth = 1.15;
// mm: the furthest. A right angle that is turned at a radius of nothing reaches so far.
constexpr double kFurthestReach = 0.3;
// mm: no rest of a move is shorter; rounded to 0.0001 mm it would be turned by half a degree.
constexpr double kShortestRest = 0.01;
// Of unit vectors along moves that are tangent to each other.
constexpr double kSameDirection = 1e-5;
// Of the reach before: the least behind, and by how much further each next one is that is tried.
constexpr double kLeastShare = 0.1;
constexpr double kShareGrowth = 1.5;
// mm: to which the reach behind is found.
constexpr double kSameReach = 1e-10;

// mm of path between two looks at the engagement.
constexpr double kEngagementSpacing = 0.005;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;
// rad: corners of a wall that turn by less are followed as they are; a pass widens them by next to
// nothing.
constexpr double kSharpCorner = 1;

// What a new arc must fulfil.
struct Demands {
  const Area& centres;    // inside which it stays
  const Area& exact;      // turns along whose border it must not replace
  double widening;        // mm: how far from it the old moves may be
  double least_turn;      // rad: of the turns that are replaced
  ClearedGround* ground;  // before the moves; null where nothing is cut
  double engagement;      // rad, the most that is met
};

bool is_tight(const Segment& move) {
  return move.is_arc() && becomes_corners(move.radius, move.sweep);
}

// A place `reach` mm before the end of the moves [0, n), or after the start of the moves from n on.
struct Cut {
  std::size_t move = 0;
  double t = 0;
};

std::optional<Cut> cut_before(const std::vector<Segment>& moves, std::size_t n, double reach) {
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n && !is_tangent(moves[i], moves[i + 1], kSameDirection)) return std::nullopt;
    const double length = moves[i].length();
    if (reach <= length) return Cut{i, 1 - reach / length};
    reach -= length;
  }
  return std::nullopt;
}

std::optional<Cut> cut_after(const std::vector<Segment>& moves, std::size_t n, double reach) {
  for (std::size_t i = n; i < moves.size(); ++i) {
    if (i > n && !is_tangent(moves[i - 1], moves[i], kSameDirection)) return std::nullopt;
    const double length = moves[i].length();
    if (reach <= length) return Cut{i, reach / length};
    reach -= length;
  }
  return std::nullopt;
}

// What stays of a move is long enough, and no tight turn itself.
bool can_stay(const Segment& move, double from, double to) {
  const double share = to - from;
  return share * move.length() >= kShortestRest &&
         !(move.is_arc() && becomes_corners(move.radius, share * move.sweep));
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
           const Demands& demands)
      : moves_(moves), first_(first), last_(last), demands_(demands) {}

  // The moves with the tight ones replaced; empty where that cannot be.
  std::vector<Segment> widened() {
    if (first_ == 0 || last_ == moves_.size()) return {};
    for (double reach = kFirstReach; reach <= kFurthestReach; reach *= kReachGrowth) {
      const std::optional<Cut> from = cut_before(moves_, first_, reach);
      if (!from) return {};
      if (!can_stay(moves_[from->move], 0, from->t)) continue;
      const std::optional<Cut> to = end_of_arc(*from, reach);
      if (!to || !can_stay(moves_[to->move], to->t, 1)) continue;
      std::vector<Segment> result = with_arc(*from, *to);
      if (!result.empty()) return result;
      if (too_far_) return {};
    }
    return {};
  }

 private:
  // Where an arc that begins at `from` ends tangentially.
  std::optional<Cut> end_of_arc(const Cut& from, double reach) const {
    const auto off = [&](const Cut& to) {
      return imbalance(moves_[from.move], from.t, moves_[to.move], to.t);
    };
    const std::optional<Cut> first = cut_after(moves_, last_, 0);
    if (!first) return std::nullopt;
    const bool falls = off(*first) > 0;
    double low = 0, high = kLeastShare * reach;
    for (;; low = high, high *= kShareGrowth) {
      const std::optional<Cut> to = cut_after(moves_, last_, high);
      if (!to || high > kFurthestReach) return std::nullopt;
      if ((off(*to) > 0) != falls) break;
    }
    while (high - low > kSameReach) {
      const double middle = 0.5 * (low + high);
      ((off(*cut_after(moves_, last_, middle)) > 0) == falls ? low : high) = middle;
    }
    return cut_after(moves_, last_, high);
  }

  std::vector<Segment> with_arc(const Cut& from, const Cut& to) {
    const Segment& before = moves_[from.move];
    const Segment& after = moves_[to.move];
    const Vec2 a = before.point(from.t), b = after.point(to.t), along = before.tangent(from.t);
    const double half = std::atan2(cross(along, b - a), dot(along, b - a));
    if (std::abs(half) >= 0.5 * kPi) return {};
    const Segment arc = Segment::from_bulge(a, b, std::tan(half / 2));
    if (is_tight(arc) || norm(arc.tangent(1) - after.tangent(to.t)) > kSameDirection) return {};
    too_far_ = !is_near(arc, from, to);
    if (too_far_ || !is_inside(arc, demands_.centres, kOnBorder)) return {};
    std::vector<Segment> result(moves_.begin(),
                                moves_.begin() + static_cast<std::ptrdiff_t>(from.move));
    result.push_back(before.part(0, from.t));
    too_far_ = meets_too_much(result, arc);
    if (too_far_) return {};
    result.push_back(arc);
    result.push_back(after.part(to.t, 1));
    result.insert(result.end(), moves_.begin() + static_cast<std::ptrdiff_t>(to.move) + 1,
                  moves_.end());
    return result;
  }

  // No look along what is replaced is further than what is allowed from the arc.
  bool is_near(const Segment& arc, const Cut& from, const Cut& to) const {
    for (std::size_t k = from.move; k <= to.move; ++k)
      for (int i = 0; i <= kMoveLooks; ++i) {
        const double t0 = k == from.move ? from.t : 0, t1 = k == to.move ? to.t : 1;
        if (arc.distance_to(moves_[k].point(t0 + (t1 - t0) * i / kMoveLooks)) > demands_.widening)
          return false;
      }
    return true;
  }

  // True where the mean over kMeanLength mm of the arc is above the limit.
  bool meets_too_much(const std::vector<Segment>& before, const Segment& arc) const {
    if (!demands_.ground) return false;
    for (const Segment& move : before) demands_.ground->add(move);
    const double length = arc.length(), window = std::min(kMeanLength, length);
    const int n = static_cast<int>(std::ceil(length / kEngagementSpacing));
    const int in_window = std::max(1, static_cast<int>(std::lround(n * window / length)));
    std::vector<double> met;
    std::vector<AngularInterval> pieces;
    double sum = 0, most = 0;
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, right = angle_of(arc.tangent(t)) - kPi / 2;
      demands_.ground->uncovered(arc.point(t), right, right + kPi, pieces, kThin,
                                 demands_.ground->size());
      met.push_back(0);
      for (const AngularInterval& piece : pieces) met.back() += piece.width();
      sum += met.back();
      if (i >= in_window) sum -= met[static_cast<std::size_t>(i - in_window)];
      most = std::max(most, sum / in_window);
    }
    for (std::size_t i = 0; i < before.size(); ++i) demands_.ground->remove_last();
    return most > demands_.engagement + kSmoothOverload;
  }

  const std::vector<Segment>& moves_;
  std::size_t first_, last_;  // of the tight moves, last excluded
  const Demands& demands_;
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

bool may_give_way(const Segment& move, const Demands& demands) {
  return move.is_arc() && std::abs(move.sweep) >= demands.least_turn &&
         !follows_border(move, demands.exact);
}

// The moves with those of [first, last) replaced, or else those and an arc beside them: no one arc
// leads from an arc on past a wider one to a straight.
std::vector<Segment> with_wider(const std::vector<Segment>& moves, std::size_t first,
                                std::size_t last, const Demands& demands) {
  std::vector<Segment> wider = Widening(moves, first, last, demands).widened();
  if (wider.empty() && first > 0 && may_give_way(moves[first - 1], demands) &&
      is_tangent(moves[first - 1], moves[first], kSameDirection))
    wider = Widening(moves, first - 1, last, demands).widened();
  if (wider.empty() && last < moves.size() && may_give_way(moves[last], demands) &&
      is_tangent(moves[last - 1], moves[last], kSameDirection))
    wider = Widening(moves, first, last + 1, demands).widened();
  return wider;
}

std::vector<Segment> widened(const std::vector<Segment>& moves, const Demands& demands) {
  std::vector<Segment> result = moves;
  for (std::size_t i = 0; i < result.size();) {
    std::size_t end = i;
    while (end < result.size() && is_tight(result[end]) && may_give_way(result[end], demands) &&
           (end == i || is_tangent(result[end - 1], result[end], kSameDirection)))
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
  const double arc = kArcShare * engagement;
  return std::min({tolerance, kThickest, 0.5 * tool_radius * arc * arc});
}

std::vector<Segment> without_tight_turns(const std::vector<Segment>& moves, const Area& centres,
                                         ClearedGround& ground, double engagement,
                                         double widening) {
  return widened(moves, {centres, centres, widening, 0, &ground, engagement});
}

std::vector<Region> without_tight_corners(const std::vector<Region>& regions, const Area& exact) {
  const Area inside(regions);
  const Demands demands{inside, exact, kFurthestReach, kSharpCorner, nullptr, 0};
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
