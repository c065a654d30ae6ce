#include "feed/load_profile.h"

#include <algorithm>
#include <cmath>

namespace evenload {

void add_descent(const Descent& descent, ClearedGround& ground) {
  if (descent.kind == DescentKind::kHelix)
    ground.add_disc(descent.centre, descent.radius + ground.tool_radius());
  else if (descent.kind == DescentKind::kRamp)
    ground.add(Segment::line(descent.at, descent.ramp_end));
}

std::vector<LoadSample> load_profile(const std::vector<PlanarRun>& runs, ClearedGround& ground,
                                     double spacing) {
  std::vector<LoadSample> profile;
  std::vector<AngularInterval> engaged;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    add_descent(runs[i].descent, ground);
    for (std::size_t j = 0; j < runs[i].moves.size(); ++j) {
      const PlanarMove& move = runs[i].moves[j];
      const double length = move.segment.length();
      const int n = std::max(1, static_cast<int>(std::ceil(length / spacing)));
      for (int k = 0; k < n; ++k) {
        LoadSample sample{i, j, (k + 0.5) / n, length / n, 0, 0};
        if (move.kind == MoveKind::kCut) {
          const double right = angle_of(move.segment.tangent(sample.t)) - kPi / 2;
          ground.uncovered(move.segment.point(sample.t), right, right + kPi, engaged, 1e-4);
          for (const AngularInterval& arc : engaged) {
            sample.engagement += arc.width();
            sample.width +=
                ground.tool_radius() * (std::cos(arc.low - right) - std::cos(arc.high - right));
          }
        }
        profile.push_back(sample);
      }
      ground.add(move.segment);
    }
  }
  return profile;
}

double worst_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                        double window) {
  double worst = 0, length = 0, sum = 0;
  std::size_t first = 0;
  const auto cuts = [&](const LoadSample& s) {
    return runs[s.run].moves[s.move].kind == MoveKind::kCut;
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!cuts(profile[i]) || (i && profile[i].run != profile[i - 1].run)) {
      first = cuts(profile[i]) ? i : i + 1;
      length = sum = 0;
      if (!cuts(profile[i])) continue;
    }
    length += profile[i].length;
    sum += profile[i].engagement * profile[i].length;
    while (first < i && length - profile[first].length >= window) {
      length -= profile[first].length;
      sum -= profile[first].engagement * profile[first].length;
      ++first;
    }
    worst = std::max(worst, sum / std::max(length, window));
  }
  return worst;
}

}  // namespace evenload
