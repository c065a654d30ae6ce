// One period of a trochoidal path along a slot, and what it does once it repeats.
//
// In the pattern's own frame the middle of the slot starts at the origin along +x and bends by
// `curvature`; the tool cuts to its right (climb milling), so every period leaves the right wall,
// crosses the front and arrives at the left wall. Each period is the one before moved on by `step`
// along the middle: shifted where the slot is straight, turned where it is an arc.
//
// Laws of a finished pattern: cut, link and the next period's cut are tangent to each other; no
// point of the tool leaves the slot; the engagement, as a mean over kMeanLength mm, exceeds the
// limit by no more than load_budget::kPattern once the pattern repeats (most_engagement); links
// meet nothing. Where the cleared ground holds what the pattern has cleared behind a period, that
// period keeps the limit, whatever else is cleared besides: engagement falls with the ground that
// is left.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "feed/feed_control.h"
#include "feed/load_profile.h"
#include "geometry/curve.h"
#include "strategy/steer/steering.h"
#include "support/progress.h"
#include "toolpath/machinable.h"

namespace evenload {

struct TrochoidParams {
  double tool_radius = 3;       // mm, > 0
  double width = 9;             // mm that are cleared, more than the tool's diameter
  double curvature = 0;         // 1/mm, of the slot's middle, positive = turns left
  double engagement = kPi / 3;  // rad, 0 < engagement < pi: the limit
  double turn_radius = 0.9;     // mm: the widest roll-in and roll-out
  double feed = 255;            // mm/min, at the limit
  double maximum_feed = 255;    // mm/min: up to here the removal rate is kept where less is met
  double link_feed = 1500;      // mm/min
  // false: cuts end where they touch the left wall, whose scallops are left to a pass along it.
  bool finish_walls = true;
  double least_turn = 0;  // mm, <= turn_radius: no turn is tighter where there is room for it
  Progress* progress = nullptr;  // of which steps are made while a pattern is sought
};

struct TrochoidPattern {
  std::vector<Segment> cut;   // from where the tool meets material to where it has left it
  std::vector<Segment> link;  // from there to the start of the next period's cut
  double step = 0;            // mm along the middle
  double curvature = 0;       // 1/mm, of the middle
  double turn_radius = 0;     // mm, of the tightest turn that was asked for
  // mm, pass by pass: by how much the advance differed from place to place of the front. Empty for
  // patterns that are not found by iteration.
  std::vector<double> residuals;
};

// How far a period's cut reaches along the middle from the pattern's origin, mm.
struct PeriodReach {
  double back = 0, ahead = 0;
};
PeriodReach reach_of(const TrochoidPattern& pattern);

// The places of circles of `radius` mm along the middle, mm from the pattern's origin: the furthest
// whose front half lies behind the cut, and the nearest whose front half lies ahead of it.
struct CirclesThrough {
  double first = 0, last = 0;
};
CirclesThrough circles_through(const TrochoidPattern& pattern, double radius);

// rad: what a pattern may meet.
double most_engagement(const TrochoidParams& params);

// mm: half the width that the tool's centre has.
double half_room(const TrochoidParams& params);
// Throws std::invalid_argument for parameters out of range, and for a slot that the tool does not
// fit or that bends more tightly than half its width.
void check(const TrochoidParams& params);

// Where the slot's middle is after `s` mm, in the pattern's frame.
Pose place_along(double curvature, double s);
Segment placed(const Segment& move, const Pose& at);
std::vector<Segment> placed(const std::vector<Segment>& moves, const Pose& at);

// The places of the tool's centre from `back` mm behind the origin to `ahead` mm before it.
// Condition: the strip does not meet itself.
Region strip_of(const TrochoidParams& params, double back, double ahead);

// What a pattern does once it repeats.
struct PatternFigures {
  double cut_length = 0, link_length = 0;  // mm, of a period
  double area_per_length = 0;              // mm^2 per mm of cut that meets material
  double max_engagement = 0;               // rad, mean over kMeanLength mm
  double within = 0;                       // share of the cut within kBand of the limit
  double time = 0;                         // min, of a period
  double removal = 0;                      // mm^2/min: width * step / time
};
// The load changes all along a period, and there are hundreds of them: steps of the feed that a
// long pass would hardly gain by are a good part of their time. 0.1 mm take 6 ms at 1000 mm/min. In
// narrow slots all of a turn is hardly longer than a mean: with a bound for single samples one of
// 6.2 mm takes 5 % longer.
inline constexpr FeedSteps kSlotFeedSteps{block_price::kPattern, 0.1,
                                          std::numeric_limits<double>::infinity()};
inline constexpr double kBand = 2 * kPi / 180;
PatternFigures figures_of(const TrochoidPattern& pattern, const TrochoidParams& params);

// A pattern as it repeats: the ground that periods behind each other leave, and the load of one
// more on it. That is looked at once, for all that is asked of it.
class RepeatedPattern {
 public:
  // Conditions: the cut is not empty; the step is positive.
  RepeatedPattern(TrochoidPattern pattern, const TrochoidParams& params);

  const TrochoidPattern& pattern() const { return pattern_; }
  // rad, above what the pattern may meet; negative below.
  double overload() const;
  bool keeps_limit() const { return overload() <= 0; }
  // Gives the pattern the shortest link, from the end of its cut to the start of the next period's
  // over cleared ground, within the slot. False where there is none.
  bool link_back();
  PatternFigures figures() const;

 private:
  Bounds bounds() const;
  double behind() const { return periods_ * pattern_.step - reach_.back; }
  double ahead() const { return reach_.ahead + pattern_.step; }
  std::vector<Segment> shortest_return() const;

  TrochoidPattern pattern_;
  TrochoidParams params_;
  PeriodReach reach_;
  int periods_;
  ClearedGround ground_;
  std::vector<PlanarRun> runs_;  // the cut alone
  std::vector<LoadSample> profile_;
};

// mm: where the search for a step begins, and its end.
struct StepGuess {
  double likely = 0, most = 0;
};
// Of the patterns that `of_step` makes, that with the greatest step, not above the most, which
// keeps the limit; nothing where none does.
std::optional<RepeatedPattern> with_greatest_step(
    const std::function<TrochoidPattern(double step)>& of_step, const TrochoidParams& params,
    const StepGuess& guess);

// Whether one of the moves is an arc so tight that posts write it as lines.
bool turns_at_corners(const std::vector<Segment>& moves);

}  // namespace evenload
