#include "dynamics/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dynamics/arnoldi.h"
#include "dynamics/period_map.h"

namespace evenload {

namespace {

constexpr int kDepthSteps = 200;           // of the search for the least unstable depth
constexpr double kNearlyUnstable = 0.9;    // rho: peaks from here on are looked at closely
constexpr double kDepthTolerance = 1e-6;   // relative
constexpr double kReal = 1e-3;             // rad: nearer to 0 or pi a multiplier is real
constexpr double kFew = 60;                // rad of the fastest vibration in a period
constexpr double kEigenvalueShare = 0.05;  // of the accuracy, for the eigenvalue itself

using Radius = std::function<double(double)>;

// Where rho passes 1 between a stable and an unstable depth.
double crossing(const Radius& radius, double stable, double unstable) {
  double low = std::log(radius(stable)), high = std::log(radius(unstable));
  int last = 0;
  while (unstable - stable > kDepthTolerance * unstable) {
    double depth = stable - low * (unstable - stable) / (high - low);
    const double margin = 0.2 * kDepthTolerance * unstable;  // so that both sides come near
    depth = std::clamp(depth, stable + margin, unstable - margin);
    const double value = std::log(radius(depth));
    if (value >= 0) {
      unstable = depth;
      high = value;
      if (last == 1) low *= 0.5;  // the Illinois rule
      last = 1;
    } else {
      stable = depth;
      low = value;
      if (last == -1) high *= 0.5;
      last = -1;
    }
  }
  return unstable;
}

// The depth of the largest rho between `low` and `high`, by golden section, or of the first found
// that is unstable.
double peak(const Radius& radius, double low, double high) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = radius(a), at_b = radius(b);
  while (high - low > 1e-3 * high && at_a < 1 && at_b < 1) {
    if (at_a > at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = radius(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = radius(b);
    }
  }
  return at_a > at_b ? a : b;
}

// Of the eigenvalue's residual. With many vibrations to a period far smaller ones belong to values
// that are none: what grows before it decays looks like an eigenvalue.
double eigenvalue_tolerance(const PeriodicSystem& system, double accuracy) {
  const double vibrations = std::max(1.0, system.fastest * system.period / kFew);
  return kEigenvalueShare * accuracy / (vibrations * vibrations * vibrations * vibrations);
}

void demand_accuracy(double accuracy) {
  if (!(accuracy > 0 && accuracy < 1))
    throw std::invalid_argument("The accuracy must lie between 0 and 1.");
}

}  // namespace

std::vector<std::complex<double>> multipliers(const PeriodicSystem& system, double accuracy,
                                              int wanted, int refinement) {
  const PeriodMap map(system, accuracy, refinement);
  return largest_eigenvalues([&](const double* before, double* after) { map.apply(before, after); },
                             map.size(), eigenvalue_tolerance(system, accuracy), wanted);
}

std::vector<std::complex<double>> multipliers(const Milling& milling, double speed, double depth,
                                              double accuracy, int wanted) {
  check(milling);
  check_speed_and_depth(speed, depth);
  demand_accuracy(accuracy);
  return multipliers(milling_system(milling, speed, depth), accuracy, wanted);
}

double spectral_radius(const Milling& milling, double speed, double depth, double accuracy) {
  return std::abs(multipliers(milling, speed, depth, accuracy, 1).front());
}

double critical_depth(const Milling& milling, double speed, double largest, double accuracy) {
  check(milling);
  check_speed_and_depth(speed, largest);
  demand_accuracy(accuracy);
  if (!(largest > 0)) throw std::invalid_argument("The largest depth must be above 0 mm.");
  const Radius radius = [&](double depth) {
    return std::abs(multipliers(milling_system(milling, speed, depth), accuracy).front());
  };
  const auto depth_at = [&](int i) { return largest * i / kDepthSteps; };
  double before = 0, here = radius(0);
  for (int i = 1; i <= kDepthSteps; ++i) {
    const double next = radius(depth_at(i));
    if (i > 1 && here < 1 && here > kNearlyUnstable && here > before && here >= next) {
      const double depth = peak(radius, depth_at(i - 2), depth_at(i));
      if (radius(depth) >= 1) return crossing(radius, depth_at(i - 2), depth);
    }
    if (next >= 1) return crossing(radius, depth_at(i - 1), depth_at(i));
    before = here;
    here = next;
  }
  return std::numeric_limits<double>::infinity();
}

BoundaryKind kind_of(const std::complex<double>& multiplier) {
  const double angle = std::abs(std::arg(multiplier));
  if (angle < kReal) return BoundaryKind::kFold;
  return angle > M_PI - kReal ? BoundaryKind::kFlip : BoundaryKind::kHopf;
}

Vibration strongest_vibration(const PeriodicSystem& system, double accuracy) {
  PeriodicSystem followed = system;  // in its idle pieces, too
  for (PeriodPiece& piece : followed.pieces) piece.active = true;
  const PeriodMap map(followed, accuracy);
  const Eigenpair pair =
      largest_eigenpair([&](const double* before, double* after) { map.apply(before, after); },
                        map.size(), kEigenvalueShare * accuracy);
  const std::complex<double> exponent = std::log(pair.value) / system.period;
  const double base = 2 * M_PI / system.period;
  const int most = static_cast<int>(std::ceil(system.fastest / base)) + 2;
  const std::vector<PeriodMap::Node> nodes = map.nodes();
  Vibration result{pair.value, 0};
  double largest = -1;
  for (int k = -most; k <= most; ++k) {
    const double frequency = exponent.imag() + k * base;
    Eigen::Vector2cd sum = Eigen::Vector2cd::Zero();
    for (const PeriodMap::Node& node : nodes)
      for (int a = 0; a < system.width; ++a)
        sum[a] += node.weight * pair.vector[node.place + a] *
                  std::exp(-std::complex<double>(exponent.real(), frequency) * node.time);
    if (sum.norm() <= largest) continue;
    largest = sum.norm();
    result.frequency = std::abs(frequency);
  }
  return result;
}

}  // namespace evenload
