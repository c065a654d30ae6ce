#include "strategy/pocket/feeds.h"

#include <algorithm>
#include <cmath>

#include "cutting/engagement.h"
#include "cutting/load_budget.h"
#include "feed/feed_control.h"
#include "feed/load_share.h"
#include "strategy/moves/move_checks.h"
#include "strategy/places/allowed_ground.h"
#include "strategy/reach/entry_feeds.h"
#include "strategy/trochoid/trochoid_period.h"
#include "support/tolerances.h"
#include "toolpath/helix.h"

namespace evenload {
namespace {

// Chips thicker than nominal by less are not worth a note: the engagement angle itself is kept no
// better.
constexpr double kThickChip = 1.02;

// What a program has where the tool comes down, beside the half turns of a helix.
constexpr double kBlocksPerRun = 3;
// Of the blocks that a controller takes, what rounding may add.
constexpr double kRoundedBlocks = 0.012;
// s: the dearest price of a block that is tried; how often the feeds are divided in search of the
// least price that leaves few; the share of the blocks that may stay unused; and the part of an
// interval of prices, in logarithms, that the next one keeps off its ends.
constexpr double kDearest = 0.1;
constexpr int kPrices = 9;
constexpr double kUnused = 0.002;
constexpr double kEdge = 0.15;
// More time than this, as a share, no number of blocks is worth.
constexpr double kMostSlower = 0.04;

// mm: the depths of cut, every size once.
std::vector<double> depths_of(const ClearingParams& params) {
  std::vector<double> depths;
  double above = params.top;
  for (const double level : params.levels) {
    const double depth = above - level;
    above = level;
    if (std::none_of(depths.begin(), depths.end(),
                     [&](double known) { return std::abs(known - depth) < kSame; }))
      depths.push_back(depth);
  }
  return depths;
}

// The sample with the largest `value` of its index, of cuts.
template <typename Value>
std::size_t worst_of(const std::vector<LoadSample>& profile, Value value) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < profile.size(); ++i)
    if (value(i) > value(worst)) worst = i;
  return worst;
}

struct LevelTurn {
  const PlanarRun* run = nullptr;
  double feed = 0;  // mm/min: its highest
};

// Of the helices that `runs` begin with the one whose level turn gets fastest, if it does so.
LevelTurn fastest_level_turn(const std::vector<PlanarRun>& runs, const ClearingParams& params) {
  LevelTurn fastest{nullptr, params.plunge_feed};
  for (const PlanarRun& run : runs) {
    if (run.descent.kind != DescentKind::kHelix) continue;
    for (const double depth : depths_of(params)) {
      const double feed = level_turn(run.descent, depth, params).back().feed;
      if (feed > fastest.feed) fastest = {&run, feed};
    }
  }
  return fastest;
}

Vec2 place_of(const std::vector<PlanarRun>& runs, const LoadSample& sample) {
  return runs[sample.run].moves[sample.move].segment.point(sample.t);
}

// Regions in which a pattern is repeated have steps of their own.
bool repeats(const std::vector<PlanarRun>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const PlanarRun& run) {
    return std::any_of(run.moves.begin(), run.moves.end(),
                       [](const PlanarMove& move) { return move.in_pattern; });
  });
}

// min
double time_of(const std::vector<PlanarRun>& runs) {
  double time = 0;
  for (const PlanarRun& run : runs)
    for (const PlanarMove& move : run.moves) time += move.segment.length() / move.feed;
  return time;
}

// Blocks of a program where the tool comes down to one level, on average over all.
double blocks_down(const Descent& descent, const ClearingParams& params) {
  if (descent.kind != DescentKind::kHelix) return kBlocksPerRun;
  const double depth =
      (params.top - params.levels.back()) / static_cast<double>(params.levels.size());
  const double per_half_turn = half_turn_length(descent) * std::tan(params.helix_angle);
  return kBlocksPerRun + std::ceil(depth / per_half_turn);
}

// Blocks per mm of a program, over those that the controller takes.
double share_of_blocks(const std::vector<PlanarRun>& runs, const ClearingParams& params) {
  double length = 0, blocks = 0;
  for (const PlanarRun& run : runs) {
    blocks += blocks_down(run.descent, params) + static_cast<double>(run.moves.size());
    for (const PlanarMove& move : run.moves) length += move.segment.length();
  }
  return 1000 * blocks / ((1 - kRoundedBlocks) * params.most_blocks_per_metre * length);
}

// A region with its feeds at one price of a block.
struct Priced {
  std::vector<PlanarRun> region;
  std::vector<double> feeds;
  double log_price = 0;
  double blocks = 0;  // as share_of_blocks() has them
};

// A constant load; where there are more blocks than the controller takes they are dearer, as little
// as makes them few, if that can be without much more time and no least load asks for them.
// Condition: they have a price.
std::vector<double> set_load(std::vector<PlanarRun>& region, const std::vector<LoadSample>& samples,
                             const FeedParams& params, const ClearingParams& clearing,
                             Progress& progress) {
  ConstantLoad load(region, samples, params, &progress);
  const auto at = [&](double price) {
    FeedsAlong found = load.at(price);
    const double blocks = share_of_blocks(found.runs, clearing);
    return Priced{std::move(found.runs), std::move(found.feeds), std::log(price), blocks};
  };
  if (clearing.most_blocks_per_metre <= 0) {
    FeedsAlong found = load.at(params.steps.price);
    region = std::move(found.runs);
    return std::move(found.feeds);
  }
  Priced many = at(params.steps.price);
  const auto taken = [&](Priced& priced) {
    region = std::move(priced.region);
    return std::move(priced.feeds);
  };
  if (many.blocks <= 1 || params.least_load > 0 || share_of_blocks(region, clearing) > 1)
    return taken(many);
  Priced few = at(kDearest), cheapest = many;
  if (few.blocks > 1) return taken(cheapest);
  for (int i = 0; i < kPrices && few.blocks < 1 - kUnused; ++i) {
    // Numbers of blocks are interpolated, or the interval is halved, in turn.
    const double part =
        i % 2 == 1 ? 0.5
                   : std::clamp((many.blocks - 1) / (many.blocks - few.blocks), kEdge, 1 - kEdge);
    Priced next = at(std::exp(many.log_price + part * (few.log_price - many.log_price)));
    (next.blocks > 1 ? many : few) = std::move(next);
  }
  const bool is_slow = time_of(few.region) > (1 + kMostSlower) * time_of(cheapest.region);
  return taken(is_slow ? cheapest : few);
}

// The feeds, region by region.
std::vector<double> set_load_by_region(std::vector<PlanarRun>& runs,
                                       const std::vector<LoadSample>& profile,
                                       const ClearingParams& params, Progress& progress) {
  std::vector<double> feeds;
  auto sample = profile.begin();
  for (std::size_t first = 0; first < runs.size();) {
    std::size_t last = first + 1;
    while (last < runs.size() && !runs[last].new_region) ++last;
    const auto from = runs.begin() + static_cast<std::ptrdiff_t>(first),
               to = runs.begin() + static_cast<std::ptrdiff_t>(last);
    std::vector<PlanarRun> region(from, to);
    std::vector<LoadSample> samples;
    for (; sample != profile.end() && sample->run < last; ++sample) {
      samples.push_back(*sample);
      samples.back().run -= first;
    }
    FeedParams own{params.feed, params.maximum_feed, params.link_feed, params.feed_steps};
    own.least_load = params.least_load;
    const bool is_repeated = repeats(region);
    if (is_repeated) own.steps = kSlotFeedSteps;
    // With a least load the whole mean must be near the worst sample anyway.
    if (params.feed_control == FeedControl::kConstantRemovalRate && own.steps.most_peak > 1 &&
        params.least_load <= 0)
      own.mean_length = kMeanLength;
    const std::vector<double> found = is_repeated
                                          ? set_constant_load(region, samples, own, &progress)
                                          : set_load(region, samples, own, params, progress);
    feeds.insert(feeds.end(), found.begin(), found.end());
    std::move(region.begin(), region.end(), from);
    first = last;
  }
  return feeds;
}

}  // namespace

LoadShare load_share(const ClearingParams& params, bool mirrored) {
  const double angle = params.engagement_angle, radius = 0.5 * params.tool_diameter;
  switch (params.feed_control) {
    case FeedControl::kConstantFeed:
      return nullptr;
    case FeedControl::kConstantRemovalRate:
      return removal_rate_share(angle, radius);
    case FeedControl::kConstantChipThickness:
      return chip_thickness_share(angle);
    case FeedControl::kConstantForce:
      return force_share(
          angle, radius,
          {params.force_coefficients, params.teeth, params.tool_helix_angle, params.spindle_speed,
           params.feed, params.maximum_feed, depths_of(params), mirrored});
  }
  return nullptr;
}

void set_feeds(std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
               const ClearingParams& params, const std::function<Vec2(Vec2)>& shown, Report& report,
               Progress& progress) {
  if (params.feed_control == FeedControl::kConstantFeed || profile.empty()) {
    set_constant_feed(runs, {params.feed, params.maximum_feed, params.link_feed, {}});
    return;
  }
  const std::vector<PlanarRun> whole = runs;
  std::vector<PlanarRun> fed = runs;
  const std::vector<double> feed = set_load_by_region(fed, profile, params, progress);
  runs = std::move(fed);
  if (params.feed_control == FeedControl::kConstantRemovalRate) {
    const double nominal = params.feed * largest_chip_thickness(params.engagement_angle, 1);
    const auto chip = [&](std::size_t i) { return feed[i] * profile[i].chip / nominal; };
    const std::size_t worst = worst_of(profile, chip);
    const LevelTurn turn = fastest_level_turn(runs, params);
    const bool helix_is_worse = turn.run && turn.feed / nominal > chip(worst);
    const double thickest = helix_is_worse ? turn.feed / nominal : chip(worst);
    if (thickest > kThickChip)
      report.findings.push_back(
          {FindingCode::kThickChips,
           shown(helix_is_worse ? turn.run->descent.centre : place_of(whole, profile[worst])),
           {thickest}});
  } else if (params.feed_control == FeedControl::kConstantForce) {
    const auto share = [&](std::size_t i) { return profile[i].share; };
    const std::size_t worst = worst_of(profile, share);
    if (share(worst) >= 1 / kLeastForceFeed)
      report.findings.push_back(
          {FindingCode::kStrongForce, shown(place_of(whole, profile[worst]))});
  }
}

}  // namespace evenload
