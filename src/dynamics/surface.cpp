#include "dynamics/surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "support/parallel.h"

namespace evenload {

namespace {

constexpr std::size_t kSamples = 512;  // of a period with kForcedHarmonics
constexpr double kReach = 0.6;         // rad from the wall's normal within which crests are sought
constexpr int kHeights = 48;           // of a period of the wall along the axis
constexpr int kGolden = 20;            // steps of a search for an extreme
constexpr int kNewton = 30;
constexpr int kNeighbours = 3;  // passes on either side that may leave the wall
constexpr int kCuspSteps = 100;

// The least of f between two places, one of them within holding it.
template <typename Function>
double least(const Function& f, double low, double high) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = f(a), at_b = f(b);
  for (int i = 0; i < kGolden; ++i) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = f(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = f(b);
    }
  }
  return std::min(at_a, at_b);
}

// The least and the largest of f over 0 to `height`: looked for at even steps, then between the
// neighbours.
template <typename Function>
std::pair<double, double> extremes(const Function& f, double height, int steps) {
  int lowest = 0, highest = 0;
  double low = f(0.0), high = low;
  for (int i = 1; i <= steps; ++i) {
    const double value = f(height * i / steps);
    if (value < low) {
      low = value;
      lowest = i;
    }
    if (value > high) {
      high = value;
      highest = i;
    }
  }
  const auto between = [&](const auto& g, int at) {
    return least(g, height * std::max(0, at - 1) / steps, height * std::min(steps, at + 1) / steps);
  };
  low = std::min(low, between(f, lowest));
  high = std::max(high, -between([&](double at) { return -f(at); }, highest));
  return {low, high};
}

std::size_t sample_count(const ForcedMotion& motion) {
  std::size_t count = kSamples;
  while (count < 8 * motion.harmonics.size()) count *= 2;
  return count;
}

}  // namespace

Surface::Surface(const Milling& milling, const Receptance& receptance, double speed, double depth,
                 double feed_per_tooth)
    : milling_(milling),
      depth_(depth),
      feed_(feed_per_tooth),
      wall_(milling.climb ? M_PI : 0.0),
      side_(milling.climb ? -1.0 : 1.0),
      motion_(forced_motion(milling, receptance, speed, depth, feed_per_tooth)),
      samples_(motion_.samples(1, sample_count(motion_))),
      positions_(milling.even() ? std::vector<double>{0.0} : milling.positions()) {
  check_speed_and_depth(speed, depth);
  if (!(feed_per_tooth > 0) || !std::isfinite(feed_per_tooth))
    throw std::invalid_argument("The feed per tooth must be above 0 mm.");
  for (double& sample : samples_) sample *= side_;
  // Farther away the circle has fallen by more than the vibration's whole width.
  const auto [low, high] = std::minmax_element(samples_.begin(), samples_.end());
  reach_ = std::min(kReach, std::acos(std::max(0.0, 1 - (*high - *low) / milling.radius)));
}

// The outermost place of a pass whose normal points to the wall at the spindle angle `angle`: the
// best sample, and the parabola through it and its neighbours.
Surface::Crest Surface::crest_of(int tooth, double angle) const {
  const auto count = static_cast<std::ptrdiff_t>(samples_.size());
  const double step = 2 * M_PI / motion_.order / static_cast<double>(count);
  const auto first = static_cast<std::ptrdiff_t>(std::floor((angle - reach_) / step));
  const auto last = static_cast<std::ptrdiff_t>(std::ceil((angle + reach_) / step));
  const auto offset = [&](std::ptrdiff_t i) {
    const std::ptrdiff_t rest = i % count;
    const double alpha = static_cast<double>(i) * step - angle, square = alpha * alpha;
    // cos(alpha) - 1, to 1e-10.
    const double bend =
        -square * (0.5 - square * (1 / 24.0 - square * (1 / 720.0 - square / 40320)));
    return samples_[static_cast<std::size_t>(rest < 0 ? rest + count : rest)] +
           milling_.radius * bend;
  };
  std::ptrdiff_t best = first;
  double highest = offset(first);
  for (std::ptrdiff_t i = first + 1; i <= last; ++i) {
    const double here = offset(i);
    if (here > highest) {
      highest = here;
      best = i;
    }
  }
  const double before = offset(best - 1), after = offset(best + 1);
  const double bend = before - 2 * highest + after, slope = 0.5 * (after - before);
  const double shift = bend < 0 ? -slope / bend : 0;
  return {(static_cast<double>(best) + shift) * step - angle, highest + 0.5 * slope * shift, tooth};
}

Surface::Crest Surface::crest(double z) const {
  Crest best{0, -1e300, 0};
  for (std::size_t j = 0; j < positions_.size(); ++j) {
    const Crest found = crest_of(static_cast<int>(j), wall_ + milling_.twist() * z - positions_[j]);
    if (found.offset > best.offset) best = found;
  }
  return best;
}

double Surface::location_error(double z) const { return crest(z).offset; }

Surface::Place Surface::place(int tooth, double z, double alpha) const {
  const double phi = wall_ + alpha, r = milling_.radius;
  const double angle = phi + milling_.twist() * z - positions_[static_cast<std::size_t>(tooth)];
  const double feed = feed_ * milling_.teeth / (2 * M_PI);
  const ForcedMotion::State q = motion_.at(angle);
  return {feed * angle + q.value[0] + r * std::sin(phi),
          side_ * q.value[1] + r * (std::cos(alpha) - 1), feed + q.slope[0] + r * std::cos(phi),
          side_ * q.slope[1] - r * std::sin(alpha), side_ * q.bend[1] - r * std::cos(alpha)};
}

// The offset at the places alpha_1 < alpha_2 of equal offset that lie a feed per tooth apart.
double Surface::cusp_between_equal_passes(double z, const Crest& top) const {
  const double x_slope = place(top.tooth, z, top.alpha).x_slope;
  const double half = 0.5 * feed_ / x_slope;
  double low = top.alpha - half, high = top.alpha + half;
  for (int i = 0; i < kNewton; ++i) {
    const Place a = place(top.tooth, z, low), b = place(top.tooth, z, high);
    const double f = a.n - b.n, g = b.x - a.x - feed_;
    const double determinant = a.n_slope * b.x_slope - b.n_slope * a.x_slope;
    if (determinant == 0) break;
    const double by_low = -(f * b.x_slope + g * b.n_slope) / determinant;
    const double by_high = -(a.n_slope * g + a.x_slope * f) / determinant;
    low += by_low;
    high += by_high;
    if (std::abs(by_low) + std::abs(by_high) < 1e-14) break;
  }
  return 0.5 * (place(top.tooth, z, low).n + place(top.tooth, z, high).n);
}

double Surface::cusp(double z) const {
  const Crest top = crest(z);
  if (milling_.even()) return top.offset - cusp_between_equal_passes(z, top);
  const double turn = feed_ * milling_.teeth;
  const double start = place(top.tooth, z, top.alpha).x;
  const auto wall = [&](double way) { return offset(z, start + way); };
  return top.offset - extremes(wall, turn, kCuspSteps).first;
}

double Surface::offset(double z, double x) const {
  const double turn = feed_ * milling_.teeth;
  const double spacing = milling_.even() ? feed_ : turn;
  double best = -1e300;
  for (std::size_t j = 0; j < positions_.size(); ++j) {
    const int tooth = static_cast<int>(j);
    const Crest top = crest_of(tooth, wall_ + milling_.twist() * z - positions_[j]);
    const double nearest = std::round((x - place(tooth, z, top.alpha).x) / spacing) * spacing;
    for (int pass = -kNeighbours; pass <= kNeighbours; ++pass) {
      const double wanted = x - nearest - pass * spacing;
      double alpha = top.alpha;
      for (int i = 0; i < kNewton; ++i) {
        const Place here = place(tooth, z, alpha);
        const double step = (wanted - here.x) / here.x_slope;
        alpha += std::clamp(step, -0.1, 0.1);
        if (std::abs(step) < 1e-12) break;
      }
      best = std::max(best, place(tooth, z, alpha).n);
    }
  }
  return best;
}

// m along the axis after which e(z) repeats, or the depth.
double Surface::height() const {
  if (milling_.twist() == 0) return 0;
  return std::min(depth_, milling_.period_angle() / milling_.twist());
}

SurfaceFigures Surface::location() const {
  SurfaceFigures result;
  const double z = height();
  if (z == 0) {
    result.least = result.most = location_error(0);
  } else {
    std::tie(result.least, result.most) =
        extremes([&](double at) { return location_error(at); }, z, kHeights);
  }
  result.waviness = result.most - result.least;
  result.location_error =
      std::abs(result.least) > std::abs(result.most) ? result.least : result.most;
  return result;
}

SurfaceFigures Surface::figures() const {
  SurfaceFigures result = location();
  const double z = height();
  result.roughness =
      z == 0 ? cusp(0) : extremes([&](double at) { return cusp(at); }, z, kHeights).second;
  return result;
}

std::vector<double> location_errors(const Milling& milling, const Receptance& receptance,
                                    const std::vector<double>& speeds,
                                    const std::vector<double>& depths, double feed_per_tooth,
                                    int threads, Progress& progress) {
  std::vector<double> result(3 * speeds.size());
  parallel_for(
      speeds.size(), thread_count(threads),
      [&](std::size_t i) {
        const SurfaceFigures found =
            Surface(milling, receptance, speeds[i], depths[i], feed_per_tooth).location();
        result[3 * i] = found.location_error;
        result[3 * i + 1] = found.least;
        result[3 * i + 2] = found.most;
      },
      progress);
  return result;
}

}  // namespace evenload
