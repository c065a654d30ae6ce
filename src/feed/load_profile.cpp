#include "feed/load_profile.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm: material thinner than this is not seen; above the noise of rounding.
constexpr double kLoadTolerance = 1e-6;
// Two looks whose engagement and width (as a share of the tool's radius) differ less than this need
// none between them.
constexpr double kLikeEngagement = 2 * kPi / 180;
constexpr double kLikeWidth = 0.03;
// mm: no two looks are nearer, but on moves so short that a fifth of them is less.
constexpr double kFinestLook = 0.02;

}  // namespace

void add_descent(const Descent& descent, ClearedGround& ground) {
  if (descent.kind == DescentKind::kHelix)
    ground.add_disc(descent.centre, descent.radius + ground.tool_radius());
  else if (descent.kind == DescentKind::kRamp)
    ground.add(Segment::line(descent.at, descent.ramp_end));
}

namespace {

// Looks along one move, finer where the load changes.
class MoveProfile {
 public:
  MoveProfile(const ClearedGround& ground, const Segment& segment, const LoadSample& where,
              std::vector<LoadSample>& out)
      : ground_(ground), segment_(segment), length_(segment.length()), where_(where), out_(out) {}

  void cover(double spacing) {
    const int n = std::max(1, static_cast<int>(std::ceil(length_ / spacing)));
    Load before = load_at(0);
    for (int k = 0; k < n; ++k) {
      const double t0 = static_cast<double>(k) / n, t1 = static_cast<double>(k + 1) / n;
      const Load after = load_at(t1);
      cover(t0, before, t1, after);
      before = after;
    }
  }

 private:
  struct Load {
    double engagement = 0, width = 0;
  };

  Load load_at(double t) {
    const double right = angle_of(segment_.tangent(t)) - kPi / 2;
    ground_.uncovered(segment_.point(t), right, right + kPi, engaged_, kLoadTolerance);
    Load load;
    for (const AngularInterval& arc : engaged_) {
      load.engagement += arc.width();
      load.width +=
          ground_.tool_radius() * (std::cos(arc.low - right) - std::cos(arc.high - right));
    }
    return load;
  }

  bool alike(const Load& a, const Load& b) const {
    return std::abs(a.engagement - b.engagement) < kLikeEngagement &&
           std::abs(a.width - b.width) < kLikeWidth * ground_.tool_radius();
  }

  void cover(double t0, const Load& at0, double t1, const Load& at1) {
    const double t = 0.5 * (t0 + t1), piece = (t1 - t0) * length_;
    const Load middle = load_at(t);
    if (piece > std::min(kFinestLook, 0.2 * length_) &&
        !(alike(at0, middle) && alike(middle, at1))) {
      cover(t0, at0, t, middle);
      cover(t, middle, t1, at1);
      return;
    }
    LoadSample sample = where_;
    sample.t = t;
    sample.length = piece;
    sample.engagement = (at0.engagement + 4 * middle.engagement + at1.engagement) / 6;
    sample.width = (at0.width + 4 * middle.width + at1.width) / 6;
    sample.peak_width = std::max({at0.width, middle.width, at1.width});
    out_.push_back(sample);
  }

  const ClearedGround& ground_;
  const Segment& segment_;
  double length_;
  LoadSample where_;
  std::vector<LoadSample>& out_;
  std::vector<AngularInterval> engaged_;
};

}  // namespace

std::vector<LoadSample> load_profile(const std::vector<PlanarRun>& runs, ClearedGround& ground,
                                     double spacing) {
  std::vector<LoadSample> profile;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    add_descent(runs[i].descent, ground);
    for (std::size_t j = 0; j < runs[i].moves.size(); ++j) {
      const PlanarMove& move = runs[i].moves[j];
      const LoadSample where{i, j, 0.5, move.segment.length(), 0, 0, 0};
      if (move.kind == MoveKind::kCut)
        MoveProfile(ground, move.segment, where, profile).cover(spacing);
      else
        profile.push_back(where);
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
    // The window ends with this sample and begins within the first.
    const double beyond = std::max(0.0, length - window);
    worst = std::max(worst, (sum - beyond * profile[first].engagement) / window);
  }
  return worst;
}

}  // namespace evenload
