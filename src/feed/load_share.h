// The measures of load that feed control can hold. Nominal is what a straight cut at the engagement
// angle has at the nominal feed; a share says how many times as much a place of the path has at
// that feed, so that feed / share is the feed allowed there.
//
// Laws: the straight cut itself has the share 1 in chip thickness and force, 1 / rate_margin in
// removal rate; at feed / share the measure is not above nominal (removal rate: not by more than
// that margin); more material never has a smaller share in chip thickness and removal rate.
// Conditions: 0 < angle < pi, all sizes positive.
#pragma once

#include <vector>

#include "cutting/force.h"
#include "feed/load_profile.h"
#include "geometry/vec2.h"

namespace evenload {

// Times the nominal removal rate, as a mean over 0.1 mm: 1.05 is the limit, and 0.004 of it are for
// means over a little less.
inline constexpr double kMostRate = 1.046;
// rad: how well the engagement along a path is known that posts round to 0.001 mm.
inline constexpr double kEngagementDoubt = 0.3 * kPi / 180;
// So much of the nominal removal rate is allowed where engagement is as looked at: kMostRate is
// kept were it larger by kEngagementDoubt, which at small engagement angles is a larger part of it.
double rate_margin(double angle);

// rad: how well the ends of an arc are known. Engagement is held to about a degree, and the
// simulator's dexels of 0.05 mm see a tool of 6 mm no better. In short arcs that is a large part of
// chip and force; so these are also compared with all arcs, the straight cut's among them, longer
// by this, and the larger share counts.
inline constexpr double kArcDoubt = 1.5 * kPi / 180;
// Force control never asks for less than this share of the nominal feed: teeth that hardly advance
// rub instead of cutting.
inline constexpr double kLeastForceFeed = 0.1;

// Of r (1 - cos theta) removed per mm of path, with rate_margin.
LoadShare removal_rate_share(double angle, double radius);

// Of the largest chip thickness: sin theta of the feed per tooth up to 90 degrees, then all of it.
LoadShare chip_thickness_share(double angle);

struct ForceTask {
  ForceCoefficients coefficients;
  int teeth = 1;
  double helix_angle = 0;            // rad, of the flutes
  double spindle_speed = 6366;       // rev/min, > 0
  double feed = 255;                 // mm/min, nominal
  double maximum_feed = 510;         // mm/min: shares below feed / maximum_feed are that
  std::vector<double> depths = {3};  // mm: axial depths at which the path is cut; all must hold
  bool mirrored = false;             // the path is the mirror image of the one that is cut
};
// Of the largest force in the plane over a revolution (ForceModel). The force is no multiple of the
// feed where the edges have their part, so the feed is solved for, to kForceTolerance below the
// nominal force. Shares are at most 1 / kLeastForceFeed. Throws std::invalid_argument for a task
// that ForceModel refuses, without a spindle speed, or without any force.
LoadShare force_share(double angle, double radius, const ForceTask& task);

inline constexpr double kForceTolerance = 1e-3;

}  // namespace evenload
