#include "dynamics/chart.h"

#include <algorithm>
#include <cmath>

#include "dynamics/mdbm_curves.h"
#include "support/parallel.h"

namespace evenload {

namespace {

constexpr std::size_t kStretch = 24;  // points of a curve that are described from few
constexpr double kAlike = 0.02;       // of chatter frequencies: nearer ones are interpolated

MdbmProblem problem_of(const Milling& milling, MdbmAxis speeds, MdbmAxis depths, int threads) {
  check(milling);
  check_speed_and_depth(speeds.low, depths.low);
  return {{speeds, depths},
          1,
          false,
          [milling](const double* at, double* value) {
            const PeriodicSystem system = milling_system(milling, at[0], at[1]);
            *value = std::abs(multipliers(system, kChartAccuracy).front()) - 1;
          },
          threads};
}

void describe_point(const Milling& milling, std::size_t i, StabilityChart::Curve& curve) {
  const PeriodicSystem system = milling_system(milling, curve.speeds[i], curve.depths[i]);
  const Vibration vibration = strongest_vibration(system, kChartAccuracy);
  curve.kinds[i] = kind_of(vibration.multiplier);
  curve.chatter_frequencies[i] = vibration.frequency;
}

// Kinds and frequencies from `first` to `last`: those between follow from the ends where these are
// alike, else from the middle's.
void describe(const Milling& milling, std::size_t first, std::size_t last,
              StabilityChart::Curve& curve) {
  describe_point(milling, first, curve);
  if (last == first) return;
  describe_point(milling, last, curve);
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [low, high] = open.back();
    open.pop_back();
    if (high - low < 2) continue;
    const double at_low = curve.chatter_frequencies[low], at_high = curve.chatter_frequencies[high];
    if (curve.kinds[low] == curve.kinds[high] &&
        std::abs(at_high - at_low) < kAlike * std::max(at_low, at_high)) {
      for (std::size_t i = low + 1; i < high; ++i) {
        const double share = static_cast<double>(i - low) / static_cast<double>(high - low);
        curve.kinds[i] = curve.kinds[low];
        curve.chatter_frequencies[i] = at_low + share * (at_high - at_low);
      }
      continue;
    }
    const std::size_t middle = (low + high) / 2;
    describe_point(milling, middle, curve);
    open.emplace_back(low, middle);
    open.emplace_back(middle, high);
  }
}

}  // namespace

StabilityChart::StabilityChart(const Milling& milling, MdbmAxis speeds, MdbmAxis depths,
                               int threads)
    : milling_(milling),
      threads_(thread_count(threads)),
      mdbm_(problem_of(milling, speeds, depths, threads_)) {}

std::vector<StabilityChart::Curve> StabilityChart::curves(Progress& progress) const {
  struct Stretch {
    std::size_t curve, first, last;
  };
  std::vector<Curve> result;
  std::vector<Stretch> stretches;  // of all curves: short ones would leave threads without work
  for (const std::vector<double>& line : evenload::curves(mdbm_)) {
    const std::size_t count = line.size() / 2;
    for (std::size_t first = 0; first < count; first += kStretch)
      stretches.push_back({result.size(), first, std::min(first + kStretch, count) - 1});
    Curve curve;
    curve.kinds.resize(count);
    curve.chatter_frequencies.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      curve.speeds.push_back(line[2 * i]);
      curve.depths.push_back(line[2 * i + 1]);
    }
    result.push_back(std::move(curve));
  }
  parallel_for(
      stretches.size(), threads_,
      [&](std::size_t number) {
        const Stretch& at = stretches[number];
        describe(milling_, at.first, at.last, result[at.curve]);
      },
      progress);
  return result;
}

std::vector<double> spectral_radii(const Milling& milling, const std::vector<double>& speeds,
                                   const std::vector<double>& depths, double accuracy, int threads,
                                   Progress& progress) {
  check(milling);
  std::vector<double> result(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) check_speed_and_depth(speeds[i], depths[i]);
  parallel_for(
      speeds.size(), thread_count(threads),
      [&](std::size_t i) {
        const PeriodicSystem system = milling_system(milling, speeds[i], depths[i]);
        result[i] = std::abs(multipliers(system, accuracy).front());
      },
      progress);
  return result;
}

}  // namespace evenload
