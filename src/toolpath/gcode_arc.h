// The arcs of G2 and G3 in their plane, made exact: posts round centres and radii.
//
// An arc goes from `start` by `sweep` about `centre`, its radius changing evenly from `from_radius`
// to `to_radius`, which differ by rounding only. Its pieces are true arcs.
#pragma once

#include <vector>

#include "geometry/vec2.h"

namespace evenload {

struct GCodeArc {
  Vec2 start, end, centre;                // mm; `start` first, `end` last exactly
  double from_radius = 0, to_radius = 0;  // mm
  double sweep = 0;                       // rad, signed, not 0
  double length() const;
  // At t of the sweep, 0 <= t <= 1.
  Vec2 point(double t) const;
};

// By its centre (I, J, K). Equal ends make a full turn; `turns` counts it. Throws GCodeError with
// `line` if the radius is 0, or if the two radii disagree by more than LinuxCNC and grbl allow.
GCodeArc arc_by_centre(Vec2 start, Vec2 end, Vec2 centre, bool counter_clockwise, int turns,
                       int line);
// By its radius (R), below 0 the way of more than half a turn. Throws GCodeError with `line` if the
// radius is 0, the ends are the same or too far apart.
GCodeArc arc_by_radius(Vec2 start, Vec2 end, double radius, bool counter_clockwise, int turns,
                       int line);

struct ArcPiece {
  Vec2 end, centre;  // mm
  double sweep = 0;  // rad, at most half a turn
  double share = 0;  // of the arc's sweep up to `end`
};
// In order, equal sweeps. Law: the ends of each piece are equally far from its centre, to 1e-9 mm
// for radii up to 1 m, and a turn by its sweep about the centre takes the one to the other.
std::vector<ArcPiece> pieces_of(const GCodeArc& arc);

// How many equal chords keep within `tolerance` mm of the arc.
double chords_of(const GCodeArc& arc, double tolerance);

}  // namespace evenload
