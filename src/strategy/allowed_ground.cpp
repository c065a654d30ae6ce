#include "strategy/allowed_ground.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>

#include "geometry/boundary_index.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Outside open edges the tool may go this many of its diameters from the stock.
constexpr double kOutsideRoom = 1.5;
// The same where another region is near: so much the tool needs to come down there.
constexpr double kLeastRoom = 0.55;
constexpr double kApart = 1e-3;  // mm: between the rooms of two regions
// mm: between two places of a border that are looked at for other regions.
constexpr double kLook = 0.2;
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

// mm, at least: from the open pieces of one outline to another outline.
double gap_between(const Curve& open, const BoundaryIndex& other, double most) {
  double gap = most;
  for (const Segment& piece : open.segments()) {
    if (!piece.open) continue;
    const int looks = std::max(1, static_cast<int>(std::ceil(piece.length() / kLook)));
    const double apart = piece.length() / looks;
    for (int i = 0; i <= looks; ++i) {
      const Vec2 p = piece.point(static_cast<double>(i) / looks);
      gap = std::min(gap, other.distance_below(p, gap + apart) - 0.5 * apart);
    }
  }
  return gap;
}

// mm: how much room there is outside the open edges of each region, up to `most`: as far as others
// leave it, which have half of it where they are open as well, but those that are open all round
// between each other. Only those that are `open` have any; 0 for the others.
std::vector<double> rooms_between(const std::vector<Region>& regions, const std::vector<bool>& open,
                                  double most) {
  std::vector<double> rooms(regions.size(), 0);
  std::vector<BoundaryIndex> outlines;
  for (const Region& region : regions) outlines.emplace_back(std::vector<Curve>{region.outer});
  const auto shares_room = [&](std::size_t i) { return open[i] && is_open_all_round(regions[i]); };
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!open[i]) continue;
    rooms[i] = most;
    for (std::size_t j = 0; j < regions.size(); ++j) {
      if (i == j || (shares_room(i) && shares_room(j))) continue;
      const double share = open[j] ? 0.5 : 1;
      const double gap = gap_between(regions[i].outer, outlines[j], most / share + kApart);
      rooms[i] = std::min(rooms[i], share * (gap - kApart));
    }
  }
  return rooms;
}

// The same; 0 where it would be less than `least`, which leaves more to the others.
std::vector<double> rooms_outside(const std::vector<Region>& regions, double least, double most) {
  std::vector<bool> open;
  for (const Region& region : regions) open.push_back(is_open_somewhere(region));
  for (;;) {
    std::vector<double> rooms = rooms_between(regions, open, most);
    bool all_have = true;
    for (std::size_t i = 0; i < regions.size(); ++i)
      if (open[i] && rooms[i] < least) open[i] = all_have = false;
    if (all_have) return rooms;
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
  const std::vector<double> rooms = rooms_outside(regions, (0.5 + kLeastRoom) * tool_diameter,
                                                  (1 + kOutsideRoom) * tool_diameter);
  std::vector<Region> result, open_all_round;
  double shared = std::numeric_limits<double>::infinity();
  // Runs that face each other, or turn inwards too tightly, have no room that is surely free.
  const auto with_room = [&](const Region& region, double room,
                             Tips tips) -> std::optional<Region> {
    if (room <= 0) return std::nullopt;
    try {
      return make_region(with_room_outside(region.outer, room, tips), region.islands);
    } catch (const GeometryError&) {
      return std::nullopt;
    }
  };
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const Region& region = regions[i];
    if (!is_open_somewhere(region)) {
      result.push_back(region);
    } else if (is_open_all_round(region) && rooms[i] > 0) {
      open_all_round.push_back(region);
      shared = std::min(shared, rooms[i]);
    } else {
      std::optional<Region> roomy = with_room(region, rooms[i], Tips::kRunPast);
      if (!roomy) roomy = with_room(region, rooms[i], Tips::kCutOff);
      if (!roomy)
        notes.push_back("The open edges " + near(shown(first_open_place(region.outer))) +
                        " leave no clear room outside: they were taken for walls.");
      result.push_back(roomy ? std::move(*roomy) : region);
    }
  }
  if (open_all_round.empty()) return result;
  for (Region& grown : grown_together(open_all_round, shared)) result.push_back(std::move(grown));
  return result;
}

}  // namespace evenload
