#include "strategy/task/mirror.h"

namespace evenload {

Vec2 mirrored(Vec2 p) { return {-p.x, p.y}; }

namespace {

Curve mirrored(const Curve& curve) {
  // Reversed as well, so that the sense of rotation stays.
  std::vector<Vertex> vertices;
  const std::vector<Vertex>& in = curve.vertices();
  const std::size_t n = in.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vertex& at = in[(n - i) % n];
    const Vertex& piece = in[(2 * n - i - 1) % n];
    // Reversing turns a left arc into a right one, and mirroring turns it back.
    vertices.push_back({mirrored(at.p), piece.bulge, piece.open});
  }
  return Curve(std::move(vertices), true);
}

}  // namespace

std::vector<Region> mirrored(const std::vector<Region>& regions) {
  std::vector<Region> result;
  for (const Region& region : regions) {
    Region r;
    r.outer = mirrored(region.outer);
    for (const Curve& island : region.islands) r.islands.push_back(mirrored(island));
    result.push_back(std::move(r));
  }
  return result;
}

void mirror_run(PlanarRun& run) {
  run.descent.at = mirrored(run.descent.at);
  run.descent.centre = mirrored(run.descent.centre);
  run.descent.stretch = mirrored(run.descent.stretch);
  for (Vec2& place : run.descent.ramp_by) place = mirrored(place);
  for (PlanarMove& move : run.moves) {
    const Segment& s = move.segment;
    move.segment = s.is_arc()
                       ? Segment::arc(mirrored(s.centre), s.radius, kPi - s.start_angle, -s.sweep)
                       : Segment::line(mirrored(s.a), mirrored(s.b));
  }
}

}  // namespace evenload
