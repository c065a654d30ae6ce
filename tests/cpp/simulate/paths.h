// Paths and stocks for the simulator's tests. The stock's top is z = 0, the floor z = -kDepth.
#pragma once

#include <vector>

#include "simulate/simulate.h"

namespace evenload::simulate_paths {

inline constexpr double kDepth = 3;    // mm
inline constexpr double kFeed = 255;   // mm/min
inline constexpr double kFine = 0.05;  // mm: the resolution that users get

Region rectangle(double x0, double y0, double x1, double y1);
Region circle(double radius, Vec2 centre = {});
// A rectangle with a round hole about the origin.
Region plate_with_hole(double half, double radius);
Region turned(const Region& region, double angle);

Move move_to(MoveKind kind, double x, double y, double z);
Move line_to(Vec2 p, double z = -kDepth);
Move arc_to(Vec2 p, Vec2 centre, double sweep, double z = -kDepth);

SimulationParams params_for(double radius);
Simulation run(const std::vector<Move>& moves, const std::vector<Region>& stock,
               const SimulationParams& params, double resolution = kFine);

// The chain of lines at the floor, through the stock. It begins at the floor.
Simulation cut_through(const std::vector<Vec2>& chain, const std::vector<Region>& stock,
                       double radius, double resolution = kFine);
// The same with one region, all turned by `angle` about the origin.
Simulation cut_along(const std::vector<Vec2>& chain, const Region& stock, double angle,
                     double radius, double resolution = kFine);
// Three quarters of a circle of radius `path` in a plate with a hole of radius `rho`, and round a
// disc of that radius, which lies to the right of travel.
Simulation cut_inside_circle(double rho, double path, double radius, double resolution = kFine);
Simulation cut_outside_circle(double rho, double path, double radius, double resolution = kFine);

}  // namespace evenload::simulate_paths
