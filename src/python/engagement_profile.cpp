#include "python/engagement_profile.h"

#include <algorithm>
#include <cmath>

#include "cutting/probe.h"

namespace evenload {
namespace {

// mm between points.
constexpr double kSpacing = 0.1;
// mm: what is thinner was cut before, and rounded.
constexpr double kThinnest = 1e-4;

Segment segment_of(const Move& from, const Move& to) {
  if (to.sweep == 0) return Segment::line({from.x, from.y}, {to.x, to.y});
  const Vec2 centre{to.cx, to.cy}, start{from.x, from.y};
  return Segment::arc(centre, distance(start, centre), angle_of(start - centre), to.sweep);
}

}  // namespace

std::vector<ProfilePoint> engagement_profile(const std::vector<Region>& regions,
                                             const Toolpath& path, double tool_diameter,
                                             const std::optional<Hole>& hole) {
  std::vector<ProfilePoint> profile;
  if (path.moves.empty()) return profile;
  double floor = path.moves.front().z;
  Vec2 low{path.moves.front().x, path.moves.front().y}, high = low;
  for (const Move& move : path.moves) {
    floor = std::min(floor, move.z);
    low = {std::min(low.x, move.x), std::min(low.y, move.y)};
    high = {std::max(high.x, move.x), std::max(high.y, move.y)};
  }
  const Vec2 margin{tool_diameter, tool_diameter};
  ClearedGround ground({low - margin, high + margin}, 0.5 * tool_diameter, &regions);
  if (hole) ground.add_disc(hole->centre, 0.5 * hole->diameter);
  Probe probe(ground);
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Move &from = path.moves[i - 1], &to = path.moves[i];
    const Segment segment = segment_of(from, to);
    const double length = segment.length();
    const bool at_floor = to.z <= floor + 1e-6;
    if (length < 1e-9 || !at_floor) continue;
    const bool judged = to.kind == MoveKind::kCut || to.kind == MoveKind::kLink;
    const int n = looks_along(length, kSpacing);
    for (int k = 0; k < n; ++k) {
      const double t = (k + 0.5) / n;
      ProfilePoint point{segment.point(t), 0, to.kind};
      if (judged) point.engagement = probe.engagement(segment, t, kThinnest);
      profile.push_back(point);
    }
    ground.add(segment);
  }
  return profile;
}

}  // namespace evenload
