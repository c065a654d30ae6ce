#include "ball_end/chips.h"

#include <stdexcept>

#include "support/parallel.h"

namespace evenload {

namespace {

Chip chip_on(const PartProfile& profile, Steps steps, const WantedChip& wanted) {
  const ExtrudedSurface surface(profile, wanted.task.ball_radius, steps);
  if (!(wanted.y >= surface.lowest() && wanted.y <= surface.highest()))
    throw std::invalid_argument(
        "The position lies beyond the surface: give the tool's ordinate in mm from its middle.");
  return chip(surface, {0, surface.step_coordinate(wanted.y)}, wanted.task);
}

Chip chip_on(const BentPlace& place, Steps steps, const WantedChip& wanted) {
  return chip(BentSurface(place, wanted.task.ball_radius, steps), {}, wanted.task);
}

}  // namespace

std::vector<Chip> chips(const std::vector<Worked>& surfaces, Steps steps,
                        const std::vector<WantedChip>& wanted, int threads, Progress& progress) {
  std::vector<Chip> result(wanted.size());
  const auto work = [&](std::size_t i) {
    check(wanted[i].task);
    result[i] = std::visit([&](const auto& worked) { return chip_on(worked, steps, wanted[i]); },
                           surfaces.at(wanted[i].worked));
  };
  parallel_for(wanted.size(), thread_count(threads), work, progress);
  return result;
}

}  // namespace evenload
