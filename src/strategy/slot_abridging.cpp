#include "strategy/slot_abridging.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/allowed_ground.h"
#include "strategy/entry.h"
#include "support/errors.h"

namespace evenload {
namespace {

// A piece of fewer periods is not worth taking out.
constexpr int kFewestPeriods = 8;
// mm: from the middle to both walls, at both of their ends.
constexpr double kSameDistance = 1e-7;
// Each cut costs a look at all of the border.
constexpr std::size_t kMostCuts = 64;

// A piece of a region's border beside the slot, from one place along the middle to another.
struct Wall {
  std::size_t piece = 0;
  double from = 0, to = 0;  // mm
};

// Both walls of a slot in one region.
struct Walls {
  std::size_t region = 0;
  Wall right, left;
  double from = 0, to = 0;  // mm, where both are
};

double sense(const Segment& arc) { return arc.sweep > 0 ? 1 : -1; }

// `side`: 1 left, -1 right.
bool is_wall(const Segment& piece, const Segment& middle, double half_width, double side) {
  if (piece.is_arc() != middle.is_arc()) return false;
  if (!middle.is_arc()) {
    const Vec2 u = middle.tangent(0), n = left_normal(u), way = piece.tangent(0);
    const auto is_beside = [&](Vec2 p) {
      return std::abs(side * dot(p - middle.a, n) - half_width) < kSameDistance;
    };
    return dot(way, u) * side < 0 && is_beside(piece.a) && is_beside(piece.b);
  }
  const double radius = middle.radius - sense(middle) * side * half_width;
  return sense(piece) * sense(middle) * side < 0 &&
         distance(piece.centre, middle.centre) < kSameDistance &&
         std::abs(piece.radius - radius) < kSameDistance;
}

std::vector<Wall> walls_of(const Curve& border, const Segment& middle, double half_width,
                           double side) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < border.segment_count(); ++i) {
    const Segment piece = border.segment(i);
    if (piece.open || !is_wall(piece, middle, half_width, side)) continue;
    const double a = along(middle, piece.a), b = along(middle, piece.b);
    // An arc beyond half a circle from the middle's middle is not told from one before it.
    if ((b - a) * side < 0) walls.push_back({i, std::min(a, b), std::max(a, b)});
  }
  return walls;
}

// The last along the middle first: what is taken out there leaves the others where they are.
std::vector<Walls> walls_beside(const std::vector<Region>& ground, const Segment& middle,
                                double half_width) {
  std::vector<Walls> result;
  for (std::size_t k = 0; k < ground.size(); ++k)
    for (const Wall& right : walls_of(ground[k].outer, middle, half_width, -1))
      for (const Wall& left : walls_of(ground[k].outer, middle, half_width, 1)) {
        const double from = std::max({right.from, left.from, 0.0}),
                     to = std::min({right.to, left.to, middle.length()});
        if (to > from) result.push_back({k, right, left, from, to});
      }
  std::sort(result.begin(), result.end(),
            [](const Walls& a, const Walls& b) { return a.from > b.from; });
  return result;
}

// The walls to both sides of a place of what a cut has left.
std::optional<Walls> walls_at(const SlotCut& cut, double at) {
  for (const Walls& pair : walls_beside(cut.ground, cut.stretch.middle, cut.half_width))
    if (pair.region == cut.region && pair.from < at && pair.to > at) return pair;
  return std::nullopt;
}

double share_of(const Segment& piece, const Segment& middle, double at) {
  const double a = along(middle, piece.a), b = along(middle, piece.b);
  return (at - a) / (b - a);
}

// The outlines of a region's parts before and beyond a line across the slot.
struct SlotSides {
  Region before, beyond;
};
SlotSides divided(const Curve& border, const Walls& walls, const Segment& middle, double at) {
  const std::vector<Vertex>& v = border.vertices();
  const Segment right = border.segment(walls.right.piece), left = border.segment(walls.left.piece);
  const double r = share_of(right, middle, at), l = share_of(left, middle, at);
  const auto side = [&](const Segment& first, std::size_t from, std::size_t to,
                        const Segment& last) {
    std::vector<Vertex> outline{{first.a, first.bulge()}};
    for (std::size_t i = (from + 1) % v.size(); i != to; i = (i + 1) % v.size())
      outline.push_back(v[i]);
    outline.push_back({last.a, last.bulge()});
    outline.push_back({last.b});
    Region region;
    region.outer = Curve(std::move(outline), true);
    return region;
  };
  return {side(left.part(l, 1), walls.left.piece, walls.right.piece, right.part(0, r)),
          side(right.part(r, 1), walls.right.piece, walls.left.piece, left.part(0, l))};
}

bool is_beyond(const SlotSides& sides, Vec2 p) {
  return Area({sides.beyond}).signed_distance(p) > Area({sides.before}).signed_distance(p);
}

Curve moved(const Curve& curve, const Pose& motion) {
  std::vector<Vertex> vertices = curve.vertices();
  for (Vertex& v : vertices) v.p = moved(v.p, motion);
  return Curve(std::move(vertices), true);
}

// The outline without `out` mm of the slot. Condition: both walls are longer.
Curve without(const Curve& border, const Walls& walls, const Segment& middle, double out) {
  std::vector<Vertex> v = border.vertices();
  const Pose motion = motion_along(middle, -out);
  const std::size_t first = (walls.right.piece + 1) % v.size();
  for (std::size_t i = first;; i = (i + 1) % v.size()) {
    v[i].p = moved(v[i].p, motion);
    if (i == walls.left.piece) break;
  }
  if (middle.is_arc())
    for (const std::size_t i : {walls.right.piece, walls.left.piece}) {
      const Segment wall = border.segment(i);
      v[i].bulge = sense(wall) * std::tan((std::abs(wall.sweep) - out / middle.radius) / 4);
    }
  return Curve(std::move(v), true);
}

class Abridging {
 public:
  Abridging(const std::vector<Region>& regions, const std::vector<SlotPiece>& spared,
            const ClearingParams& params, const PatternOf& pattern_of, std::optional<Vec2>& hole)
      : ground_(regions),
        spared_(spared),
        params_(params),
        pattern_of_(pattern_of),
        hole_(hole),
        radius_(0.5 * params.tool_diameter) {}

  std::vector<SlotCut> run(std::vector<SlotStretch> stretches) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const double half_width =
          stretches[i].half_room + radius_ + params_.stock_to_leave + kWallGap;
      SlotPiece piece{i, 0, false};
      for (const Walls& walls : walls_beside(ground_, stretches[i].middle, half_width))
        for (const auto& [from, to] : beside_hole(stretches[i], half_width, walls)) {
          piece.reversed = likely_reversed(stretches[i]);
          if (is_spared(piece) && stretches[i].middle.is_arc()) piece.reversed = !piece.reversed;
          if (!is_spared(piece) && is_likely_used(walls.region))
            cut(stretches, piece, half_width, walls, from, to);
          ++piece.number;
        }
    }
    return std::move(cuts_);
  }

 private:
  bool is_spared(const SlotPiece& piece) const {
    return std::any_of(spared_.begin(), spared_.end(), [&](const SlotPiece& known) {
      return known.stretch == piece.stretch && known.number == piece.number &&
             known.reversed == piece.reversed;
    });
  }

  // Whether a pattern is likely to begin in one more piece of a region: but for holes and open
  // ends, patterns seldom find ground to begin in besides that which is cleared for the first.
  bool is_likely_used(std::size_t region) const {
    if (cuts_.size() >= kMostCuts) return false;
    return hole_ || has_open_edges({ground_[region]}) ||
           std::none_of(cuts_.begin(), cuts_.end(),
                        [&](const SlotCut& cut) { return cut.region == region; });
  }

  // Whether an arc is likely to be cut from its other end on: the smaller the room that is cleared
  // for the first period, the better.
  bool likely_reversed(const SlotStretch& stretch) const {
    if (!stretch.middle.is_arc()) return false;
    const std::optional<SlotPattern> ahead = pattern_of_(stretch),
                                     back = pattern_of_(stretch.reversed());
    if (!ahead || !back) return !ahead;
    return room_before(*back, stretch.half_room) < room_before(*ahead, stretch.half_room);
  }

  // mm^2, of the places of the tool's centre, but for what does not depend on the pattern.
  double room_before(const SlotPattern& pattern, double half_room) const {
    std::vector<Vertex> outline{{{0, half_room}}, {{0, -half_room}}};
    for (const Segment& move : pattern.front) outline.push_back({move.a, move.bulge()});
    outline.push_back({pattern.front.back().b});
    const double first = std::max(-pattern.reach.back,
                                  wished_room(half_room) - 2 * half_room - pattern.circle_behind);
    return 2 * half_room * first + Curve(std::move(outline), true).signed_area();
  }

  // mm along a slot, for a helix as wide as it.
  double wished_room(double half_room) const {
    return 2 * half_room + wished_stretch(helix_radius(params_, {{}, half_room}), params_);
  }

  // What is left of a pair of walls to both sides of the hole, the last first.
  std::vector<std::pair<double, double>> beside_hole(const SlotStretch& stretch, double half_width,
                                                     const Walls& walls) const {
    if (hole_ && ground_[walls.region].contains(*hole_)) {
      const double at = along(stretch.middle, *hole_);
      if (at > walls.from && at < walls.to && stretch.middle.distance_to(*hole_) < half_width)
        return {{at, walls.to}, {walls.from, at}};
    }
    return {{walls.from, walls.to}};
  }

  // mm that a pattern needs of a slot, from where it is entered to its other end, until it repeats
  // itself and while it does. Periods begin behind the front, which a narrower one may be far from.
  // Whichever end that is, the middle of what is left is among them.
  double needed(const SlotPattern& pattern, double half_room) const {
    const double wished = wished_room(half_room),
                 ahead = std::max(pattern.front_ahead, pattern.reach.ahead);
    const double repeating = ahead - pattern.reach.back + 4 * radius_ + 4 * pattern.pattern.step;
    return std::max(wished + repeating, 2 * (wished + ahead + pattern.pattern.step));
  }

  void cut(std::vector<SlotStretch>& stretches, const SlotPiece& piece, double half_width,
           const Walls& walls, double from, double to) {
    const SlotStretch stretch = stretches[piece.stretch];
    if (to - from < 4 * radius_) return;  // less than any pattern needs
    const std::optional<SlotPattern> pattern =
        pattern_of_(piece.reversed ? stretch.reversed() : stretch);
    if (!pattern) return;
    SlotCut cut;
    cut.from = piece;
    cut.periods = static_cast<int>(
        std::floor((to - from - needed(*pattern, stretch.half_room)) / pattern->pattern.step));
    if (cut.periods < kFewestPeriods) return;
    cut.out = cut.periods * pattern->pattern.step;
    const double length = stretch.middle.length();
    cut.at = 0.5 * (to - from - cut.out);
    cut.region = walls.region;
    cut.half_width = half_width;
    cut.stretch = {stretch.middle.part(from / length, (to - cut.out) / length), stretch.half_room};
    if (!take_out(cut, walls, stretch.middle, from + cut.at)) return;
    for (std::size_t i = piece.stretch + 1; i < stretches.size(); ++i)
      if (is_moved(stretches[i].middle.point(0.5)))
        stretches[i].middle = placed(stretches[i].middle, motion_);
    for (SlotCut& earlier : cuts_)
      if (is_moved(earlier.place)) earlier.place = moved(earlier.place, motion_);
    if (hole_ && is_moved(*hole_)) hole_ = moved(*hole_, motion_);
    cut.place = pose_on(cut.stretch, cut.at).p;
    cuts_.push_back(std::move(cut));
  }

  // False where that cannot be, or rounding has led a wall off the others.
  bool take_out(SlotCut& cut, const Walls& walls, const Segment& middle, double at) {
    const Region& whole = ground_[walls.region];
    motion_ = motion_along(middle, -cut.out);
    sides_ = divided(whole.outer, walls, middle, at);
    others_.clear();
    for (std::size_t i = 0; i < ground_.size(); ++i)
      if (i != walls.region) others_.push_back(ground_[i]);
    std::vector<Curve> islands;
    for (const Curve& island : whole.islands)
      islands.push_back(is_beyond(sides_, island.vertices().front().p) ? moved(island, motion_)
                                                                       : island);
    cut.ground = ground_;
    try {
      cut.ground[walls.region] = make_region(without(whole.outer, walls, middle, cut.out), islands);
    } catch (const GeometryError&) {  // the ground would cross itself
      return false;
    }
    if (!walls_at(cut, cut.at)) return false;
    ground_ = cut.ground;
    return true;
  }

  // Whether a place was moved by the last cut.
  bool is_moved(Vec2 p) const {
    for (const Region& other : others_)
      if (other.contains(p)) return false;
    return is_beyond(sides_, p);
  }

  std::vector<Region> ground_;
  const std::vector<SlotPiece>& spared_;
  const ClearingParams& params_;
  const PatternOf& pattern_of_;
  std::optional<Vec2>& hole_;
  double radius_;
  std::vector<SlotCut> cuts_;
  // Of the last cut:
  Pose motion_;
  SlotSides sides_;  // of the ground before it
  std::vector<Region> others_;
};

}  // namespace

double along(const Segment& middle, Vec2 p) {
  if (!middle.is_arc()) return dot(p - middle.a, middle.tangent(0));
  const double half = 0.5 * middle.sweep;
  const double angle = wrap_signed(angle_of(p - middle.centre) - middle.start_angle - half) + half;
  return sense(middle) * angle * middle.radius;
}

Pose motion_along(const Segment& middle, double length) {
  if (!middle.is_arc()) return {length * middle.tangent(0), 0};
  const double angle = sense(middle) * length / middle.radius;
  return {middle.centre - rotated(middle.centre, angle), angle};
}

Vec2 moved(Vec2 p, const Pose& motion) { return motion.p + rotated(p, motion.heading); }

std::vector<SlotCut> cuts_of(const std::vector<Region>& regions,
                             const std::vector<SlotStretch>& stretches,
                             const std::vector<SlotPiece>& spared, const ClearingParams& params,
                             const PatternOf& pattern_of, std::optional<Vec2>& hole) {
  const std::optional<Vec2> place = hole;
  std::vector<SlotCut> cuts = Abridging(regions, spared, params, pattern_of, hole).run(stretches);
  if (cuts.empty() || regions.size() == 1) return cuts;
  // Where there are open edges, tools go outside: who knows how far from other regions they stay.
  if (!has_open_edges(regions) && offset(cuts.back().ground, kWallGap).size() == regions.size())
    return cuts;
  hole = place;
  return {};
}

double taken_out(const std::vector<SlotCut>& cuts, const SlotStretch& stretch) {
  double out = 0;
  for (const SlotCut& cut : cuts)
    if (stretch.middle.distance_to(cut.place) < kSameWidth &&
        std::abs(stretch.half_room - cut.stretch.half_room) < kSameWidth)
      out += cut.out;
  return out;
}

GroundSides::GroundSides(const SlotCut& cut, double at) {
  const Segment& middle = cut.stretch.middle;
  const std::optional<Walls> walls = walls_at(cut, at);
  EVENLOAD_ASSERT(walls.has_value());
  const SlotSides sides = divided(cut.ground[cut.region].outer, *walls, middle, at);
  before_ = Area({sides.before});
  beyond_ = Area({sides.beyond});
  for (std::size_t i = 0; i < cut.ground.size(); ++i)
    if (i != cut.region) others_.push_back(cut.ground[i]);
}

bool GroundSides::is_beyond(Vec2 p) const {
  for (const Region& other : others_)
    if (other.contains(p)) return false;
  return beyond_.signed_distance(p) > before_.signed_distance(p);
}

WholePlaces::WholePlaces(const std::vector<SlotCut>& cuts) {
  std::vector<Part> parts;
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut)
    parts.push_back({GroundSides(*cut, cut->at), motion_along(cut->stretch.middle, cut->out)});
  parts_ = std::make_shared<const std::vector<Part>>(std::move(parts));
}

Vec2 WholePlaces::operator()(Vec2 p) const {
  for (const Part& part : *parts_)
    if (part.sides.is_beyond(p)) p = moved(p, part.motion);
  return p;
}

}  // namespace evenload
