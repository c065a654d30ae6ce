#include "simulate/path_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "geometry/point_grid.h"

namespace evenload {
namespace {

// mm: a move that descends by less is level.
constexpr double kNoDescent = 1e-6;

// mm of descent between looks at a gouge on a slope; half of it is the error.
constexpr double kDescent = 0.004;

// Descent over way, from which on a descending move is a plunge: steeper than any ramp.
constexpr double kSteep = 1.0;

// Share of the radius between places of the tool at which material is looked for.
constexpr double kWay = 0.5;

// Share of the radius that is a cell of points.
constexpr double kCell = 0.5;

// Rings of places under the tool: share of the radius, and how many.
struct Ring {
  double share;
  int count;
};
constexpr Ring kRings[] = {{0.0, 1}, {0.35, 6}, {0.7, 12}, {1.0, 24}};

Point3 end_of(const Move& m) { return {m.x, m.y, m.z}; }

// How deep a point at a distance from the tool's axis, and so far above its tip, is in the tool.
double depth_in(const ProofTool& tool, double from_axis, double above) {
  const double radius = 0.5 * tool.diameter, corner = tool.corner_radius;
  const double sideways = radius - from_axis;
  const double across = from_axis - (radius - corner);
  if (corner > 0 && across > 0 && above < corner)
    return corner - std::hypot(across, corner - above);
  return std::min(sideways, above);
}

PointGrid grid_of(const std::vector<Vec2>& points, double cell) {
  if (points.empty()) return {};
  Bounds box{points.front(), points.front()};
  for (const Vec2 p : points) box = joined(box, {p, p});
  PointGrid grid(grown(box, cell), cell);
  for (std::size_t i = 0; i < points.size(); ++i) grid.add(i, points[i]);
  return grid;
}

class Gouges {
 public:
  Gouges(const std::vector<Point3>& bodies, const ProofTool& tool) : bodies_(bodies), tool_(tool) {
    std::vector<Vec2> places;
    for (const Point3& p : bodies) {
      places.push_back({p.x, p.y});
      highest_ = std::max(highest_, p.z);
    }
    grid_ = grid_of(places, kCell * 0.5 * tool.diameter);
  }

  // The deepest of a move, where it is deeper than the limit.
  std::optional<Fault> of(const Point3& from, const Move& move, double limit) const {
    if (bodies_.empty() || std::min(from.z, move.z) >= highest_ - limit) return std::nullopt;
    const Segment way = segment_of(from, move);
    const double descent = std::abs(from.z - move.z);
    const int pieces =
        way.length() > 0 ? std::max(1, static_cast<int>(std::ceil(descent / kDescent))) : 1;
    Fault worst{FaultKind::kGouge, limit, {}, 0};
    for (int k = 0; k < pieces; ++k) {
      const double t0 = static_cast<double>(k) / pieces, t1 = static_cast<double>(k + 1) / pieces;
      const double z0 = from.z + t0 * (move.z - from.z), z1 = from.z + t1 * (move.z - from.z);
      // A move straight down is as deep as its end; on a slope the middle stands for a piece.
      const double z = way.length() > 0 ? 0.5 * (z0 + z1) : std::min(z0, z1);
      look(pieces == 1 ? way : way.part(t0, t1), z, worst);
    }
    if (worst.amount <= limit) return std::nullopt;
    return worst;
  }

 private:
  void look(const Segment& way, double z, Fault& worst) const {
    const double radius = 0.5 * tool_.diameter;
    const Bounds box = way.bounds();
    grid_.visit(grown(box, radius), [&](std::size_t item) {
      const Point3& p = bodies_[item];
      // Most points of a cell are too far away, which the move's box tells sooner.
      if (p.z - z <= worst.amount || squared_distance(box, {p.x, p.y}) > radius * radius) return;
      const double depth = depth_in(tool_, way.distance_to({p.x, p.y}), p.z - z);
      if (depth > worst.amount) worst = {FaultKind::kGouge, depth, p, 0};
    });
  }

  const std::vector<Point3>& bodies_;
  ProofTool tool_;
  PointGrid grid_;
  double highest_ = -std::numeric_limits<double>::infinity();
};

// A place under the tool at a move, and how high material stands there.
struct PathPlace {
  Vec2 p;
  double tip = 0;     // mm: z of what is above it
  double height = 0;  // mm: of the material
  Point3 tool;        // where its tip is then
  std::size_t move = 0;
};

class Material {
 public:
  Material(const std::vector<Move>& moves, const ProofTool& tool, const HeightMap& stock,
           const ProofLimits& limits)
      : limits_(limits) {
    for (std::size_t i = 1; i < moves.size(); ++i) ask(moves, i, tool, stock);
    std::vector<Vec2> points;
    for (const PathPlace& place : places_) points.push_back(place.p);
    grid_ = grid_of(points, kCell * 0.5 * tool.diameter);
  }

  bool empty() const { return grid_.size() == 0; }

  // Lowers the material at the places that are still to be looked at to what a move leaves.
  void lower(const Point3& from, const Move& move, const ProofTool& tool) {
    if (move.kind == MoveKind::kRapid) return;
    const Segment way = segment_of(from, move);
    const double radius = 0.5 * tool.diameter, flat = radius - tool.corner_radius;
    grid_.visit(grown(way.bounds(), radius), [&](std::size_t item) {
      PathPlace& place = places_[item];
      const double t = way.length() > 0 ? way.nearest(place.p) : 1.0;
      const auto clear = [&](double at) {
        const double away = distance(way.point(at), place.p);
        if (away > radius) return;
        const double z =
            way.length() > 0 ? from.z + at * (move.z - from.z) : std::min(from.z, move.z);
        place.height = std::min(place.height, away > flat ? z + tool.corner_radius : z);
      };
      clear(t);
      if (from.z != move.z && way.length() > 0) {
        clear(0.0);
        clear(1.0);
      }
    });
  }

  // The fault of a move, whose places are done with then.
  std::optional<Fault> of(std::size_t number, const Move& move) {
    std::optional<Fault> worst;
    for (; next_ < places_.size() && places_[next_].move == number; ++next_) {
      const PathPlace& place = places_[next_];
      grid_.drop_if({place.p, place.p}, [&](std::size_t item) { return item == next_; });
      const double amount = place.height - place.tip;
      if (amount <= limits_.material || (worst && amount <= worst->amount)) continue;
      const bool is_rapid = move.kind == MoveKind::kRapid;
      worst = Fault{is_rapid ? FaultKind::kRapid : FaultKind::kPlunge, amount, place.tool, number};
    }
    return worst;
  }

 private:
  void ask(const std::vector<Move>& moves, std::size_t i, const ProofTool& tool,
           const HeightMap& stock) {
    const Point3 from = end_of(moves[i - 1]);
    const Move& move = moves[i];
    if (std::min(from.z, move.z) >= stock.highest()) return;
    const Segment way = segment_of(from, move);
    const double length = way.length(), descent = from.z - move.z;
    const bool is_steep = descent > kNoDescent && descent > kSteep * length;
    if (move.kind != MoveKind::kRapid && !is_steep) return;
    const double radius = std::max(0.0, 0.5 * tool.diameter - limits_.rim);
    const int steps =
        length > 0 ? static_cast<int>(std::ceil(length / (kWay * 0.5 * tool.diameter))) : 0;
    for (int k = 0; k <= steps; ++k) {
      const double t = steps > 0 ? static_cast<double>(k) / steps : 1.0;
      const double z = steps > 0 ? from.z - t * descent : std::min(from.z, move.z);
      if (z >= stock.highest()) continue;
      const Vec2 centre = way.point(t);
      for (const Ring& ring : kRings) {
        const double share = ring.share * radius;
        const bool on_corner = share > 0.5 * tool.diameter - tool.corner_radius;
        const double tip = on_corner ? z + tool.corner_radius : z;
        for (int n = 0; n < ring.count; ++n) {
          const Vec2 p = centre + share * unit(2 * kPi * n / ring.count);
          const double height = stock.top_at(p);
          if (height > tip + limits_.material)
            places_.push_back({p, tip, height, {centre.x, centre.y, z}, i});
        }
      }
    }
  }

  ProofLimits limits_;
  std::vector<PathPlace> places_;  // in the order of their moves
  PointGrid grid_;                 // of those still to be looked at
  std::size_t next_ = 0;
};

}  // namespace

Segment segment_of(const Point3& from, const Move& m) {
  return m.sweep == 0 ? Segment::line({from.x, from.y}, {m.x, m.y})
                      : Segment::arc({m.cx, m.cy}, distance({m.cx, m.cy}, {from.x, from.y}),
                                     angle_of(Vec2{from.x, from.y} - Vec2{m.cx, m.cy}), m.sweep);
}

std::vector<Fault> faults_of(const std::vector<Move>& moves, const ProofTool& tool,
                             const std::vector<Point3>& bodies, const HeightMap& stock,
                             const std::vector<EarlierPath>& earlier, const ProofLimits& limits) {
  if (!(tool.diameter > 0 && std::isfinite(tool.diameter)))
    throw std::invalid_argument("The tool's diameter must be positive, in mm.");
  std::vector<Fault> faults;
  if (moves.empty()) return faults;
  const Gouges gouges(bodies, tool);
  Material material(moves, tool, stock, limits);
  for (const EarlierPath& path : earlier)
    for (std::size_t i = 1; i < path.moves.size() && !material.empty(); ++i)
      material.lower(end_of(path.moves[i - 1]), path.moves[i], path.tool);
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Point3 from = end_of(moves[i - 1]);
    std::optional<Fault> gouge = gouges.of(from, moves[i], limits.gouge);
    if (gouge) {
      gouge->move = i;
      faults.push_back(*gouge);
    }
    if (const auto fault = material.of(i, moves[i])) faults.push_back(*fault);
    if (!material.empty()) material.lower(from, moves[i], tool);
  }
  return faults;
}

}  // namespace evenload
