#include "simulate/wall_contact.h"

#include <algorithm>

namespace evenload {
namespace {

// rad to either side of the direction across the feed in which a wall is looked for: feeds along
// arcs are known to a few degrees.
constexpr double kWindow = 15 * kPi / 180;

}  // namespace

std::vector<char> stands_beside(const DexelStock& stock, const std::vector<ToolCircle>& tools) {
  std::vector<char> stands;
  stands.reserve(tools.size());
  std::vector<EngagedArc> arcs;
  const auto stands_at = [&](const ToolCircle& beside, double side) {
    find_engaged_arcs(stock, beside, side - kWindow, side + kWindow, arcs);
    return std::any_of(arcs.begin(), arcs.end(),
                       [](const EngagedArc& arc) { return arc.depth > kLeastWall; });
  };
  for (const ToolCircle& tool : tools) {
    ToolCircle beside = tool;
    beside.radius += 2 * stock.resolution();
    stands.push_back(stands_at(beside, kPi / 2) || stands_at(beside, -kPi / 2));
  }
  return stands;
}

}  // namespace evenload
