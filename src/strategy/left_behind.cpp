#include "strategy/left_behind.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/box_tree.h"
#include "toolpath/small_arc.h"

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

// The centres of a way's arcs, from left to right: spirals have ten thousand.
class Centres {
 public:
  explicit Centres(const std::vector<Segment>& moves) {
    for (const Segment& move : moves)
      if (move.is_arc()) centres_.push_back(move.centre);
    std::sort(centres_.begin(), centres_.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  }

  bool holds(Vec2 centre) const {
    auto at = std::lower_bound(centres_.begin(), centres_.end(), centre.x - kSameCentre,
                               [](Vec2 p, double x) { return p.x < x; });
    for (; at != centres_.end() && at->x <= centre.x + kSameCentre; ++at)
      if (distance(*at, centre) < kSameCentre) return true;
    return false;
  }

 private:
  std::vector<Vec2> centres_;
};

// mm: by how much less the tool reaches along the lines in place of a tight arc, in the direction
// of its point at `share` of the arc.
double lost_by_lines(const Segment& turn, double share) {
  if (!is_tight(turn)) return 0;
  const int lines = lines_in_place_of(turn.radius, turn.sweep);
  const double from_corner = std::abs(share * lines - std::nearbyint(share * lines)) / lines;
  return turn.radius * (1 - std::cos(from_corner * turn.sweep));
}

// The lines that posts write in place of tight arcs, and the other moves as they are.
std::vector<Segment> as_posted(const std::vector<Segment>& moves) {
  std::vector<Segment> result;
  for (const Segment& move : moves) {
    if (!is_tight(move)) {
      result.push_back(move);
      continue;
    }
    const int lines = lines_in_place_of(move.radius, move.sweep);
    for (int i = 0; i < lines; ++i)
      result.push_back(
          Segment::line(move.point(static_cast<double>(i) / lines), move.point((i + 1.0) / lines)));
  }
  return result;
}

// Where the tool reaches on a way.
class Reach {
 public:
  Reach(const std::vector<Segment>& moves, double tool_radius)
      : moves_(moves), deep_(tool_radius - kThinnest) {
    for (const Segment& move : moves) boxes_.push_back(grown(move.bounds(), deep_));
  }

  bool holds(Vec2 p) const {
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      const Bounds& box = boxes_[i];
      const bool is_near =
          p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y;
      if (is_near && moves_[i].distance_to(p) < deep_) return true;
    }
    return false;
  }

 private:
  const std::vector<Segment>& moves_;
  double deep_;  // mm
  std::vector<Bounds> boxes_;
};

}  // namespace

void LeftBehind::expect(const std::vector<Segment>& planned, const std::vector<Segment>& posted,
                        const ClearedGround& ground) {
  ahead_.clear();
  const Reach reach(planned, radius_);
  const Centres centres(planned);
  for (const Segment& turn : posted) {
    if (!turn.is_arc()) continue;
    if (!is_tight(turn) && centres.holds(turn.centre)) continue;
    Sliver sliver;
    const int n = static_cast<int>(std::ceil(std::abs(turn.sweep) / kSpacing));
    for (int i = 0; i <= n; ++i) {
      const double share = static_cast<double>(i) / n;
      const Vec2 at = turn.point(share);
      const double reached = radius_ - lost_by_lines(turn, share);  // mm beyond the arc
      const Vec2 point = at + reached / turn.radius * (at - turn.centre);
      if (reach.holds(point) && !ground.is_cleared_point(point)) sliver.push_back(point);
    }
    if (sliver.size() >= kContact) ahead_.push_back(std::move(sliver));
  }
}

void LeftBehind::cut(const std::vector<Segment>& moves) {
  const std::vector<Segment> lines = as_posted(moves);
  const Reach reach(lines, radius_);
  for (Sliver& sliver : slivers_)
    std::erase_if(sliver, [&](Vec2 point) { return reach.holds(point); });
  std::erase_if(slivers_, [](const Sliver& sliver) { return sliver.size() < kContact; });
  std::move(ahead_.begin(), ahead_.end(), std::back_inserter(slivers_));
  ahead_.clear();
}

bool LeftBehind::is_met_along(const std::vector<Segment>& moves) const {
  const Reach reach(moves, radius_);
  return std::any_of(slivers_.begin(), slivers_.end(), [&](const Sliver& sliver) {
    const auto met =
        std::count_if(sliver.begin(), sliver.end(), [&](Vec2 point) { return reach.holds(point); });
    return static_cast<std::size_t>(met) >= kContact;
  });
}

}  // namespace evenload
