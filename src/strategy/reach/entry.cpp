#include "strategy/reach/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "strategy/reach/entry_feeds.h"
#include "support/tolerances.h"
#include "toolpath/helix.h"
#include "toolpath/ramp.h"

namespace evenload {
namespace {

// A helix narrower than this share of the tool's radius rubs; a ramp takes its place.
constexpr double kNarrowestHelix = 0.02;
// A room whose border is no longer than this share of the tool's radius, or twice as long where the
// room is narrow, is cleared by going round it. Passes behind a helix there would turn in pieces of
// hundredths of a mm, which are posted with corners.
constexpr double kTinyBorder = 1;
constexpr double kNarrowRoom = 0.05;  // share of the tool's radius: of the largest circle in it
// Times the circle in it: a room with a shorter border is round, and a helix fills it.
constexpr double kRoundBorder = 1.15;
// A helix takes this share of its room; and in narrow rooms, where it fills it.
constexpr double kHelixRoom = 0.98;
// Share of a helix's radius that it keeps from the walls where it is stretched; and the share
// between two looks for them, which no corner of a wall that is as far away at both can use up.
constexpr double kStretchedRoom = 0.005;
constexpr double kEntryLook = 0.19;
// mm
constexpr double kAtBorder = 1e-5;
// Share of the tool's radius: a wider helix would leave a post in its middle.
constexpr double kWidestHelix = 0.98;
// Directions all round in which room is looked for at first; the best is then refined.
constexpr int kRampDirections = 180;
// rad: to which it is refined.
constexpr double kRampAngle = 1e-4;
// Share of a helix's radius: it is not stretched by less.
constexpr double kShortestStretch = 0.1;
// mm: to which the stretch of a helix is found.
constexpr double kStretch = 1e-3;
// mm: a ramp shorter than this is a plunge.
constexpr double kShortestRamp = 1e-3;
// mm: the longest line of a ramp that is joined to others for being too short to descend.
constexpr double kLongestDrop = 0.01;
// Share of the tool's radius: between points at which is looked whether something stands. A share
// of the area is found to half a percent.
constexpr double kStandingLook = 1.0 / 40;
// Share of the tool's radius from the stock at which the tool comes down outside.
constexpr double kBeside = 1.02;
constexpr int kHalvedEdge = 12;  // times: to a hundredth of a millimetre of 40 mm

// mm from `from` to where the border of `centres` is `room` mm away, `limit` at most.
double free_length(const Area& centres, Vec2 from, Vec2 direction, double limit, double room = 0) {
  const auto inside = [&](double at) {
    return centres.signed_distance(from + at * direction) - room;
  };
  double known = 0, next = 0, free = inside(0);
  while (free >= kAtBorder && next < limit) {
    known = next + free;
    next = std::min(limit, next + std::max(free, kEntryLook * room));
    free = inside(next);
  }
  if (free >= kAtBorder) return limit;
  while (next - known > kAtBorder) {
    const double middle = 0.5 * (known + next);
    (inside(middle) < kAtBorder ? next : known) = middle;
  }
  return std::min(known, limit);
}

// Along the nearest wall, which runs beside the longest line between walls close together, and
// across it.
std::array<double, 4> directions_of(const Area& centres, Vec2 from) {
  const BoundaryIndex::Hit hit = centres.nearest(from);
  const double along = angle_of(centres.segment_at(hit).tangent(hit.t));
  return {along, along + kPi / 2, along + kPi, along + 3 * kPi / 2};
}

// Where `length` is greatest, in `turn` rad from 0 on. Between walls hardly wider than the room
// that is asked for, lines run along them, which no fixed set of directions would find.
template <typename Length>
double direction_of_longest(const Area& centres, Vec2 from, double turn, const Length& length) {
  double best = 0, longest = -1;
  const auto look = [&](double angle) {
    const double found = length(angle);
    if (found <= longest + kRounding) return;
    longest = found;
    best = angle;
  };
  const int n = static_cast<int>(std::lround(turn / (2 * kPi) * kRampDirections));
  for (int i = 0; i < n; ++i) look(turn * i / n);
  for (const double angle : directions_of(centres, from)) look(angle);  // or an end wall
  for (double step = kPi / kRampDirections; step > kRampAngle; step /= 2) {
    const double middle = best;
    look(middle - step);
    look(middle + step);
  }
  return best;
}

// The longest free line from `from`, as a vector.
Vec2 longest_line(const Area& centres, Vec2 from, double limit) {
  const auto length = [&](double angle) { return free_length(centres, from, unit(angle), limit); };
  const double best = direction_of_longest(centres, from, 2 * kPi, length);
  return length(best) * unit(best);
}

// A ramp along the border of `centres`, where that is no longer than `longest` mm: no room is so
// narrow, but for its corners, and nothing is left of it. False where it is longer.
bool ramp_round_border(const Area& centres, double longest, const ClearingParams& params,
                       Entry& entry) {
  if (centres.curves().size() != 1) return false;
  const Curve& curve = centres.curves().front();
  if (curve.length() > longest) return false;
  const Descent ramp = ramp_along(curve, params);
  if (ramp_length(ramp) < 2 * kShortestRamp) return false;
  entry = {ramp, {ramp.at, angle_of(ramp.ramp_by.front() - ramp.at)}};
  return true;
}

// Whether all points between two of `points` lie within kRampChord of the line from one to the
// other.
bool is_straight(const std::vector<Vec2>& points, std::size_t from, std::size_t to) {
  const Segment line = Segment::line(points[from], points[to]);
  for (std::size_t i = from + 1; i < to; ++i)
    if (distance(line.point(line.nearest(points[i])), points[i]) > kRampChord) return false;
  return true;
}

// mm of the way down a helix.
double slope_of(const ClearingParams& params) {
  const double depth = params.top - params.levels.front();
  return (depth + kAboveMaterial) / std::tan(params.helix_angle);
}

// mm: the greatest stretch up to `longest` with which the way down is a whole number of half turns,
// none of them flatter than it may be; 0 where that is not worth it.
double stretch_of_half_turns(double helix_radius, double longest, const ClearingParams& params) {
  const double slope = slope_of(params), circle = kPi * helix_radius;
  const double half_turns = std::ceil(slope / (circle + longest) - kSame);
  const double stretch = slope / half_turns - circle;
  return stretch < kShortestStretch * helix_radius ? 0 : stretch;
}

// mm: the stretch with which a helix removes as much in its time as a cut does, or the longest.
double sought_stretch(double helix_radius, const ClearingParams& params) {
  const double r = 0.5 * params.tool_diameter;
  const double depth = params.top - params.levels.front();
  const double slope = slope_of(params);
  const double rate = entry_feeds(params).rate;
  Descent helix;
  helix.radius = helix_radius;
  // mm^2: by how much less it clears than a cut does in the same time.
  const auto lacks = [&](double stretch) {
    helix.stretch = {0.5 * stretch, 0};
    const double time = slope / params.plunge_feed + duration(level_turn(helix, depth, params));
    return rate * time - cleared_area(helix, r);
  };
  const double longest =
      std::max(0.0, (kMostCleared * 4 * kPi * r * r - kPi * std::pow(helix_radius + r, 2)) /
                        (2 * (helix_radius + r)));
  if (lacks(longest) > 0) return longest;
  if (lacks(0) <= 0) return 0;
  double too_short = 0, enough = longest;
  while (enough - too_short > kStretch) {
    const double middle = 0.5 * (too_short + enough);
    (lacks(middle) > 0 ? too_short : enough) = middle;
  }
  return enough;
}

}  // namespace

Descent ramp_along(const Curve& border, const ClearingParams& params) {
  const double shortest = std::min(kLongestDrop, kLeastDescent / std::tan(params.helix_angle));
  std::vector<Vec2> points = border.flattened(kRampChord);
  points.push_back(points.front());
  Descent ramp;
  ramp.kind = DescentKind::kRamp;
  ramp.at = points.front();
  std::size_t last = 0;  // of those that stay
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const bool is_short =
        std::min(distance(points[last], points[i]), distance(points[i], points[i + 1])) < shortest;
    if (is_short && is_straight(points, last, i + 1)) continue;
    ramp.ramp_by.push_back(points[i]);
    last = i;
  }
  return ramp;
}

double widest_helix(const ClearingParams& params) {
  return kWidestHelix * 0.5 * params.tool_diameter;
}

std::optional<Finding> narrowed_helix(const std::vector<PlanarRun>& runs,
                                      const ClearingParams& params) {
  const double widest = 2 * widest_helix(params);
  const auto is_widest = [&](const PlanarRun& run) {
    return run.descent.kind == DescentKind::kHelix && 2 * run.descent.radius > widest - 1e-9;
  };
  if (params.helix_diameter <= widest || std::none_of(runs.begin(), runs.end(), is_widest))
    return std::nullopt;
  return Finding{FindingCode::kHelixNarrowed, {}, {params.helix_diameter, widest}};
}

double helix_radius(const ClearingParams& params, const Circle& room) {
  return std::min({0.5 * params.helix_diameter, kHelixRoom * room.radius, widest_helix(params)});
}

std::optional<Entry> descend_within(const Area& centres, const Circle& room,
                                    const ClearingParams& params) {
  Entry entry;
  const double r = 0.5 * params.tool_diameter;
  const double tiny = (room.radius < kNarrowRoom * r ? 2 : 1) * kTinyBorder * r;
  const bool helix_fits = kHelixRoom * room.radius >= kNarrowestHelix * r;
  const bool is_round = helix_fits && !centres.empty() &&
                        centres.curves().front().length() < kRoundBorder * 2 * kPi * room.radius;
  if (params.entry != EntryKind::kHelix && !is_round &&
      ramp_round_border(centres, tiny, params, entry))
    return entry;
  if (helix_fits && params.entry != EntryKind::kRamp) {
    entry.descent.kind = DescentKind::kHelix;
    entry.descent.centre = room.centre;
    entry.descent.radius = helix_radius(params, room);
    entry.descent.at = room.centre + Vec2{entry.descent.radius, 0};
    entry.start = {entry.descent.at, kPi / 2};
    return entry;
  }
  // The longest ramp to and fro is as long as such a border may be.
  const double longest = kLongestRamp * params.tool_diameter;
  if (!helix_fits && ramp_round_border(centres, 2 * longest, params, entry)) return entry;
  entry.descent.kind = DescentKind::kRamp;
  // The ramp begins and ends where there is most room, so that the tool can turn there.
  const Vec2 line = longest_line(centres, room.centre, longest);
  if (norm(line) < kShortestRamp) return std::nullopt;
  entry.descent.at = room.centre;
  entry.descent.ramp_by = {room.centre + line};
  entry.start = {entry.descent.at, angle_of(line)};
  return entry;
}

double area_cut_by(const Descent& descent, const ClearedGround& before) {
  const double radius = before.tool_radius();
  const double whole = descent.kind == DescentKind::kHelix ? cleared_area(descent, radius)
                                                           : ramp_area(descent, radius);
  Bounds box{descent.at, descent.at};
  for (const Vec2 p : descent.ramp_by) box = joined(box, {p, p});
  if (descent.kind == DescentKind::kHelix) {
    const Vec2 opposite = 2 * descent.centre - descent.at;
    box = grown(joined(box, {opposite, opposite}), descent.radius);
  }
  ClearedGround by_it(box, radius, nullptr);
  add_descent(descent, by_it);
  box = grown(box, radius);
  const double step = kStandingLook * radius;
  double all = 0, new_ones = 0;
  for (double x = box.low.x + 0.5 * step; x < box.high.x; x += step)
    for (double y = box.low.y + 0.5 * step; y < box.high.y; y += step) {
      if (!by_it.is_cleared_point({x, y})) continue;
      ++all;
      if (!before.is_cleared_point({x, y})) ++new_ones;
    }
  return all > 0 ? whole * new_ones / all : 0;
}

std::optional<Entry> helix_within(const Area& centres, const Circle& room, ClearingParams params) {
  params.entry = EntryKind::kHelix;
  std::optional<Entry> entry = descend_within(centres, room, params);
  if (entry && entry->descent.kind != DescentKind::kHelix) entry.reset();
  return entry;
}

bool is_shrunk(const Descent& helix, const ClearingParams& params) {
  return helix.kind == DescentKind::kHelix &&
         helix.radius < std::min(0.5 * params.helix_diameter, widest_helix(params)) - kAtBorder;
}

double wished_stretch(double helix_radius, const ClearingParams& params) {
  return stretch_of_half_turns(helix_radius, sought_stretch(helix_radius, params), params);
}

void stretch_helix(Entry& entry, const Area& centres, const ClearingParams& params) {
  Descent& helix = entry.descent;
  if (helix.kind != DescentKind::kHelix) return;
  const double wish = wished_stretch(helix.radius, params),
               needed = (1 + kStretchedRoom) * helix.radius;
  const auto free = [&](double angle, double limit) {
    return free_length(centres, helix.centre, unit(angle), limit, needed);
  };
  const auto both_ways = [&](double angle) {
    const double ahead = free(angle, wish);
    return ahead + free(angle + kPi, wish - ahead);
  };
  const double angle = direction_of_longest(centres, helix.centre, kPi, both_ways);
  const double ahead = free(angle, wish), behind = free(angle + kPi, wish - ahead);
  const Vec2 u = unit(angle);
  const double stretch = stretch_of_half_turns(helix.radius, ahead + behind, params);
  if (stretch <= 0) return;
  helix.centre = helix.centre + (0.5 * stretch - std::min(behind, stretch)) * u;
  helix.stretch = 0.5 * stretch * u;
  helix.at = helix.centre + helix.stretch + helix.radius * u;
  entry.start = {helix.at, angle_of(u) + kPi / 2};
}

void fill_narrow_room(Entry& entry, const Circle& room, const ClearingParams& params) {
  Descent& helix = entry.descent;
  if (helix.kind != DescentKind::kHelix || norm(helix.stretch) > 0) return;
  if (room.radius >= kNarrowRoom * 0.5 * params.tool_diameter) return;
  helix.radius = std::min(0.5 * params.helix_diameter, (1 - kSame) * room.radius);
  helix.at = helix.centre + Vec2{helix.radius, 0};
  entry.start = {helix.at, kPi / 2};
}

std::optional<Pose> start_outside(const Area& centres, const std::vector<Region>& material,
                                  const ClearedGround& ground, std::optional<Vec2> near) {
  const double beside = kBeside * ground.tool_radius();
  std::optional<Pose> best;
  double best_rank = 0;  // the larger the better: its length, or how near it is
  for (const Region& region : material)
    for (const Curve& curve : region.curves())
      for (const Segment& edge : curve.segments()) {
        if (!edge.open) continue;
        const auto at = [&](double t) {
          const Vec2 inwards = left_normal(edge.tangent(t));
          return Pose{edge.point(t) - beside * inwards, angle_of(inwards) + kPi / 2};
        };
        const auto is_allowed = [&](double t) {
          const Vec2 p = at(t).p;
          return centres.signed_distance(p) >= 0 && ground.is_clear(p);
        };
        double refused = near ? edge.nearest(*near) : 0.5, t = refused;
        if (!is_allowed(t)) {
          t = 0.5;
          if (!is_allowed(t)) continue;
          for (int halved = 0; halved < kHalvedEdge; ++halved)
            (is_allowed(0.5 * (refused + t)) ? t : refused) = 0.5 * (refused + t);
        }
        const double rank = near ? -distance(at(t).p, *near) : edge.length();
        if (best && rank <= best_rank + 1e-9) continue;
        best = at(t);
        best_rank = rank;
      }
  return best;
}

}  // namespace evenload
