#include "strategy/places/passage_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/medial_axis.h"
#include "strategy/places/area.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// A branch no longer than this times the distance to the walls where it begins leads into a corner
// of 60 degrees or more.
constexpr double kCornerBranch = 2.02;

class AxisBuilder {
 public:
  AxisBuilder(const Region& centres, const NarrowPlaces& places, double spacing)
      : walls_({centres}),
        rooms_(places.rooms),
        passages_(places.passages),
        axes_(places.passages.size()),
        spacing_(spacing) {}

  std::vector<PassageAxis> build(const MedialAxis& axis) {
    std::vector<std::size_t> nodes;  // in their passage's axis
    for (const MedialAxis::Node& node : axis.nodes) {
      const std::size_t home = home_of(node.p);
      nodes.push_back(home == kNoIndex ? kNoIndex : add(home, node.p));
    }
    for (const MedialAxis::Edge& edge : axis.edges) follow(edge, nodes);
    for (PassageAxis& a : axes_) a = without_corner_branches(a);
    return std::move(axes_);
  }

 private:
  // The passage that holds a point of the axis; kNoIndex in a room.
  std::size_t home_of(Vec2 p) const {
    if (!rooms_.empty() && rooms_.signed_distance(p) >= -kSame) return kNoIndex;
    if (passages_.size() == 1) return 0;
    std::size_t best = kNoIndex;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < passages_.size(); ++i) {
      if (passages_[i].centres.contains(p)) return i;
      for (const std::vector<PassageBorder>& loop : passages_[i].loops)
        for (const PassageBorder& piece : loop) {
          const double d = piece.segment.distance_to(p);
          if (d < nearest) {
            nearest = d;
            best = i;
          }
        }
    }
    return nearest < kSame ? best : kNoIndex;
  }

  std::size_t add(std::size_t home, Vec2 p, bool is_mouth = false) {
    axes_[home].points.push_back({p, walls_.nearest(p).distance, is_mouth, {}});
    return axes_[home].points.size() - 1;
  }

  void join(std::size_t home, std::size_t a, std::size_t b) {
    axes_[home].points[a].next.push_back(b);
    axes_[home].points[b].next.push_back(a);
  }

  // Where the line from `outside`, in a passage, enters a room.
  Vec2 mouth_between(Vec2 outside, Vec2 inside) const {
    while (distance(outside, inside) > kSame) {
      const Vec2 middle = 0.5 * (outside + inside);
      (rooms_.signed_distance(middle) >= -kSame ? inside : outside) = middle;
    }
    return inside;
  }

  void follow(const MedialAxis::Edge& edge, const std::vector<std::size_t>& nodes) {
    Vec2 before = edge.points.front();
    std::size_t home = home_of(before), at = nodes[edge.from];
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Vec2 from = edge.points[i - 1], to = edge.points[i];
      const int n = std::max(1, static_cast<int>(std::ceil(distance(from, to) / spacing_)));
      for (int k = 1; k <= n; ++k) {
        const bool is_last = i + 1 == edge.points.size() && k == n;
        const Vec2 p = k == n ? to : from + (static_cast<double>(k) / n) * (to - from);
        const std::size_t next_home = home_of(p);
        std::size_t next = kNoIndex;
        if (next_home != kNoIndex) next = is_last ? nodes[edge.to] : add(next_home, p);
        if (home != kNoIndex && home == next_home) {
          join(home, at, next);
        } else {
          if (home != kNoIndex) join(home, at, add(home, mouth_between(before, p), true));
          if (next_home != kNoIndex)
            join(next_home, next, add(next_home, mouth_between(p, before), true));
        }
        before = p;
        home = next_home;
        at = next;
      }
    }
  }

  // The points from a free end to just before the next fork, and their length up to the fork;
  // empty where there is no fork.
  static std::vector<std::size_t> branch(const PassageAxis& axis, std::size_t end, double* length,
                                         std::size_t* fork) {
    std::vector<std::size_t> points{end};
    *length = 0;
    std::size_t before = kNoIndex, at = end;
    for (;;) {
      std::size_t next = kNoIndex;
      for (const std::size_t candidate : axis.points[at].next)
        if (candidate != before) next = candidate;
      if (next == kNoIndex) return {};
      *length += distance(axis.points[at].p, axis.points[next].p);
      if (axis.points[next].next.size() > 2) {
        *fork = next;
        return points;
      }
      before = at;
      at = next;
      points.push_back(at);
    }
  }

  static PassageAxis without_corner_branches(const PassageAxis& axis) {
    std::vector<char> gone(axis.points.size(), 0);
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      if (axis.points[i].next.size() != 1 || axis.points[i].is_mouth) continue;
      double length = 0;
      std::size_t fork = 0;
      const std::vector<std::size_t> points = branch(axis, i, &length, &fork);
      if (points.empty() || length > kCornerBranch * axis.points[fork].radius) continue;
      for (const std::size_t k : points) gone[k] = 1;
    }
    PassageAxis kept;
    std::vector<std::size_t> number(axis.points.size(), kNoIndex);
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      if (gone[i]) continue;
      number[i] = kept.points.size();
      kept.points.push_back(axis.points[i]);
    }
    for (PassageAxis::Point& point : kept.points) {
      std::vector<std::size_t> next;
      for (const std::size_t k : point.next)
        if (!gone[k]) next.push_back(number[k]);
      point.next = std::move(next);
    }
    return kept;
  }

  Area walls_, rooms_;
  const std::vector<Passage>& passages_;
  std::vector<PassageAxis> axes_;
  double spacing_;
};

}  // namespace

double PassageAxis::narrowest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& point : points)
    if (!point.is_mouth) least = std::min(least, 2 * point.radius);
  return points.empty() ? 0 : least;
}

double PassageAxis::length() const {
  double twice = 0;
  for (const Point& point : points)
    for (const std::size_t next : point.next) twice += distance(point.p, points[next].p);
  return 0.5 * twice;
}

std::vector<PassageAxis> passage_axes(const Region& centres, const NarrowPlaces& places,
                                      double spacing) {
  if (places.passages.empty()) return {};
  return AxisBuilder(centres, places, spacing).build(medial_axis(centres, kAxisTolerance));
}

}  // namespace evenload
