// The judge of toolpaths: moves a tool through stock and tells what it feels.
//
// Knows nothing of how paths are made. 1. Every move is cut into steps; each step sweeps the
// stock's dexels exactly, lines and arcs alike, so that no step is too long to be seen. 2. Before
// a step is cut, the arcs of the tool's circle that it will cut at its end are found, and from them
// engagement, removal rate, chip thickness and force. 3. The part's geometry tells gouges, the
// dexels what is left. On a slope a step's ground is cut at the higher of its ends, and the ground
// under the tool at its end: depths are exact at samples. Source: [Jacsó 2021, simulation with
// dexels].
#pragma once

#include <optional>
#include <vector>

#include "cutting/force.h"
#include "simulate/dexel_stock.h"
#include "simulate/load_record.h"
#include "support/progress.h"
#include "toolpath/machine_time.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct ForceParams {
  ForceCoefficients coefficients;
  double helix_angle = 0;  // rad
};

struct SimulationParams {
  double tool_diameter = 0;  // mm
  int teeth = 1;
  double spindle_speed = 0;     // rev/min; 0: unknown, so neither chip thickness nor force
  double rapid_feed = 5000;     // mm/min
  double step = 0.1;            // mm of path between two samples at the most
  bool infer_kinds = false;     // moves of G-code: links and entries are told by what they do
  bool find_rest = true;        // false: leaves the figures of the rest at 0
  std::vector<Prism> part;      // must not be cut; to be laid bare
  std::vector<Prism> fixtures;  // must not be touched
  std::optional<ForceParams> force;
  std::optional<MachineProfile> machine;
};

// Runs `moves` on `stock`, which is cut. The first move only says where the tool is.
// Throws std::invalid_argument, with the number of the move, for a tool without diameter, an empty
// path, coordinates that are not finite, feed moves without feed, arcs whose ends lie at different
// distances from their centre, and a part that reaches out of the stock.
Simulation simulate(const std::vector<Move>& moves, DexelStock& stock,
                    const SimulationParams& params, Progress& progress);

// mm, and share of the radius: arcs whose radii differ by more are refused, as controllers do.
inline constexpr double kRadiusMismatch = 0.005;
inline constexpr double kRadiusMismatchShare = 0.001;

}  // namespace evenload
