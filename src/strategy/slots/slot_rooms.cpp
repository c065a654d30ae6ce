#include "strategy/slots/slot_rooms.h"

#include <algorithm>
#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Half rooms squared: an end of a slot that has more besides its stretch, up to the furthest place
// of the front, is no mere end.
constexpr double kLongestEnd = 8;

std::optional<WallPlace> place_on_wall(const Area& centres, Vec2 p) {
  const BoundaryIndex::Hit hit = centres.nearest(p);
  if (hit.distance > kSameWidth) return std::nullopt;
  return WallPlace{hit.curve, hit.segment, hit.t};
}

// The border of the centres from `from` to `to`, added to `border`. False where it does not lead
// there.
bool go_along(const Area& centres, Vec2 from, Vec2 to, std::vector<Segment>& border) {
  const std::optional<WallPlace> a = place_on_wall(centres, from), b = place_on_wall(centres, to);
  if (!a || !b || a->curve != b->curve) return false;
  for (const Segment& piece : border_between(centres.curves()[a->curve], *a, *b))
    border.push_back(piece);
  return true;
}

std::optional<Region> closed_room(const Region& region, const std::vector<Segment>& border) {
  std::vector<Vertex> vertices;
  for (const Segment& piece : border) vertices.push_back({piece.a, piece.bulge(), piece.open});
  const Curve outer(std::move(vertices), true);
  if (outer.signed_area() <= 0) return std::nullopt;
  for (const Curve& island : region.islands)
    if (outer.contains(island.vertices().front().p)) return std::nullopt;
  try {
    return make_region(outer);
  } catch (const GeometryError&) {
    return std::nullopt;  // behind the front the walls come too near to it
  }
}

}  // namespace

std::vector<Segment> round_front(const SlotStretch& stretch, double s) {
  const Pose at = pose_on(stretch, s);
  return {Segment::arc(at.p, stretch.half_room, at.heading - kPi / 2, kPi)};
}

std::optional<Region> room_behind(const Region& region, const Area& centres,
                                  const std::vector<Segment>& front) {
  std::vector<Segment> border = front;
  if (!go_along(centres, front.back().b, front.front().a, border)) return std::nullopt;
  return closed_room(region, border);
}

std::optional<Region> room_between(const Region& region, const Area& centres,
                                   const SlotStretch& stretch, double s,
                                   const std::vector<Segment>& front) {
  // Beyond the stretch the half circle would lead into a wall.
  if (s < 0 || s > stretch.middle.length()) return std::nullopt;
  std::vector<Segment> border = front;
  const Pose at = pose_on(stretch, s);
  const Segment back = Segment::arc(at.p, stretch.half_room, at.heading + kPi / 2, kPi);
  if (!go_along(centres, front.back().b, back.a, border)) return std::nullopt;
  border.push_back(back);
  if (!go_along(centres, back.b, front.front().a, border)) return std::nullopt;
  return closed_room(region, border);
}

bool is_end(const Region& room, const SlotStretch& stretch, const std::vector<Segment>& front) {
  double furthest = 0;  // share of the stretch
  for (const Segment& piece : front)
    for (const double t : {0.5, 1.0})
      furthest = std::max(furthest, stretch.middle.nearest(piece.point(t)));
  const double h = stretch.half_room;
  return room.area() < kLongestEnd * h * h + 2 * h * furthest * stretch.middle.length();
}

std::optional<StartRoom> start_room(const Region& region, const Area& centres,
                                    const SlotStretch& stretch, double s,
                                    const std::vector<Segment>& front) {
  std::optional<Region> room = room_behind(region, centres, front);
  if (room && is_end(*room, stretch, front)) return StartRoom{std::move(*room), true};
  room = room_between(region, centres, stretch, std::max(0.0, s - stretch.half_room), front);
  if (!room) return std::nullopt;
  return StartRoom{std::move(*room), false};
}

}  // namespace evenload
