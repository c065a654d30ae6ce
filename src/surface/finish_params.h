// What a finishing path is to be.
#pragma once

#include <vector>

#include "geometry/vec2.h"
#include "surface/cutter.h"

namespace evenload {

enum class Pattern {
  kZigZag,
  kOneWay,
  kContoursInwards,
  kContoursOutwards,
  kSpiralInwards,
  kSpiralOutwards,
  kBetweenGuides,
  kOneWayBetweenGuides
};

// Whether passes run side by side at an angle.
inline bool is_parallel(Pattern pattern) {
  return pattern == Pattern::kZigZag || pattern == Pattern::kOneWay;
}
inline bool is_spiral(Pattern pattern) {
  return pattern == Pattern::kSpiralInwards || pattern == Pattern::kSpiralOutwards;
}
inline bool is_between_guides(Pattern pattern) {
  return pattern == Pattern::kBetweenGuides || pattern == Pattern::kOneWayBetweenGuides;
}
inline bool is_one_way(Pattern pattern) {
  return pattern == Pattern::kOneWay || pattern == Pattern::kOneWayBetweenGuides;
}
// Whether each pass goes back the other way from the one before.
inline bool is_to_and_fro(Pattern pattern) {
  return pattern == Pattern::kZigZag || pattern == Pattern::kBetweenGuides;
}

// More passes are a slip of the pen, and would take days.
inline constexpr double kMostPasses = 200000;

struct FinishParams {
  Cutter cutter;
  Pattern pattern = Pattern::kZigZag;
  double angle = 0;     // rad: of the passes against the x axis
  double stepover = 0;  // mm, > 0: between neighbouring passes, in plan
  // mm: what may stand between two passes, across the surface, which the distance of the passes
  // follows then; 0: the stepover stays the same.
  double cusp_height = 0;
  bool by_contact = true;  // what stays on the picked faces: the tool's contact, or its axis
  double allowance = 0;    // mm, >= 0: stays on the part
  double extension = 0;    // mm, >= 0: how far passes go on beyond the picked faces, in plan
  double lead_radius = 0;  // mm, >= 0: of the upright arcs from and into the air
  // Two open lines in plan, mm, for passes between guides.
  std::vector<std::vector<Vec2>> guides;
  double fixture_clearance = 0;  // mm, >= 0: between the tool and fixtures
  double tolerance = 0.01;       // mm, > 0: of the path against the triangles, see finish.h
  double floor = 0;              // mm: the tip never goes lower
  double top = 0;                // mm: nothing stands higher, so rapids may come down to it
  double safe_height = 0, clearance_height = 0;      // mm, of rapids
  double feed = 0, plunge_feed = 0, rapid_feed = 0;  // mm/min
  bool is_climb = true;
  bool arcs = true;  // false: lines only, also round about
  int threads = 0;   // 0: as many as there are cores
};

}  // namespace evenload
