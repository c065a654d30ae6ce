#include "feed/load_share.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cutting/engagement.h"

namespace evenload {
namespace {

// Secants close in from below; straight lines take one, the most curved of the tests takes four.
constexpr int kMostSecants = 20;

// The force at one axial depth, held against a straight cut at that depth.
class ForceLimit {
 public:
  ForceLimit(double angle, double radius, const ForceTask& task, double depth)
      : model_(task.coefficients, radius, task.teeth, task.helix_angle),
        teeth_per_minute_(task.teeth * task.spindle_speed),
        feed_(task.feed),
        maximum_feed_(task.maximum_feed),
        depth_(depth),
        mirrored_(task.mirrored) {
    nominal_ = peak(arcs_of({{-kPi / 2, angle - kPi / 2}}), feed_);
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

LoadShare removal_rate_share(double angle, double radius) {
  const double most = kRateMargin * side_step(angle, radius);
  return [most](const Load& load, const auto&) { return load.width / most; };
}

LoadShare chip_thickness_share(double angle) {
  const double nominal = largest_chip_thickness(angle, 1);
  return [nominal](const Load& load, const auto&) { return load.chip / nominal; };
}

LoadShare force_share(double angle, double radius, const ForceTask& task) {
  if (!(task.spindle_speed > 0))
    throw std::invalid_argument(
        "A constant force needs the spindle's speed: set that of the tool controller.");
  std::vector<ForceLimit> limits;
  for (const double depth : task.depths) limits.emplace_back(angle, radius, task, depth);
  return [limits](const Load&, const std::vector<AngularInterval>& arcs) {
    double share = 0;
    for (const ForceLimit& limit : limits) share = std::max(share, limit.share(arcs));
    return share;
  };
}

}  // namespace evenload
