// What a tool with a rounded end, upright, sweeps along a piece of its path, seen from below.
//
// Laws: over any place the underside is the least that the tip's height plus the tool's rise takes
// along the piece. Along a line the rise is a convex function, so that this is one minimum: in
// closed form for balls, flat ends and on the level, else by bracketed secants to kAlongShare of
// the radius, in which an error counts squared. On a level arc it is where the arc comes nearest.
// Helices are lines within kSagitta. With a pitch the tool is only where a tooth stands in its
// deepest place: the underside is that of the nearest two such places.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/curve.h"
#include "simulate/height_map.h"
#include "surface/cutter.h"
#include "toolpath/toolpath.h"

namespace evenload {

// A piece of a tip's way: a line that may rise or fall, or a level arc of a quarter turn at most.
struct CutterRun {
  Segment path;
  double z0 = 0, z1 = 0;  // mm
  double begin = 0;       // mm of the whole path up to here
  double length = 0;      // mm along the piece
  // mm along the piece to its first tooth, and from there to the next; 0: cuts all along
  double first = 0, pitch = 0;
  std::int32_t move = 0;  // its number
};

struct Underside {
  double z = HUGE_VAL;  // mm; infinite where the tool does not reach
  double along = 0;     // mm along the piece, of the tip
};

Underside underside(const Cutter& cutter, const CutterRun& run, Vec2 at);

// The pieces of a path, whose first move only says where the tool is. teeth_per_minute: teeth that
// pass a place, which cut one after the other, all alike; 0: the tool cuts all along.
std::vector<CutterRun> cutter_runs(const std::vector<Move>& moves, double teeth_per_minute);

inline constexpr double kAlongShare = 1e-7;
inline constexpr double kSagitta = 1e-4;  // mm: of lines that stand for a helix

}  // namespace evenload
