#include "surface/spiral.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/demand.h"
#include "support/parallel.h"
#include "surface/contours_by_cusp.h"

namespace evenload {

namespace {

constexpr double kWidestStep = kPi / 8;  // rad between corners, in the middle
constexpr std::size_t kRays = 360;       // on which a spiral by cusps is found
constexpr std::size_t kSmoothed = 2;     // rays to both sides, the least of whose steps counts

// How far the outermost place that has to be met lies from a middle, mm.
double farthest(const std::vector<Region>& regions, Vec2 middle) {
  double result = 0;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves())
      for (const Vec2 p : curve.flattened(kChords)) result = std::max(result, norm(p - middle));
  return result;
}

Vec2 middle_of(const std::vector<Region>& regions) {
  const Bounds bounds = bounds_of(regions);
  return 0.5 * (bounds.low + bounds.high);
}

double reach_of(const Ground& ground) {
  return ground.by_contact ? ground.cutter.radius + ground.allowance : 0;
}

// The radii of a spiral outwards on rays that follow each other, turn by turn.
class CuspSpiral {
 public:
  CuspSpiral(Vec2 middle, const StepBeside& beside, double sense, int threads)
      : middle_(middle), beside_(beside), sense_(sense), threads_(thread_count(threads)) {
    const double first = beside.from(middle, {1, 0}, beside.level()).value_or(beside.level());
    for (std::size_t k = 0; k <= kRays; ++k)
      radii_.push_back(first * static_cast<double>(k) / kRays);
  }

  double radius(std::size_t ray) const { return radii_[ray]; }
  std::size_t turns() const { return (radii_.size() - 1) / kRays; }
  double angle(std::size_t ray) const {
    return sense_ * 2 * kPi * static_cast<double>(ray % kRays) / kRays;
  }
  double least() const { return least_; }
  double largest() const { return largest_; }

  // How near the last turn comes to the middle.
  double inner() const { return *std::min_element(radii_.end() - kRays, radii_.end()); }

  // Throws Cancelled.
  void add_turn(Progress& progress) {
    const std::size_t begin = radii_.size() - 1 - kRays;
    const double apart = radii_.back() * 2 * kPi / kRays;
    const auto stride = std::clamp<std::size_t>(
        static_cast<std::size_t>(kStationsApart / std::max(apart, 1e-9)), 1, kRays / 8);
    std::vector<std::optional<double>> found((kRays + stride - 1) / stride);
    Progress asking = part_of(progress);
    parallel_for(
        found.size(), threads_, [&](std::size_t k) { found[k] = step_at(begin + 1 + k * stride); },
        asking);
    std::vector<double> steps(kRays);
    for (std::size_t k = 0; k < kRays; ++k) {
      const std::size_t i = k / stride, next = std::min(i + 1, found.size() - 1);
      const double share = static_cast<double>(k % stride) / static_cast<double>(stride);
      steps[k] = (1 - share) * found[i].value_or(beside_.level()) +
                 share * found[next].value_or(beside_.level());
    }
    for (const std::optional<double>& step : found) {
      if (!step) continue;
      largest_ = std::max(largest_, *step);
      least_ = least_ == 0 ? *step : std::min(least_, *step);
    }
    for (std::size_t k = 0; k < kRays; ++k) {
      double least = steps[k];
      for (std::size_t i = k + kRays - kSmoothed; i <= k + kRays + kSmoothed; ++i)
        least = std::min(least, steps[i % kRays]);
      radii_.push_back(radii_[begin + 1 + k] + least);
    }
  }

 private:
  // Along the ray: a turn that leans against it lies nearer than it might.
  std::optional<double> step_at(std::size_t ray) const {
    const Vec2 out = unit(angle(ray));
    return beside_.from(middle_ + radii_[ray] * out, out, beside_.level());
  }

  Vec2 middle_;
  const StepBeside& beside_;
  double sense_;
  int threads_;
  std::vector<double> radii_;
  double least_ = 0, largest_ = 0;
};

}  // namespace

std::vector<std::vector<Polyline>> spiral_rows(const Ground& ground,
                                               const std::vector<Region>& regions, double stepover,
                                               bool is_outwards, bool is_clockwise) {
  const Vec2 middle = middle_of(regions);
  const double far = farthest(regions, middle) + reach_of(ground);
  const auto turns = static_cast<std::size_t>(std::ceil(far / stepover)) + 1;
  const double sense = is_outwards == is_clockwise ? -1 : 1;  // of growing angles, from the middle
  std::vector<std::vector<Polyline>> rows(turns);
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const double outer = stepover * static_cast<double>(turn + 1);
    const double step = std::min(kWidestStep, 2 * std::acos(std::max(0.0, 1 - kChords / outer)));
    const auto count = static_cast<std::size_t>(std::ceil(2 * kPi / step));
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count);
      const double radius = stepover * (static_cast<double>(turn) + share);
      const double angle = sense * 2 * kPi * share;
      corners.push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    // A turn ends to the last bit where the next one begins.
    corners.front() = middle + Vec2{stepover * static_cast<double>(turn), 0};
    corners.back() = middle + Vec2{outer, 0};
    if (!is_outwards) std::reverse(corners.begin(), corners.end());
    rows[is_outwards ? turn : turns - 1 - turn].push_back({std::move(corners), false});
  }
  return rows;
}

SpiralByCusp spiral_by_cusp(const Ground& ground, const std::vector<Region>& regions,
                            const StepBeside& beside, bool is_outwards, bool is_clockwise,
                            int threads, Progress& progress) {
  const Vec2 middle = middle_of(regions);
  const double far = farthest(regions, middle) + reach_of(ground);
  CuspSpiral spiral(middle, beside, is_outwards == is_clockwise ? -1 : 1, threads);
  while (spiral.inner() < far) {
    demand(static_cast<double>(spiral.turns()) < kMostPasses,
           "The cusp height makes too many passes: raise it.");
    progress.step();
    spiral.add_turn(progress);
  }
  SpiralByCusp result{{}, spiral.least(), spiral.largest()};
  for (std::size_t turn = 0; turn < spiral.turns(); ++turn) {
    std::vector<Vec2> corners;
    for (std::size_t k = turn * kRays; k < (turn + 1) * kRays; ++k) {
      const double sense = spiral.angle(1) / std::abs(spiral.angle(1));
      const double chord = 2 * std::acos(std::max(0.0, 1 - kChords / (spiral.radius(k + 1))));
      const int count = std::max(1, static_cast<int>(std::ceil(2 * kPi / kRays / chord)));
      for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / count;
        const double radius = (1 - share) * spiral.radius(k) + share * spiral.radius(k + 1);
        corners.push_back(middle +
                          radius * unit(spiral.angle(k) + sense * share * 2 * kPi / kRays));
      }
    }
    // To the last bit where the next one begins.
    corners.push_back(middle + Vec2{spiral.radius((turn + 1) * kRays), 0});
    result.turns.push_back({{std::move(corners), false}});
  }
  for (std::vector<Polyline>& row : border_rows(regions, beside, threads, progress))
    result.turns.push_back(std::move(row));
  if (!is_outwards) {
    std::reverse(result.turns.begin(), result.turns.end());
    for (std::vector<Polyline>& turn : result.turns)
      if (!turn.empty() && !turn.front().is_closed)
        std::reverse(turn.front().corners.begin(), turn.front().corners.end());
  }
  return result;
}

}  // namespace evenload
