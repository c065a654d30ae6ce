#include "strategy/allowed_ground.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "support/errors.h"

namespace evenload {
namespace {

// Outside open edges the tool may go this many of its diameters from the stock.
constexpr double kOutsideRoom = 1.5;
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

}  // namespace

std::string near(Vec2 p) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "near (" << p.x << ", " << p.y << ")";
  return text.str();
}

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
                                   std::vector<std::string>& notes) {
  const double room = (1 + kOutsideRoom) * tool_diameter;
  std::vector<Region> result;
  // Runs that face each other, or turn inwards too tightly, have no room that is surely free.
  const auto with_room = [&](const Region& region, Tips tips) -> std::optional<Region> {
    try {
      return make_region(with_room_outside(region.outer, room, tips), region.islands);
    } catch (const GeometryError&) {
      return std::nullopt;
    }
  };
  for (const Region& region : regions) {
    const std::vector<Vertex>& v = region.outer.vertices();
    const auto is_open = [](const Vertex& x) { return x.open; };
    if (std::none_of(v.begin(), v.end(), is_open)) {
      result.push_back(region);
    } else if (std::all_of(v.begin(), v.end(), is_open)) {
      Region outline;
      outline.outer = region.outer;
      for (Region& grown : offset({outline}, room)) {
        grown.islands = region.islands;
        result.push_back(std::move(grown));
      }
    } else {
      std::optional<Region> roomy = with_room(region, Tips::kRunPast);
      if (!roomy) roomy = with_room(region, Tips::kCutOff);
      if (!roomy)
        notes.push_back("The open edges " + near(shown(first_open_place(region.outer))) +
                        " leave no clear room outside: they were taken for walls.");
      result.push_back(roomy ? std::move(*roomy) : region);
    }
  }
  return result;
}

}  // namespace evenload
