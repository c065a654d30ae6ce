// What no path may do: cut into a body, or come down into material by a rapid or a plunge.
//
// Knows neither how paths are made nor regions: bodies are points of their surface, stock is a
// height over the plane, and the tool is looked at move by move.
// 1. Gouges. A point of a body lies inside of what the tool sweeps, or not: the depth is exact at
//    the points. Those of edges, and of sections at the path's levels, see every wall.
// 2. Material. Places under the tool, in rings, are asked for at each rapid and each plunge below
//    the stock's top. What stands there is the height of the stock, lowered by every move that came
//    over the place before.
// Laws: a path that keeps off the points and the stock has no faults; turned, moved and mirrored
// with them it has the same. A tool with round corners clears its flat to its tip, and all of its
// disc a corner higher. Source: none; the questions are those of [Jacsó 2021, simulation].
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/curve.h"
#include "simulate/height_map.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct ProofTool {
  double diameter = 0;       // mm
  double corner_radius = 0;  // mm, 0 for a sharp corner
};

// What has been cut before, in its order.
struct EarlierPath {
  std::vector<Move> moves;  // the first says where the tool is
  ProofTool tool;
};

struct ProofLimits {
  double gouge = 0.015;    // mm into a body that are none yet
  double material = 0.02;  // mm of material under the tool that are none yet
  double rim = 0.02;       // mm of the tool's rim that may touch what stands
};

// A move as a piece of the plane, from where it begins.
Segment segment_of(const Point3& from, const Move& move);

enum class FaultKind { kGouge, kRapid, kPlunge };

struct Fault {
  FaultKind kind = FaultKind::kGouge;
  double amount = 0;     // mm: depth of the gouge, height of the material
  Point3 at;             // of the body; or of the tool's tip
  std::size_t move = 0;  // its number
};

// The faults of a path, the worst of each move and kind, in the path's order. The first of `moves`
// says where the tool is.
std::vector<Fault> faults_of(const std::vector<Move>& moves, const ProofTool& tool,
                             const std::vector<Point3>& bodies, const HeightMap& stock,
                             const std::vector<EarlierPath>& earlier,
                             const ProofLimits& limits = {});

}  // namespace evenload
