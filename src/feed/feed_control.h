// Feeds along a path: constant, or so that a measure of the load stays at its nominal value: the
// removal rate, as the source's feed control does, or the chip thickness or the force, which it
// names as the next step [Jacsó 2021, feed control]. load_share.h has the measures.
#pragma once

#include <cstddef>
#include <vector>

#include "feed/load_profile.h"
#include "support/progress.h"
#include "toolpath/machinable.h"
#include "toolpath/planar.h"

namespace evenload {

// How fine the steps are in which the feed changes within moves.
struct FeedSteps {
  double price = block_price::kFeed;  // s: what one more block must save
  double shortest = 0.1;  // mm: no piece is shorter, unless its move is; controllers handle a
                          // limited number of blocks per second
  // Where the load is held as a mean no sample is above so much of the nominal one, >= 1; 1: every
  // sample is held. With 1.1 the star's largest force at a constant removal rate is 1.46 times the
  // straight cut's, with 1.15 it is 1.53, without a bound 1.70; most of the time that means save is
  // saved with 1.15. In contacts shorter than three lengths of the mean every sample is held.
  double most_peak = 1.15;
};

struct FeedParams {
  double feed = 255;          // mm/min, nominal: under a load of share 1
  double maximum_feed = 510;  // mm/min
  double link_feed = 1500;    // mm/min
  FeedSteps steps;
  double mean_length = 0;  // mm: the load is held as a mean over so much of the path, within
                           // steps.most_peak; 0: everywhere
  // 0 to kMostLeastLoad: within a piece below `maximum_feed` no load is a smaller share of the
  // largest, as far as moves can be divided; pieces may then be as short as that asks for.
  double least_load = 0;
};

inline constexpr double kMostLeastLoad = 0.95;

// Every cut at `feed`, every link at `link_feed`.
void set_constant_feed(std::vector<PlanarRun>& runs, const FeedParams& params);

// mm/min: the feed over the share, up to `maximum_feed`.
double allowed_feed(double share, const FeedParams& params);

struct FeedPiece;

// Runs with their feeds, their moves split where those change; and the feed of every sample.
struct FeedsAlong {
  std::vector<PlanarRun> runs;
  std::vector<double> feeds;  // mm/min
};

// Cuts at feeds that no sample's load forbids, or no mean of it, links at `link_feed`. Moves are
// split where the feed changes, as few times as pays: the sum of the time and of a price per added
// block is the least possible (dynamic programming over the samples; nearly, where means are
// held), so that arcs stay whole where a change of feed would save little. Several prices can be
// asked for; stretches that two of them divide alike are taken so in between.
class ConstantLoad {
 public:
  // `runs`, `profile` and `progress`, of which steps are made, must outlive this object; the price
  // in `params` does not count.
  ConstantLoad(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
               const FeedParams& params, Progress* progress = nullptr);
  ~ConstantLoad();

  // `price` s: what one more block must save.
  FeedsAlong at(double price);

 private:
  class Stretch;
  bool is_cut(std::size_t sample) const;
  void divide();
  void add(const FeedPiece& piece, FeedsAlong& found) const;

  const std::vector<PlanarRun>& runs_;
  const std::vector<LoadSample>& profile_;
  FeedParams params_;
  Progress* progress_;
  std::vector<Stretch> stretches_;
};

// The same at the price in `params`, for `runs` themselves. Returns the feed of every sample.
std::vector<double> set_constant_load(std::vector<PlanarRun>& runs,
                                      const std::vector<LoadSample>& profile,
                                      const FeedParams& params, Progress* progress = nullptr);

}  // namespace evenload
