// The engagement along a finished toolpath, for pictures.
#pragma once

#include <optional>
#include <vector>

#include "geometry/region.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct ProfilePoint {
  Vec2 p;
  double engagement = 0;  // rad
  MoveKind kind = MoveKind::kCut;
};

struct Hole {
  Vec2 centre;
  double diameter = 0;  // mm
};

// Points every 0.1 mm along the moves of the lowest level, with the engagement there.
std::vector<ProfilePoint> engagement_profile(const std::vector<Region>& regions,
                                             const Toolpath& path, double tool_diameter,
                                             const std::optional<Hole>& hole);

}  // namespace evenload
