#include "simulate/paths.h"

#include <cmath>

namespace evenload::simulate_paths {
namespace {

Curve circle_curve(double radius, Vec2 centre) {
  return Curve({{centre + Vec2{radius, 0}, 1}, {centre - Vec2{radius, 0}, 1}}, true);
}

Simulation cut_on_circle(const Region& stock, double path, double radius, double sweep,
                         double resolution) {
  const double start = 0.1;  // rad
  const Vec2 from = path * unit(start), to = path * unit(start + sweep);
  Move first = line_to(from);
  return run({first, arc_to(to, {}, sweep)}, {stock}, params_for(radius), resolution);
}

}  // namespace

Region rectangle(double x0, double y0, double x1, double y1) {
  return make_region(Curve({{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, true));
}

Region circle(double radius, Vec2 centre) { return make_region(circle_curve(radius, centre)); }

Region plate_with_hole(double half, double radius) {
  // Not quite in the middle, so that the dexels do not lie alike on both sides of the hole.
  return make_region(rectangle(-half, -half, half + 0.137, half + 0.211).outer,
                     {circle_curve(radius, {})});
}

Region turned(const Region& region, double angle) {
  const auto turn = [&](const Curve& curve) {
    std::vector<Vertex> vertices = curve.vertices();
    for (Vertex& v : vertices) v.p = rotated(v.p, angle);
    return Curve(vertices, true);
  };
  std::vector<Curve> islands;
  for (const Curve& island : region.islands) islands.push_back(turn(island));
  return make_region(turn(region.outer), islands);
}

Move move_to(MoveKind kind, double x, double y, double z) {
  Move m;
  m.kind = kind;
  m.x = x;
  m.y = y;
  m.z = z;
  m.feed = kind == MoveKind::kRapid ? 0 : kFeed;
  return m;
}

Move line_to(Vec2 p, double z) { return move_to(MoveKind::kCut, p.x, p.y, z); }

Move arc_to(Vec2 p, Vec2 centre, double sweep, double z) {
  Move m = line_to(p, z);
  m.cx = centre.x;
  m.cy = centre.y;
  m.sweep = sweep;
  return m;
}

SimulationParams params_for(double radius) {
  SimulationParams params;
  params.tool_diameter = 2 * radius;
  params.teeth = 1;
  params.spindle_speed = 6366;
  return params;
}

Simulation run(const std::vector<Move>& moves, const std::vector<Region>& stock,
               const SimulationParams& params, double resolution) {
  std::vector<Prism> prisms;
  for (const Region& region : stock) prisms.push_back({region, 0});
  DexelStock dexels(prisms, -kDepth, resolution);
  Progress progress;
  return simulate(moves, dexels, params, progress);
}

Simulation cut_through(const std::vector<Vec2>& chain, const std::vector<Region>& stock,
                       double radius, double resolution) {
  std::vector<Move> moves;
  for (const Vec2 p : chain) moves.push_back(line_to(p));
  return run(moves, stock, params_for(radius), resolution);
}

Simulation cut_along(const std::vector<Vec2>& chain, const Region& stock, double angle,
                     double radius, double resolution) {
  std::vector<Vec2> points;
  for (const Vec2 p : chain) points.push_back(rotated(p, angle));
  return cut_through(points, {turned(stock, angle)}, radius, resolution);
}

Simulation cut_inside_circle(double rho, double path, double radius, double resolution) {
  const double half = rho + 2 * radius + 2;
  return cut_on_circle(plate_with_hole(half, rho), path, radius, -1.5 * kPi, resolution);
}

Simulation cut_outside_circle(double rho, double path, double radius, double resolution) {
  return cut_on_circle(circle(rho), path, radius, -1.5 * kPi, resolution);
}

}  // namespace evenload::simulate_paths
