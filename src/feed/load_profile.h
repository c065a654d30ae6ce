// What the tool meets along a finished planar path, looked at anew from the moves alone.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "cutting/cleared_ground.h"
#include "toolpath/planar.h"

namespace evenload {

// What the tool meets at one place of a cut.
struct Load {
  double engagement = 0;  // rad in the leading half circle
  double width = 0;       // mm: area removed per mm of path
  double chip = 0;        // the largest chip thickness, as a share of the feed per tooth
  double share = 0;       // what a LoadShare says
};

// What a feed control holds: the nominal feed over the feed that is allowed under a load. The
// engaged arcs are angles from the feed, left positive, from -pi/2 to pi/2.
using LoadShare = std::function<double(const Load&, const std::vector<AngularInterval>&)>;

// The same, and where the front ends on the left that is met: where that is all in one piece, from
// the tool's side on.
struct LoadAtPlace {
  Load load;
  std::optional<Vec2> edge;
};

struct LoadSample {
  std::size_t run = 0, move = 0;  // where
  double t = 0;                   // parameter on the move, middle of the piece
  double length = 0;              // mm of path that it stands for
  double engagement = 0;          // rad in the leading half circle, mean over the piece
  double width = 0;               // mm: area removed per mm of path, mean over the piece
  double chip = 0;                // as Load has it, the largest on the piece
  double share = 0;               // likewise
};

// So many times as far apart are the first looks where the front is smooth, and hides no cusp; not
// more, since a later pass may have bitten into it between them: with 5 a rate of 1.057 was seen in
// place of 1.046.
inline constexpr double kSmoothSpacing = 2.5;

// The load along a path that is told move by move, in pieces of at most `spacing` mm, shorter where
// it changes, up to kSmoothSpacing times that where the front is smooth.
class LoadProfiler {
 public:
  // `ground`: what was cleared before; moves and descents are added to it. Both references must
  // outlive this object. Without a `share` the samples' shares are 0.
  LoadProfiler(ClearedGround& ground, double spacing, const LoadShare& share)
      : ground_(ground), spacing_(spacing), share_(share) {}

  // The next run begins.
  void come_down(const Descent& descent);
  // The next move of the run.
  void look_along(const PlanarMove& move);
  // The same, but for its load: it is made. Condition: the next move that is looked along does not
  // run on from it without a turn.
  void pass_by(const PlanarMove& move);

  // What was found, once all is told.
  std::vector<LoadSample> taken() { return std::move(profile_); }

 private:
  ClearedGround& ground_;
  double spacing_;
  const LoadShare& share_;
  std::size_t runs_ = 0, moves_ = 0;  // so far, of the last run
  std::optional<PlanarMove> before_;  // in this run
  LoadAtPlace met_;                   // where it ends, if it cuts
  std::vector<LoadSample> profile_;
};

// The load along every move of `runs`, in pieces of at most `spacing` mm, shorter where it changes,
// up to kSmoothSpacing times that where the front is smooth.
// The moves are added to `ground`, which holds what was cleared before; each run's descent is added
// first. Without a `share` the samples' shares are 0. `progress`: that `ground` tells of its looks,
// if it does.
std::vector<LoadSample> load_profile(const std::vector<PlanarRun>& runs, ClearedGround& ground,
                                     double spacing, const LoadShare& share = nullptr,
                                     Progress* progress = nullptr);

// Adds the ground that a helix or ramp clears.
void add_descent(const Descent& descent, ClearedGround& ground);

// rad: the largest mean over `window` mm of path of the engagement of cutting moves.
double worst_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                        double window);

}  // namespace evenload
