// The pattern of constant engagement along a slot [Jacsó 2021, Thesis IV].
//
// Passes are steered one after the other along the slot from a round front on, each from the
// right wall to the left one. Each changes the front that the next one meets, and their shape
// settles; the pattern repeats it with the greatest step that keeps the limit. The tighter the
// roll-in and roll-out the sooner a pass is at its full engagement, and the longer its way back:
// of a few turn radii up to the wish that with the greatest removal rate is taken. The source has
// one roll radius.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "strategy/trochoid/trochoid_period.h"

namespace evenload {

// Nothing where the slot is too narrow for a pass to turn in. Throws as check() does.
std::optional<TrochoidPattern> constant_engagement_pattern(const TrochoidParams& params);

// Passes one behind the other, of which a pattern's cleared ground is made.
struct SlotFront {
  // Of the tool's centre, from the right wall, at the pattern's origin, across to the left one.
  std::vector<Segment> way;
  double step = 0;  // mm along the middle; 0: nothing is known of the passes before
};

// The search for the turn radius, for those who have patterns of several widths to choose from.
class TurnSearch {
 public:
  // The passes begin at a front that others have settled to, which saves most of them: `like` are
  // those of another width. Throws as check() does.
  explicit TurnSearch(const TrochoidParams& params, const TurnSearch* like = nullptr);

  struct Found {
    TrochoidPattern pattern;
    PatternFigures figures;
    bool turns_at_corners = false;
    StepGuess guess;  // of the greatest step
  };
  // With the radius that is likely to be the best, or where that does not serve, the next that
  // does; its step is a little below the greatest.
  const Found* first();
  // The best of those that are reached from the first one on as long as each is better: without
  // turns that posts write as lines if there are such, and with the greatest removal rate.
  std::optional<Found> best();

 private:
  struct Settled {
    Found found;
    SlotFront front;  // that it leaves
  };
  const Found* likely_best();
  std::optional<Settled> settle(double radius, const SlotFront& start) const;
  const Found* take(std::size_t i, std::optional<Settled> settled);
  const Found* with_radius(std::size_t i);
  void try_beside(std::size_t i);
  static bool is_better(const Found& a, const Found& b);

  TrochoidParams params_;
  SlotFront start_;            // of the next passes
  std::vector<double> radii_;  // mm, ascending
  std::size_t first_ = 0;      // where the search begins
  std::map<std::size_t, std::optional<Found>> tried_;
};

// The passes from the round front on, for pictures and tests: cuts without links, in the frame
// of the first, and how their advance differed from place to place.
struct PassSequence {
  std::vector<std::vector<Segment>> passes;
  std::vector<double> residuals;  // mm, from the second pass on
  double advance = 0;             // mm, of the last pass
};
// Until the residual is below kSettled tool radii, or `most` passes. Empty where no pass can turn.
PassSequence iterate_passes(const TrochoidParams& params, double turn_radius, int most);
inline constexpr double kSettled = 1e-3;

}  // namespace evenload
