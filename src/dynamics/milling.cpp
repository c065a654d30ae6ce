#include "dynamics/milling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/demand.h"

namespace evenload {

namespace {

constexpr double kTurn = 2 * M_PI;
// rad of lag over the depth: less is a straight tooth, whose H differs by as much.
constexpr double kStraight = 1e-9;
constexpr double kAngleSum = 1e-6;  // rad by which pitch angles may miss a turn, as rounded numbers

bool is_at_least(double value, double least) { return std::isfinite(value) && value >= least; }

Engaged primitive(double angle) {
  return {angle, -0.5 * std::cos(2 * angle), 0.5 * std::sin(2 * angle)};
}

// Integrals from 0 to `angle` of what is engaged, through whole turns, for one tool.
class Primitive {
 public:
  Primitive(double entry, double exit)
      : entry_(entry), exit_(exit), start_(primitive(entry)), whole_(primitive(exit) - start_) {}
  Engaged operator()(double angle) const {
    const double turns = std::floor(angle / kTurn), rest = angle - kTurn * turns;
    if (rest <= entry_) return turns * whole_;
    if (rest >= exit_) return (turns + 1) * whole_;
    return turns * whole_ + (primitive(rest) - start_);
  }

 private:
  double entry_, exit_;
  Engaged start_, whole_;
};

}  // namespace

double Milling::entry() const { return climb ? M_PI - engagement : 0.0; }
double Milling::exit() const { return climb ? M_PI : engagement; }
double Milling::period_angle() const { return even() ? kTurn / teeth : kTurn; }
double Milling::twist() const { return lead > 0 ? kTurn / lead : 0.0; }
double Milling::pitch(int tooth) const {
  return even() ? kTurn / teeth : tooth_angles[static_cast<std::size_t>(tooth)];
}
std::vector<Mode> Milling::modes_along_feed() const { return turned(modes, feed_direction); }

std::vector<double> Milling::positions() const {
  std::vector<double> result{0.0};
  for (int j = 0; j + 1 < teeth; ++j) result.push_back(result.back() + pitch(j));
  return result;
}

void check(const Milling& m) {
  check_modes(m.modes);
  demand(m.teeth >= 1, "A tool needs at least one tooth.");
  demand(is_at_least(m.tangential, 0) && m.tangential > 0,
         "The tangential cutting coefficient must be above 0 N/mm^2.");
  demand(is_at_least(m.normal, 0), "The normal cutting coefficient must not be negative.");
  demand(std::isfinite(m.engagement) && m.engagement > 0 && m.engagement <= M_PI,
         "The immersion must lie above 0, where nothing is cut, and at most at 1, a slot.");
  demand(is_at_least(m.radius, 0) && m.radius > 0, "The tool's diameter must be above 0 mm.");
  demand(is_at_least(m.lead, 0), "The lead of the helix must be above 0 mm, or None for straight.");
  demand(std::isfinite(m.feed_direction), "The feed direction must be a number of degrees.");
  demand(is_at_least(m.process_damping, 0) && is_at_least(m.flank_friction, 0),
         "Process damping and the flank's friction must not be negative.");
  if (m.even()) return;
  demand(static_cast<int>(m.tooth_angles.size()) == m.teeth,
         "There must be one pitch angle for each tooth.");
  for (const double angle : m.tooth_angles)
    demand(std::isfinite(angle) && angle > 0, "Each pitch angle must be above 0 degrees.");
  const double sum = std::accumulate(m.tooth_angles.begin(), m.tooth_angles.end(), 0.0);
  demand(std::abs(sum - kTurn) < kAngleSum, "The pitch angles must sum to 360 degrees.");
}

void check_speed_and_depth(double speed, double depth) {
  demand(std::isfinite(speed) && speed > 0, "The spindle speed must be above 0 rev/min.");
  demand(is_at_least(depth, 0), "The axial depth must not be negative.");
}

Engaged engaged_depth(const Milling& m, double angle, double depth) {
  const double lag = m.twist() * depth;
  if (lag > kStraight) {
    const Primitive sum(m.entry(), m.exit());
    return (sum(angle) - sum(angle - lag)) / m.twist();
  }
  const double rest = angle - kTurn * std::floor(angle / kTurn);
  if (rest <= m.entry() || rest >= m.exit()) return Engaged::Zero();
  return depth * Engaged(1, std::sin(2 * rest), std::cos(2 * rest));
}

Eigen::Matrix2d force_matrix(double tangential, double normal, const Engaged& e) {
  const double ss = 0.5 * (e[0] - e[2]), cc = 0.5 * (e[0] + e[2]), sc = 0.5 * e[1];
  Eigen::Matrix2d a;
  a << tangential * sc + normal * ss, tangential * cc + normal * sc,  //
      -tangential * ss + normal * sc, -tangential * sc + normal * cc;
  return a;
}

std::vector<double> switching_angles(const Milling& m, double depth) {
  const double lag = m.twist() * depth;
  std::vector<double> result{m.entry(), m.exit()};
  if (lag > kStraight) {
    result.push_back(m.entry() + lag);
    result.push_back(m.exit() + lag);
  }
  for (double& angle : result) angle -= kTurn * std::floor(angle / kTurn);
  return result;
}

}  // namespace evenload
