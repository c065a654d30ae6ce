// What a finishing path is to be.
#pragma once

#include "surface/cutter.h"

namespace evenload {

enum class Pattern { kZigZag, kOneWay, kContoursInwards, kContoursOutwards };

// Whether passes run along the outline of what is picked, and not side by side.
inline bool is_along_outline(Pattern pattern) {
  return pattern == Pattern::kContoursInwards || pattern == Pattern::kContoursOutwards;
}

struct FinishParams {
  Cutter cutter;
  Pattern pattern = Pattern::kZigZag;
  double angle = 0;     // rad: of the passes against the x axis
  double stepover = 0;  // mm, > 0: between neighbouring passes, in plan
  // mm: what may stand between two passes, across the surface, which the distance of the passes
  // follows then; 0: the stepover stays the same.
  double cusp_height = 0;
  bool by_contact = true;   // what stays on the picked faces: the tool's contact, or its axis
  double allowance = 0;     // mm, >= 0: stays on the part
  double tolerance = 0.01;  // mm, > 0: of the path against the triangles, see finish.h
  double floor = 0;         // mm: the tip never goes lower
  double top = 0;           // mm: nothing stands higher, so rapids may come down to it
  double safe_height = 0, clearance_height = 0;      // mm, of rapids
  double feed = 0, plunge_feed = 0, rapid_feed = 0;  // mm/min
  bool is_climb = true;
  int threads = 0;  // 0: as many as there are cores
};

}  // namespace evenload
