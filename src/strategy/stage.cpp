#include "strategy/stage.h"

#include <utility>

#include "support/errors.h"

namespace evenload {
namespace {

// Each stage turns this much more tightly than the one before: small enough that what a stage
// leaves in a corner is one pass for the next, large enough that a channel of any width finds a
// stage that uses most of it.
constexpr double kStageRatio = 0.6;

// The walls are opened by this much more than the turn radius, so that a pass in the narrowest
// channel of its stage still has room between its roll-in and its roll-out.
constexpr double kOpeningRatio = 1.25;

}  // namespace

std::vector<Stage> make_stages(const Region& centres, const StageLimits& limits) {
  EVENLOAD_ASSERT(limits.tightest > 0 && limits.tightest <= limits.widest);
  std::vector<Stage> stages;
  for (double turn = limits.widest; turn > limits.tightest * kStageRatio; turn *= kStageRatio) {
    const double opening = kOpeningRatio * turn;
    const std::vector<Region> eroded = offset({centres}, -opening);
    if (eroded.empty()) continue;
    Stage stage;
    stage.turn_radius = turn;
    stage.centres = Area(offset(eroded, opening));
    stage.turns = Area(offset(eroded, opening - turn));
    stages.push_back(std::move(stage));
  }
  Stage exact;
  exact.centres = Area({centres});
  stages.push_back(std::move(exact));
  return stages;
}

}  // namespace evenload
