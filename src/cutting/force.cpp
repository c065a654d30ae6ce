#include "cutting/force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/vec2.h"

namespace evenload {

namespace {

// Between two samples of the tip's angle a sum of teeth departs from its chord by at most
// M step^2 / 8, M the bound of its second derivative: twice the amplitude of a tooth that is
// engaged at its whole depth, so that 2 degrees leave 0.3e-3 of it.
constexpr double kStep = 2 * kPi / 180;
// Of a tooth that is entering or leaving, M is the force per angle over the angle, and the piece of
// revolution in which that lasts is no longer than the angle: n steps leave 1 / (4 n^2) of it.
constexpr int kLeastSteps = 16;
// Even, for Simpson's rule; a piece is shorter than half a turn, or nothing changes in it.
constexpr int kMostSteps = 122;
// Lags below it are taken as straight flutes: the forces differ by this share, as much as the
// difference of two antiderivatives loses to rounding.
constexpr double kStraightLag = 1e-8;

// rad. Breakpoints closer than this are one: between them nothing is engaged that is not beside
// them.
constexpr double kLeastPiece = 1e-9;

// A unit vector at an angle, multiplied as complex numbers are.
struct Unit {
  double c = 1, s = 0;
};
Unit unit_at(double angle) { return {std::cos(angle), std::sin(angle)}; }
Unit operator*(Unit a, Unit b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }
Unit reversed(Unit a) { return {a.c, -a.s}; }

// Integrals along the engaged length of the tooth.
struct Moments {
  double length = 0, cosine = 0, sine = 0, cosine_squared = 0, sine_cosine = 0;
};

// An arc made ready.
struct PreparedArc {
  double low, high, depth;
  double lag;  // rad from the tip to `depth`, 0 for straight flutes
  Unit half_low, half_high, half_lag;
};

void check(const EngagedArc& arc) {
  constexpr double kRounding = 1e-9;  // rad, of whoever measured the arc
  if (!(arc.low >= -kPi / 2 - kRounding && arc.low <= arc.high && arc.high <= kPi / 2 + kRounding))
    throw std::invalid_argument(
        "An engaged arc must lie in the leading half circle, low <= high, from -pi/2 to pi/2.");
  if (!(arc.depth >= 0 && std::isfinite(arc.depth)))
    throw std::invalid_argument("The depth of an engaged arc must be 0 or more and finite.");
}

// The phase of an angle in the teeth's period.
double phase_of(double angle, double period) {
  const double phase = std::fmod(angle, period);
  return phase < 0 ? phase + period : phase;
}

}  // namespace

ForceModel::ForceModel(const ForceCoefficients& coefficients, double tool_radius, int teeth,
                       double helix_angle)
    : coefficients_(coefficients), radius_(tool_radius), teeth_(teeth), lag_(0) {
  for (const double k : {coefficients.ktc, coefficients.krc, coefficients.kte, coefficients.kre})
    if (!(k >= 0 && std::isfinite(k)))
      throw std::invalid_argument("A cutting force coefficient must be 0 or more and finite.");
  if (!(tool_radius > 0 && std::isfinite(tool_radius)))
    throw std::invalid_argument("The tool's radius must be above 0 and finite.");
  if (teeth < 1) throw std::invalid_argument("The tool needs at least one tooth.");
  if (!(helix_angle >= 0 && helix_angle < kPi / 2))
    throw std::invalid_argument("The helix angle must be from 0 to below pi/2.");
  lag_ = std::tan(helix_angle) / tool_radius;
  for (int k = 0; k < teeth; ++k) {
    const Unit half = unit_at(kPi * k / teeth);
    half_tooth_angles_.push_back({half.c, half.s});
  }
}

CuttingForce ForceModel::force(const EngagedArc* arcs, std::size_t count, double feed_per_tooth,
                               double spindle_speed, double feed_angle) const {
  if (!(feed_per_tooth >= 0 && std::isfinite(feed_per_tooth)))
    throw std::invalid_argument("The feed per tooth must be 0 or more and finite.");
  if (!(spindle_speed >= 0 && std::isfinite(spindle_speed)))
    throw std::invalid_argument("The spindle speed must be 0 or more and finite.");
  if (!std::isfinite(feed_angle))
    throw std::invalid_argument("The angle of the feed must be finite.");
  const double period = 2 * kPi / teeth_;
  const double chip_t = coefficients_.ktc * feed_per_tooth;
  const double chip_r = coefficients_.krc * feed_per_tooth;
  const double edge_t = coefficients_.kte, edge_r = coefficients_.kre;

  CuttingForce result;
  std::vector<PreparedArc> prepared;
  std::vector<double> ends{0, period};  // phases at which a tooth's engagement changes its form
  prepared.reserve(count);
  ends.reserve(2 + 4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const EngagedArc& arc = arcs[i];
    check(arc);
    const double width = arc.high - arc.low;
    if (width == 0 || arc.depth == 0) continue;
    double lag = lag_ * arc.depth;
    if (lag < kStraightLag) lag = 0;
    const Unit half_low = unit_at(arc.low / 2), half_high = unit_at(arc.high / 2);
    prepared.push_back({arc.low, arc.high, arc.depth, lag, half_low, half_high, unit_at(lag / 2)});
    ends.push_back(phase_of(arc.low, period));
    ends.push_back(phase_of(arc.high, period));
    if (lag > 0) {
      ends.push_back(phase_of(arc.low - lag, period));
      ends.push_back(phase_of(arc.high - lag, period));
    }
    // The means over a revolution: every height of every tooth passes the arc once.
    const Unit half_width = half_high * reversed(half_low), middle = half_low * half_high;
    const Unit twice = middle * middle, whole = half_width * half_width;
    const double share = teeth_ * arc.depth / (2 * kPi);
    const double cosine = 2 * half_width.s * middle.c, sine = 2 * half_width.s * middle.s;
    const double cosine_squared = (width + whole.s * twice.c) / 2, mixed = whole.s * twice.s / 2;
    result.mean_x +=
        share * (chip_t * mixed + edge_t * sine + chip_r * cosine_squared + edge_r * cosine);
    result.mean_y +=
        share * (-chip_t * cosine_squared - edge_t * cosine + chip_r * mixed + edge_r * sine);
    result.mean_torque += share * radius_ * 1e-3 * (chip_t * cosine + edge_t * width);
  }
  if (prepared.empty()) return result;
  std::sort(ends.begin(), ends.end());

  const Unit turn = unit_at(feed_angle);
  std::array<Moments, kMostSteps + 1> sums;
  double peak_x = 0, peak_y = 0, peak_squared = 0, peak_torque = 0, sum_xy = 0;
  for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
    const double begin = ends[e], length = ends[e + 1] - begin;
    if (length < kLeastPiece) continue;
    int steps = std::max(kLeastSteps, static_cast<int>(std::ceil(length / kStep)));
    steps = std::min(steps + steps % 2, kMostSteps);
    const Unit half_begin = unit_at(begin / 2), half_step = unit_at(length / steps / 2);
    bool engaged = false;
    for (const PreparedArc& arc : prepared) {
      // Teeth whose tip, in the middle of the piece, is between low - lag and high.
      const double middle = begin + length / 2;
      const int first = static_cast<int>(std::ceil((arc.low - arc.lag - middle) / period));
      const int last = static_cast<int>(std::floor((arc.high - middle) / period));
      for (int k = first; k <= last; ++k) {
        const double tip = middle + k * period;
        const bool from_tip = tip >= arc.low, to_depth = tip + arc.lag <= arc.high;
        if (!engaged) std::fill_n(sums.begin(), steps + 1, Moments{});
        engaged = true;
        // k may be beyond one turn: a half angle half a turn on is the same unit with the other
        // sign, and only products of two of them are used.
        const Turn& own = half_tooth_angles_[((k % teeth_) + teeth_) % teeth_];
        Unit half_tip = Unit{own.c, own.s} * half_begin;
        double length_at = arc.depth, length_step = 0;
        if (!from_tip && !to_depth) {
          length_at = (arc.high - arc.low) / lag_;
        } else if (!from_tip) {
          length_at = (begin + k * period + arc.lag - arc.low) / lag_;
          length_step = length / steps / lag_;
        } else if (!to_depth) {
          length_at = (arc.high - begin - k * period) / lag_;
          length_step = -length / steps / lag_;
        }
        for (int i = 0; i <= steps; ++i) {
          const Unit bottom = from_tip ? half_tip : arc.half_low;
          const Unit top = to_depth ? half_tip * arc.half_lag : arc.half_high;
          const Unit mid = bottom * top, mid2 = mid * mid;
          const Unit half_width = top * reversed(bottom);
          double first_harmonic = arc.depth, second_harmonic = arc.depth;
          if (arc.lag > 0) {
            first_harmonic = 2 * half_width.s / lag_;
            second_harmonic = 2 * half_width.s * half_width.c / lag_;
          }
          const double engaged_length = length_at + i * length_step;
          Moments& sum = sums[i];
          sum.length += engaged_length;
          sum.cosine += first_harmonic * mid.c;
          sum.sine += first_harmonic * mid.s;
          sum.cosine_squared += (engaged_length + second_harmonic * mid2.c) / 2;
          sum.sine_cosine += second_harmonic * mid2.s / 2;
          half_tip = half_tip * half_step;
        }
      }
    }
    if (!engaged) continue;
    double piece = 0;
    for (int i = 0; i <= steps; ++i) {
      const Moments& m = sums[i];
      const double along =
          chip_t * m.sine_cosine + edge_t * m.sine + chip_r * m.cosine_squared + edge_r * m.cosine;
      const double left =
          -chip_t * m.cosine_squared - edge_t * m.cosine + chip_r * m.sine_cosine + edge_r * m.sine;
      const double squared = along * along + left * left;
      peak_x = std::max(peak_x, std::abs(turn.c * along - turn.s * left));
      peak_y = std::max(peak_y, std::abs(turn.s * along + turn.c * left));
      peak_squared = std::max(peak_squared, squared);
      peak_torque = std::max(peak_torque, chip_t * m.cosine + edge_t * m.length);
      piece += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * std::sqrt(squared);
    }
    sum_xy += piece * length / (3 * steps);
  }
  const double mean_along = result.mean_x, mean_left = result.mean_y;
  result.mean_x = turn.c * mean_along - turn.s * mean_left;
  result.mean_y = turn.s * mean_along + turn.c * mean_left;
  result.peak_x = peak_x;
  result.peak_y = peak_y;
  result.peak_xy = std::sqrt(peak_squared);
  result.mean_xy = sum_xy / period;
  result.peak_torque = peak_torque * radius_ * 1e-3;
  result.mean_power = result.mean_torque * spindle_speed * 2 * kPi / 60;
  return result;
}

}  // namespace evenload
