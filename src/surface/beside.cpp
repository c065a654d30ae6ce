#include "surface/beside.h"

#include <cmath>

namespace evenload {

namespace {

constexpr double kScan = 0.25;      // of the level step
constexpr double kExactly = 0.001;  // mm
constexpr double kAlong = 0.25;     // mm to both sides, between which the feed's slope is found

}  // namespace

std::optional<double> StepBeside::from(Vec2 at, Vec2 across, double guess) const {
  if (!strip_of(at, across, guess)) return std::nullopt;
  return rule_.widest(guess, [&](double width) {
    const std::optional<Strip> strip = strip_of(at, across, width);
    if (!strip) return CuspRule::kNothing;
    const PlanLine feed{strip->at, -left_normal(across)};
    const DropSample before = sample_at(ground_, feed, -kAlong, strip->middle.facet);
    const DropSample after = sample_at(ground_, feed, kAlong, strip->middle.facet);
    const double slope =
        before.is_at_work && after.is_at_work ? (after.z - before.z) / (2 * kAlong) : 0;
    return rule_.height(width, strip->wide, strip->one.z, strip->middle.z, strip->other.z, slope);
  });
}

double StepBeside::reach_beyond(Vec2 at, Vec2 outwards, Progress& progress) const {
  if (!ground_.by_contact) return 0;
  const PlanLine line{at, outwards};
  const double reach = ground_.cutter.radius + ground_.allowance, step = kScan * level();
  for (double s = reach; s > -reach; s -= step) {
    progress.step();
    if (!sample_at(ground_, line, s).is_at_work) continue;
    double within = s, beyond = s + step;
    while (beyond - within > kExactly) {
      const double middle = 0.5 * (within + beyond);
      (sample_at(ground_, line, middle).is_at_work ? within : beyond) = middle;
    }
    return within;
  }
  return 0;
}

// The ground beyond the picked faces tells nothing: beside their border the strip is moved inwards,
// or made no wider than it must be.
std::optional<StepBeside::Strip> StepBeside::strip_of(Vec2 at, Vec2 across, double width) const {
  const PlanLine line{at, across};
  const double wide = rule_.strip_for(width, HUGE_VAL);
  for (const auto& [middle, size] : {std::pair{0.5 * width, wide},
                                     {0.5 * wide, wide},
                                     {width - 0.5 * wide, wide},
                                     {0.5 * width, width},
                                     {0.5 * width, 0.5 * width}}) {
    Strip strip;
    strip.middle = sample_at(ground_, line, middle);
    if (!strip.middle.is_at_work) continue;
    strip.one = sample_at(ground_, line, middle - 0.5 * size, strip.middle.facet);
    strip.other = sample_at(ground_, line, middle + 0.5 * size, strip.middle.facet);
    strip.at = line.at(middle);
    strip.wide = size;
    if (strip.one.is_at_work && strip.other.is_at_work) return strip;
  }
  return std::nullopt;
}

}  // namespace evenload
