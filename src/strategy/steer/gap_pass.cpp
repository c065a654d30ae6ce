#include "strategy/steer/gap_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cutting/probe.h"
#include "strategy/moves/move_checks.h"
#include "strategy/steer/steering_parts.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {

using steering_parts::kInContact;

namespace {

// mm: so near to a wall a circle touches it.
constexpr double kTouches = 1e-7;
// Shares of the tool's radius: half of the widest gap; the furthest reach along its wall, from a
// start next to which there is material; between two looks along it; the first reach that is tried,
// and to which the furthest one that will do is found.
constexpr double kWidest = 0.1;
constexpr double kFurthest = 0.5;
constexpr double kWallLook = 0.02;
constexpr double kFirstReach = 1e-3;
constexpr double kExactReach = 1e-4;
// rad: between the directions of the walls where an arc touches them; beyond it is no gap but a
// corner.
constexpr double kMostTaper = 1.0;
// rad: between two looks along the arc.
constexpr double kArcLook = 8 * kPi / 180;
// A pass that meets no more than this share of the limit gets nowhere.
constexpr double kLeastMet = 0.5;
constexpr int kMostShrinking = 50;
// Where one arc would be posted as lines, a wider one may end the turn: so many times as wide, and
// no tighter than this, mm; it is led to the wall in at most so many steps.
constexpr double kWidening = 2;
constexpr double kWidened = 0.1;
constexpr int kMostLeading = 8;
// mm: what may stay on the other wall, between two arcs that touch it.
constexpr double kFilm = 3e-4;

// Along a wall, and round to the one that faces it.
struct Way {
  std::vector<Segment> wall, turn;
};

class GapPass {
 public:
  GapPass(const Area& centres, const Pose& start, ClearedGround& ground, double engagement)
      : centres_(centres),
        ground_(ground),
        engagement_(engagement),
        radius_(ground.tool_radius()),
        start_(centres.nearest(start.p)) {
    is_on_wall_ = start_.distance < kOnWall && norm(centres.segment_at(start_).tangent(start_.t) -
                                                    unit(start.heading)) < kSameDirection;
  }

  Pass made() {
    if (!is_on_wall_) return {};
    Pass pass = furthest();
    if (ends_short_) {
      ends_wide_ = true;
      Pass other = furthest();
      if (other.cut_area > pass.cut_area) pass = std::move(other);
    }
    for (const Segment& move : pass.moves) ground_.add(move);
    return pass;
  }

 private:
  // The pass that follows the wall as far as it keeps to the limit; not yet in the ground.
  Pass furthest() {
    double low = 0, high = kFirstReach * radius_;
    while (high < kFurthest * radius_ && is_within(high)) {
      low = high;
      high *= 2;
    }
    if (low <= 0) return {};
    while (high - low > kExactReach * radius_) {
      const double middle = 0.5 * (low + high);
      (is_within(middle) ? low : high) = middle;
    }
    const std::optional<Way> way = way_to(low);
    return way ? pass_along(*way) : Pass{};
  }

  // The way that leaves the wall after `reach` mm, which is not next to nothing; nothing where it
  // is no gap, or posts could not write the turn.
  std::optional<Way> way_to(double reach) {
    Way way;
    const Curve& curve = centres_.curves()[start_.curve];
    std::size_t i = start_.segment;
    double from = start_.t, left = reach;
    for (;;) {
      const Segment piece = curve.segment(i).part(from, 1);
      const double length = piece.length();
      if (!way.wall.empty() && length > kTouches &&
          !is_tangent(way.wall.back(), piece, kSameDirection))
        return std::nullopt;
      if (left <= length) {
        if (left > kTouches) way.wall.push_back(piece.part(0, left / length));
        break;
      }
      if (length > kTouches) way.wall.push_back(piece);
      left -= length;
      from = 0;
      i = (i + 1) % curve.segment_count();
    }
    way.turn = turn_across(way.wall.back().b, way.wall.back().tangent(1));
    if (way.turn.empty()) return std::nullopt;
    return way;
  }

  // The turn from `p` on a wall that is followed along `along` to the wall that faces it there; as
  // a rule one arc. The circle that touches the wall in `p` shrinks until nothing is inside of it.
  std::vector<Segment> turn_across(Vec2 p, Vec2 along) {
    const Vec2 normal = left_normal(along);
    double r = kWidest * radius_;
    Vec2 touched = p;
    for (int i = 0; i < kMostShrinking; ++i) {
      const BoundaryIndex::Hit hit = centres_.nearest(p + r * normal);
      if (hit.distance > r - kTouches) break;
      touched = centres_.segment_at(hit).point(hit.t);
      const double ahead = dot(touched - p, normal);
      if (ahead <= 0) return {};
      r = squared_norm(touched - p) / (2 * ahead);
    }
    if (touched == p || r < kLeastArcRadius + kRadiusMargin) return {};
    const Vec2 centre = p + r * normal;
    const double begin = angle_of(p - centre);
    const double sweep = wrap_positive(angle_of(touched - centre) - begin);
    if (std::abs(sweep - kPi) > kMostTaper) return {};
    if (!becomes_corners(r, sweep)) return {Segment::arc(centre, r, begin, sweep)};
    // Where the gap widens the arc is longer than half a turn, and would be written in halves.
    ends_short_ = true;
    if (ends_wide_) return arcs_across(p, along, touched, r);
    // It ends short of the wall by next to nothing.
    return {Segment::arc(centre, r, begin, kPi)};
  }

  // The same by an arc of less than half a turn and a wider one, which ends along the wall near
  // `touched`, where one of radius `r` would. Empty where posts could not write them.
  std::vector<Segment> arcs_across(Vec2 p, Vec2 along, Vec2 touched, double r) const {
    const double wide = std::max(kWidening * r, kWidened), last = least_arc_sweep(wide);
    const double heading = angle_of(along);
    // From where an arc begins to where it ends, between two headings.
    const auto chord = [](double radius, double from, double to) {
      return radius * (left_normal(unit(from)) - left_normal(unit(to)));
    };
    Vec2 end = touched;
    for (int i = 0; i < kMostLeading; ++i) {
      const BoundaryIndex::Hit hit = centres_.nearest(end);
      const Segment& wall = centres_.segment_at(hit);
      const Vec2 onto = wall.tangent(hit.t), towards = left_normal(onto);
      const double whole = wrap_positive(angle_of(onto) - heading), first = whole - last;
      const double across =
          dot(wall.point(hit.t) - p - chord(wide, heading + first, heading + whole), towards);
      const double tight = across / dot(chord(1, heading, heading + first), towards);
      if (first <= 0 || first > kPi || !(tight > 0) || becomes_corners(tight, first)) return {};
      const Vec2 joint = p + chord(tight, heading, heading + first);
      const Vec2 reached = joint + chord(wide, heading + first, heading + whole);
      const bool is_there = distance(reached, end) < kTouches;
      end = reached;
      if (!is_there) continue;
      const auto arc = [](Vec2 from, double radius, double begin, double sweep) {
        return Segment::arc(from + radius * left_normal(unit(begin)), radius, begin - kPi / 2,
                            sweep);
      };
      return {arc(p, tight, heading, first), arc(joint, wide, heading + first, last)};
    }
    return {};
  }

  double met_on(const Segment& move, double t, double thin = kThin) {
    return probe_.engagement(move, t, thin);
  }

  int looks_along(const Segment& wall) const {
    return static_cast<int>(std::ceil(wall.length() / (kWallLook * radius_)));
  }
  static int looks_along_arc(const Segment& arc) {
    return static_cast<int>(std::ceil(arc.sweep / kArcLook));
  }

  // Whether the way that leaves the wall after `reach` mm keeps to the limit, and is out of the
  // material where it comes to the other wall.
  bool is_within(double reach) {
    const std::optional<Way> way = way_to(reach);
    if (!way || met_on(way->turn.back(), 1, kFilm) > kInContact) return false;
    const auto keeps = [&](const Segment& move, int looks) {
      for (int i = 0; i < looks; ++i)
        if (met_on(move, (i + 0.5) / looks) > engagement_) return false;
      return true;
    };
    return std::all_of(way->turn.begin(), way->turn.end(),
                       [&](const Segment& arc) {
                         return is_inside(arc, centres_, kSame) && keeps(arc, looks_along_arc(arc));
                       }) &&
           std::all_of(way->wall.begin(), way->wall.end(),
                       [&](const Segment& wall) { return keeps(wall, looks_along(wall)); });
  }

  Pass pass_along(const Way& way) {
    Pass pass;
    double travelled = 0, first = -1, last = 0, most = 0;  // mm, rad
    const auto look_along = [&](const Segment& move, int looks) {
      const double step = move.length() / std::max(1, looks);
      for (int i = 0; i < looks; ++i, travelled += step) {
        const double met = met_on(move, (i + 0.5) / looks);
        if (met <= kInContact) continue;
        if (first < 0) first = travelled;
        last = travelled + step;
        most = std::max(most, met);
        pass.cut_area += step * radius_ * (1 - std::cos(met));
      }
    };
    for (const Segment& wall : way.wall) look_along(wall, looks_along(wall));
    for (const Segment& arc : way.turn) look_along(arc, looks_along_arc(arc));
    if (most < kLeastMet * engagement_) return {};
    pass.moves = way.wall;
    pass.moves.insert(pass.moves.end(), way.turn.begin(), way.turn.end());
    pass.idle_before = first;
    pass.idle_after = travelled - last;
    pass.cut_length = last - first;
    return pass;
  }

  const Area& centres_;
  ClearedGround& ground_;
  double engagement_, radius_;
  BoundaryIndex::Hit start_;
  bool is_on_wall_ = false;
  bool ends_short_ = false;  // some turn that was looked at, of the wall it leads to
  bool ends_wide_ = false;   // such turns, by a second arc, in place of that
  Probe probe_{ground_};
};

}  // namespace

Pass gap_pass(const Area& centres, const Pose& start, ClearedGround& ground, double engagement) {
  return GapPass(centres, start, ground, engagement).made();
}

}  // namespace evenload
