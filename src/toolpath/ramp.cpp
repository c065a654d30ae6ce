#include "toolpath/ramp.h"

#include <algorithm>
#include <cmath>

namespace evenload {

std::vector<Segment> ramp_round(const Descent& ramp) {
  std::vector<Segment> round;
  Vec2 from = ramp.at;
  for (const Vec2& to : ramp.ramp_by) {
    round.push_back(Segment::line(from, to));
    from = to;
  }
  round.push_back(Segment::line(from, ramp.at));
  return round;
}

double ramp_length(const Descent& ramp) {
  double length = 0;
  for (const Segment& line : ramp_round(ramp)) length += line.length();
  return length;
}

std::vector<double> ramp_shares(const Descent& ramp, double angle) {
  const double least = kLeastDescent / std::tan(angle);
  std::vector<double> shares;
  for (const Segment& line : ramp_round(ramp)) shares.push_back(std::max(line.length(), least));
  return shares;
}

double ramp_area(const Descent& ramp, double tool_radius) {
  double inside = 0;
  for (const Segment& line : ramp_round(ramp))
    inside += 0.5 * cross(line.a - ramp.at, line.b - ramp.at);
  return kPi * tool_radius * tool_radius + ramp_length(ramp) * tool_radius + std::abs(inside);
}

}  // namespace evenload
