#include "feed/load_share.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cutting/engagement.h"

namespace evenload {
namespace {

// Secants close in from below: a force in proportion to the feed takes one, and where these do not
// suffice the feed is only a little slower than it could be.
constexpr int kMostSecants = 20;

// The arcs, each end kArcDoubt further out within the leading half circle; those that meet are one.
std::vector<AngularInterval> widened(const std::vector<AngularInterval>& arcs) {
  std::vector<AngularInterval> result;
  for (const AngularInterval& arc : arcs) {
    const double low = std::max(arc.low - kArcDoubt, -kPi / 2);
    const double high = std::min(arc.high + kArcDoubt, kPi / 2);
    if (!result.empty() && low <= result.back().high)
      result.back().high = high;
    else
      result.push_back({low, high});
  }
  return result;
}

std::vector<AngularInterval> straight_cut(double angle) { return {{-kPi / 2, angle - kPi / 2}}; }

// As a share of the feed per tooth.
double largest_chip(const std::vector<AngularInterval>& arcs) {
  double largest = 0;
  for (const AngularInterval& arc : arcs)
    largest = std::max(largest, std::cos(std::clamp(0.0, arc.low, arc.high)));
  return largest;
}

// The force at one axial depth, held against a straight cut at that depth.
class ForceLimit {
 public:
  // `straight`: the arcs of the straight cut.
  ForceLimit(const std::vector<AngularInterval>& straight, double radius, const ForceTask& task,
             double depth)
      : model_(task.coefficients, radius, task.teeth, task.helix_angle),
        teeth_per_minute_(task.teeth * task.spindle_speed),
        feed_(task.feed),
        maximum_feed_(task.maximum_feed),
        depth_(depth),
        mirrored_(task.mirrored) {
    nominal_ = peak(arcs_of(straight), feed_);
    if (!(nominal_ > 0))
      throw std::invalid_argument(
          "A constant force needs a material that resists: give it a force coefficient above 0.");
  }

  double share(const std::vector<AngularInterval>& engaged) const {
    const std::vector<EngagedArc> arcs = arcs_of(engaged);
    double high = maximum_feed_, peak_high = peak(arcs, high);
    if (peak_high <= nominal_) return feed_ / maximum_feed_;
    double low = kLeastForceFeed * feed_, peak_low = peak(arcs, low);
    if (peak_low >= nominal_) return 1 / kLeastForceFeed;
    // The largest of lengths of vectors that grow linearly is convex in the feed: the chord meets
    // the nominal force before the curve does, and never beyond the feed that is sought.
    for (int i = 0; i < kMostSecants && peak_low < (1 - kForceTolerance) * nominal_; ++i) {
      low += (high - low) * (nominal_ - peak_low) / (peak_high - peak_low);
      peak_low = peak(arcs, low);
    }
    return feed_ / low;
  }

 private:
  std::vector<EngagedArc> arcs_of(const std::vector<AngularInterval>& engaged) const {
    std::vector<EngagedArc> arcs;
    arcs.reserve(engaged.size());
    for (const AngularInterval& arc : engaged)
      arcs.push_back(mirrored_ ? EngagedArc{-arc.high, -arc.low, depth_}
                               : EngagedArc{arc.low, arc.high, depth_});
    return arcs;
  }

  double peak(const std::vector<EngagedArc>& arcs, double feed) const {
    return model_.force(arcs.data(), arcs.size(), feed / teeth_per_minute_, 0).peak_xy;
  }

  ForceModel model_;
  double teeth_per_minute_;
  double feed_, maximum_feed_;
  double depth_;
  bool mirrored_;
  double nominal_ = 0;  // N
};

}  // namespace

double rate_margin(double angle) {
  return std::max(1.0, kMostRate * side_step(angle, 1) / side_step(angle + kEngagementDoubt, 1));
}

LoadShare removal_rate_share(double angle, double radius) {
  const double most = rate_margin(angle) * side_step(angle, radius);
  return [most](const Load& load, const auto&) { return load.width / most; };
}

LoadShare chip_thickness_share(double angle) {
  const std::vector<AngularInterval> straight = straight_cut(angle);
  const double nominal = largest_chip(straight), doubted = largest_chip(widened(straight));
  return [nominal, doubted](const Load& load, const std::vector<AngularInterval>& arcs) {
    return std::max(load.chip / nominal, largest_chip(widened(arcs)) / doubted);
  };
}

LoadShare force_share(double angle, double radius, const ForceTask& task) {
  if (!(task.spindle_speed > 0))
    throw std::invalid_argument(
        "A constant force needs the spindle's speed: set that of the tool controller.");
  const std::vector<AngularInterval> straight = straight_cut(angle);
  std::vector<ForceLimit> exact, doubted;
  for (const double depth : task.depths) {
    exact.emplace_back(straight, radius, task, depth);
    doubted.emplace_back(widened(straight), radius, task, depth);
  }
  return [exact, doubted](const Load&, const std::vector<AngularInterval>& arcs) {
    const std::vector<AngularInterval> wide = widened(arcs);
    double share = 0;
    for (const ForceLimit& limit : exact) share = std::max(share, limit.share(arcs));
    for (const ForceLimit& limit : doubted) share = std::max(share, limit.share(wide));
    return share;
  };
}

}  // namespace evenload
