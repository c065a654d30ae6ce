#include "strategy/places/allowed_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/intersect.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Outside open edges the tool may go this many of its diameters from the stock.
constexpr double kOutsideRoom = 1.5;
// The same where another region is in the way: so much the tool needs to come down there. And by
// how much rooms that overlap are narrowed at a time.
constexpr double kLeastRoom = 0.05, kNarrowing = 0.9;
// rad: how much more tightly than at a right angle a wall and an open edge meet in a tip.
constexpr double kTip = 0.05;

// Beside a tip of material between a wall and an open edge.
enum class Tips {
  kCutOff,   // the room ends square to the open edge: the tool does not reach all of the tip
  kRunPast,  // the room goes on as the wall does: the tool may follow it past the tip
};

// The outline of `outer` with room of `room` mm outside every run of open pieces: the run moved
// outwards, joined to its ends by straight lines, so that walls which end there keep their ends.
// Condition: not all pieces are open.
Curve with_room_outside(const Curve& outer, double room, Tips tips) {
  const std::vector<Segment> pieces = outer.segments();
  const std::size_t n = pieces.size();
  std::vector<Vertex> vertices;
  const auto outwards = [&](const Segment& piece, double t) {
    return -left_normal(piece.tangent(t));
  };
  // Where one of two pieces that follow each other is open: how they turn there.
  const auto is_tip = [&](Vec2 before, Vec2 after) {
    return tips == Tips::kRunPast &&
           wrap_signed(angle_of(after) - angle_of(before)) > kPi / 2 + kTip;
  };
  std::size_t first = 0;
  while (pieces[first].open) ++first;  // begin with a wall
  for (std::size_t k = 0; k < n; ++k) {
    const Segment& piece = pieces[(first + k) % n];
    const Segment& before = pieces[(first + k + n - 1) % n];
    const Segment& after = pieces[(first + k + 1) % n];
    if (!piece.open) {
      vertices.push_back({piece.a, piece.bulge(), false});
      continue;
    }
    if (!before.open) {
      vertices.push_back({piece.a, 0, true});
      if (is_tip(before.tangent(1), piece.tangent(0)))
        vertices.push_back({piece.a + room * before.tangent(1), 0, true});
    }
    // Outwards is to the right: a left turn grows, a right turn shrinks.
    vertices.push_back({piece.a + room * outwards(piece, 0), piece.bulge(), true});
    const Vec2 end = piece.b + room * outwards(piece, 1);
    if (!after.open) {
      vertices.push_back({end, 0, true});
      if (is_tip(piece.tangent(1), after.tangent(0)))
        vertices.push_back({piece.b - room * after.tangent(0), 0, true});
      continue;
    }
    const double turn = wrap_signed(angle_of(after.tangent(0)) - angle_of(piece.tangent(1)));
    vertices.push_back({end, turn > 1e-9 ? std::tan(turn / 4) : 0, true});
  }
  return Curve(std::move(vertices), true);
}

Vec2 first_open_place(const Curve& curve) {
  for (const Segment& piece : curve.segments())
    if (piece.open) return piece.point(0.5);
  return curve.segments().front().a;
}

bool is_open(const Vertex& vertex) { return vertex.open; }

bool is_open_all_round(const Region& region) {
  const std::vector<Vertex>& v = region.outer.vertices();
  return std::all_of(v.begin(), v.end(), is_open);
}

bool is_open_somewhere(const Region& region) {
  const std::vector<Vertex>& v = region.outer.vertices();
  return std::any_of(v.begin(), v.end(), is_open);
}

// Whether two regions have ground in common, or touch.
bool overlap(const Region& a, const Region& b) {
  if (!overlap(bounds_of({a}), bounds_of({b}))) return false;
  std::vector<Segment> pieces;
  std::vector<Bounds> boxes;
  for (const Curve& curve : a.curves())
    for (const Segment& piece : curve.segments()) {
      pieces.push_back(piece);
      boxes.push_back(piece.bounds());
    }
  const BoxTree tree(boxes);
  bool meet = false;
  for (const Curve& curve : b.curves())
    for (const Segment& piece : curve.segments())
      tree.visit(grown(piece.bounds(), kTouch), [&](std::size_t i) {
        meet = meet || meetings(pieces[i], piece, kTouch).count > 0;
      });
  const auto some_place = [](const Region& region) { return region.outer.vertices().front().p; };
  return meet || a.contains(some_place(b)) || b.contains(some_place(a));
}

// A region with room outside its open edges.
struct Roomy {
  const Region& region;
  double room;    // mm; 0: its open edges are taken for walls
  Region ground;  // with the room

  bool shares_room() const { return room > 0 && is_open_all_round(region); }

  // Gives it so much room. Runs that face each other, or turn inwards too tightly, have none that
  // is surely free.
  void set_room(double wished) {
    ground = region;
    room = 0;
    if (wished <= 0 || !is_open_somewhere(region)) return;
    if (is_open_all_round(region)) {
      ground = offset({{region.outer, {}}}, wished).front();
      ground.islands = region.islands;
      room = wished;
      return;
    }
    for (const Tips tips : {Tips::kRunPast, Tips::kCutOff}) {
      try {
        ground = make_region(with_room_outside(region.outer, wished, tips), region.islands);
        room = wished;
        return;
      } catch (const GeometryError&) {
        continue;
      }
    }
  }
};

// Narrows rooms, down to `least` mm or none at all, until they overlap with no other region nor
// its room. Regions that are open all round share theirs.
void keep_apart(std::vector<Roomy>& grounds, double least) {
  const auto narrow = [least](Roomy& ground) {
    const double room = kNarrowing * ground.room;
    ground.set_room(room < least ? 0 : room);
  };
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (std::size_t i = 0; i < grounds.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Roomy &a = grounds[i], &b = grounds[j];
        if ((a.room <= 0 && b.room <= 0) || (a.shares_room() && b.shares_room()) ||
            !overlap(a.ground, b.ground))
          continue;
        if (a.room > 0) narrow(a);
        if (b.room > 0) narrow(b);
        is_changed = true;
      }
  }
}

// Regions that are open all round, grown together, with their islands.
std::vector<Region> grown_together(const std::vector<Region>& regions, double room) {
  std::vector<Region> outlines;
  for (const Region& region : regions) outlines.push_back({region.outer, {}});
  std::vector<Region> result = offset(outlines, room);
  for (const Region& region : regions)
    for (const Curve& island : region.islands) {
      const Vec2 place = island.vertices().front().p;
      const auto around = std::find_if(result.begin(), result.end(),
                                       [&](const Region& r) { return r.contains(place); });
      EVENLOAD_ASSERT(around != result.end());
      around->islands.push_back(island);
    }
  return result;
}

}  // namespace

std::vector<Region> bared(std::vector<Region> regions) {
  const auto bare = [](const Curve& curve) {
    std::vector<Vertex> vertices = curve.vertices();
    for (Vertex& v : vertices) v.open = true;
    return Curve(std::move(vertices), true);
  };
  for (Region& region : regions) {
    region.outer = bare(region.outer);
    for (Curve& island : region.islands) island = bare(island);
  }
  return regions;
}

bool has_open_edges(const std::vector<Region>& regions) {
  for (const Region& region : regions)
    for (const Curve& curve : region.curves())
      for (const Vertex& v : curve.vertices())
        if (v.open) return true;
  return false;
}

std::vector<Region> allowed_ground(const std::vector<Region>& regions, double tool_diameter,
                                   const std::function<Vec2(Vec2)>& shown,
                                   std::vector<Finding>& findings) {
  const double most = (1 + kOutsideRoom) * tool_diameter;
  std::vector<Roomy> grounds;
  for (const Region& region : regions) {
    grounds.push_back({region, 0, {}});
    grounds.back().set_room(most);
  }
  keep_apart(grounds, (1 + kLeastRoom) * tool_diameter);
  std::vector<Region> result, open_all_round;
  double shared = most;
  for (Roomy& ground : grounds) {
    if (ground.shares_room()) {
      open_all_round.push_back(ground.region);
      shared = std::min(shared, ground.room);
      continue;
    }
    if (ground.room <= 0 && is_open_somewhere(ground.region))
      findings.push_back(
          {FindingCode::kOpenEdgesTakenForWalls, shown(first_open_place(ground.region.outer))});
    result.push_back(std::move(ground.ground));
  }
  if (open_all_round.empty()) return result;
  for (Region& grown : grown_together(open_all_round, shared)) result.push_back(std::move(grown));
  return result;
}

}  // namespace evenload
