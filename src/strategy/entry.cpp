#include "strategy/entry.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evenload {
namespace {

// A helix narrower than this share of the tool's radius rubs; a ramp takes its place.
constexpr double kNarrowestHelix = 0.02;
// A helix stays this share of its room away from the walls.
constexpr double kHelixRoom = 0.98;
// Share of the tool's radius: a wider helix would leave a post in its middle.
constexpr double kWidestHelix = 0.98;
// Directions in which room for a ramp is looked for at first; the best is then refined.
constexpr int kRampDirections = 180;
// rad: to which the ramp's direction is refined.
constexpr double kRampAngle = 1e-4;
// mm: a ramp shorter than this is a plunge.
constexpr double kShortestRamp = 1e-3;
// Share of the tool's radius from the stock at which the tool comes down outside.
constexpr double kBeside = 1.02;

// mm from `from` to the border of `centres`, `limit` at most.
double free_length(const Area& centres, Vec2 from, Vec2 direction, double limit) {
  double length = 0;
  while (length < limit) {
    const double inside = centres.signed_distance(from + length * direction);
    if (inside < 1e-5) break;
    length += inside;
  }
  return std::min(length, limit);
}

// The longest free line from `from`, as a vector. Between walls hardly wider than the tool it runs
// along them, which no fixed set of directions would find.
Vec2 longest_line(const Area& centres, Vec2 from, double limit) {
  double best = 0, longest = -1;
  const auto look = [&](double angle) {
    const double length = free_length(centres, from, unit(angle), limit);
    if (length <= longest + 1e-9) return;
    longest = length;
    best = angle;
  };
  for (int i = 0; i < kRampDirections; ++i) look(2 * kPi * i / kRampDirections);
  const BoundaryIndex::Hit hit = centres.nearest(from);
  const double along = angle_of(centres.segment_at(hit).tangent(hit.t));
  for (int quarter = 0; quarter < 4; ++quarter) look(along + quarter * kPi / 2);  // or an end wall
  for (double step = kPi / kRampDirections; step > kRampAngle; step /= 2) {
    const double middle = best;
    look(middle - step);
    look(middle + step);
  }
  return longest * unit(best);
}

}  // namespace

double widest_helix(const ClearingParams& params) {
  return kWidestHelix * 0.5 * params.tool_diameter;
}

std::optional<std::string> helix_note(const std::vector<PlanarRun>& runs,
                                      const ClearingParams& params) {
  const double widest = 2 * widest_helix(params);
  const auto is_widest = [&](const PlanarRun& run) {
    return run.descent.kind == DescentKind::kHelix && 2 * run.descent.radius > widest - 1e-9;
  };
  if (params.helix_diameter <= widest || std::none_of(runs.begin(), runs.end(), is_widest))
    return std::nullopt;
  std::ostringstream note;
  note << "HelixDiameter " << params.helix_diameter << " mm was taken as " << widest
       << " mm: a wider helix would leave a post in its middle.";
  return note.str();
}

double helix_radius(const ClearingParams& params, const Circle& room) {
  return std::min({0.5 * params.helix_diameter, kHelixRoom * room.radius, widest_helix(params)});
}

std::optional<Entry> descend_within(const Area& centres, const Circle& room,
                                    const ClearingParams& params) {
  Entry entry;
  const bool helix_fits = kHelixRoom * room.radius >= kNarrowestHelix * 0.5 * params.tool_diameter;
  if (helix_fits && params.entry != EntryKind::kRamp) {
    entry.descent.kind = DescentKind::kHelix;
    entry.descent.centre = room.centre;
    entry.descent.radius = helix_radius(params, room);
    entry.descent.at = room.centre + Vec2{entry.descent.radius, 0};
    entry.start = {entry.descent.at, kPi / 2};
    return entry;
  }
  // The ramp begins and ends where there is most room, so that the tool can turn there.
  const Vec2 line = longest_line(centres, room.centre, kLongestRamp * params.tool_diameter);
  if (norm(line) < kShortestRamp) return std::nullopt;
  entry.descent.kind = DescentKind::kRamp;
  entry.descent.at = room.centre;
  entry.descent.ramp_end = room.centre + line;
  entry.start = {entry.descent.at, angle_of(line)};
  return entry;
}

std::optional<Pose> start_outside(const Area& centres, const std::vector<Region>& material,
                                  const ClearedGround& ground) {
  const double beside = kBeside * ground.tool_radius();
  std::optional<Segment> best;
  for (const Region& region : material)
    for (const Curve& curve : region.curves())
      for (const Segment& edge : curve.segments()) {
        if (!edge.open) continue;
        const Vec2 p = edge.point(0.5) - beside * left_normal(edge.tangent(0.5));
        if (centres.signed_distance(p) < 0 || !ground.is_clear(p)) continue;
        if (!best || edge.length() > best->length() + 1e-9) best = edge;
      }
  if (!best) return std::nullopt;
  const Vec2 inwards = left_normal(best->tangent(0.5));
  return Pose{best->point(0.5) - beside * inwards, angle_of(inwards) + kPi / 2};
}

}  // namespace evenload
