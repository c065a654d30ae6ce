// The corpus of pockets in tests/corpus: one JSON file each, mm, mm/min and degrees.
//
// `outer` and each of `islands` are closed chains of [x, y, bulge], `hole` = [x, y, diameter] is
// pre-drilled, `open` says that the outer boundary is the edge of the stock. The stock's top is z =
// 0, the floor z = -axial_depth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/region.h"
#include "strategy/task/clearing_params.h"

namespace evenload::corpus {

struct Hole {
  Vec2 centre;
  double diameter = 0;  // mm
};

struct Case {
  std::string name;
  double tool_diameter = 0;     // mm
  double engagement_angle = 0;  // rad
  double axial_depth = 0;       // mm
  double feed = 0, link_feed = 0, maximum_feed = 0;
  double roll_radius = 0;  // mm
  Region region;           // vertices of the outer boundary are marked where it is open
  std::optional<Hole> hole;

  // Climb, constant removal rate, one level.
  ClearingParams params() const;
};

// The names of all cases, in order.
std::vector<std::string> names();
// Those whose tool fits.
std::vector<std::string> clearable();
// Throws std::runtime_error for a name that does not exist.
Case load(const std::string& name);
// The case turned by `angle` rad, mirrored first if so wanted, and shifted.
Case moved(const Case& original, double angle, bool mirrored, Vec2 shift);

}  // namespace evenload::corpus
