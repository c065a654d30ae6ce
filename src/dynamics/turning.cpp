#include "dynamics/turning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/complex.h"
#include "support/demand.h"

namespace evenload {

namespace {

constexpr double kLowest = 0.3, kHighest = 4;  // of the natural frequency, where limits are sought
constexpr int kLooksPerLobe = 48;
constexpr int kLeastLooks = 4000;
constexpr int kBisections = 60;

}  // namespace

Complex flank_area(const TurningCut& cut, double speed, double w, FlankOrder order) {
  const double v = 0.5 * cut.diameter * speed, length = cut.flank_length;
  switch (order) {
    case FlankOrder::kNone:
      return 0;
    case FlankOrder::kFirst:
      return kI * w * length * length / (2 * v);
    case FlankOrder::kSecond:
      return kI * w * length * length / (2 * v) + w * w * length * length * length / (6 * v * v);
    case FlankOrder::kExact:
      break;
  }
  const double time = length / v;
  return v * (time - (1.0 - std::exp(-kI * w * time)) / (kI * w));
}

std::vector<double> interrupted_turning_speeds(double slot, double frequency, double damping_ratio,
                                               double enter, double exit, int count) {
  demand(std::isfinite(slot) && slot > 0, "The slot's width must be above 0 mm.");
  demand(std::isfinite(frequency) && frequency > 0, "The frequency must be above 0 Hz.");
  demand(damping_ratio >= 0 && damping_ratio < 1,
         "The damping ratio must not be negative, and below 1.");
  demand(std::isfinite(enter) && enter >= 0 && std::isfinite(exit) && exit >= 0,
         "The smoothing at entry and exit must not be negative.");
  demand(count >= 1, "At least one speed must be asked for.");
  const double damped = std::sqrt(1 - damping_ratio * damping_ratio);
  const double shift = std::atan2(damped * exit, 1 + damping_ratio * exit) +
                       std::atan2(damped * enter, 1 - damping_ratio * enter);
  std::vector<double> result;
  for (int j = 1; j <= count; ++j)
    result.push_back(slot * frequency * damped / (2 * M_PI * j - shift));
  return result;
}

// 1/b = -Phi(w) (K (1 - exp(-i w tau)) + Ksp A/y), real and above 0.
TurningLimit turning_limit(const TurningCut& cut, double speed, FlankOrder order) {
  check_modes({cut.mode});
  demand(cut.cutting_coefficient > 0, "The cutting coefficient must be above 0 N/mm^2.");
  demand(cut.flank_coefficient >= 0 && cut.flank_length >= 0,
         "The flank's coefficient and length must not be negative.");
  demand(cut.diameter > 0, "The work's diameter must be above 0 mm.");
  demand(std::isfinite(speed) && speed > 0, "The spindle speed must be above 0 rev/min.");
  const double period = 2 * M_PI / speed;
  const auto inverse = [&](double w) {
    return -receptance(cut.mode, w) *
           (cut.cutting_coefficient * (1.0 - std::exp(-kI * w * period)) +
            cut.flank_coefficient * flank_area(cut, speed, w, order));
  };
  const double low = kLowest * cut.mode.frequency, high = kHighest * cut.mode.frequency;
  const int looks = std::max(kLeastLooks, static_cast<int>(kLooksPerLobe * (high - low) / speed));
  TurningLimit result{std::numeric_limits<double>::infinity(), 0};
  double before = low;
  Complex at_before = inverse(low);
  for (int i = 1; i <= looks; ++i) {
    const double here = low + (high - low) * i / looks;
    const Complex at_here = inverse(here);
    if ((at_before.imag() > 0) != (at_here.imag() > 0)) {
      double a = before, b = here;
      for (int n = 0; n < kBisections; ++n) {
        const double middle = 0.5 * (a + b);
        ((inverse(middle).imag() > 0) == (at_before.imag() > 0) ? a : b) = middle;
      }
      const double value = inverse(a).real();
      if (value > 0 && 1 / value < result.width) result = {1 / value, a};
    }
    before = here;
    at_before = at_here;
  }
  return result;
}

}  // namespace evenload
