// How far the next pass may lie beside a place of one, for a cusp height that is wished.
#pragma once

#include <optional>

#include "support/progress.h"
#include "surface/cusp.h"
#include "surface/ground.h"

namespace evenload {

inline constexpr double kStationsApart = 1;  // mm between places at which steps are found

class StepBeside {
 public:
  StepBeside(const Ground& ground, double cusp_height, double deflection)
      : ground_(ground), rule_(ground, cusp_height, deflection) {}

  double level() const { return rule_.level(); }  // mm, on level ground

  // mm in plan from `at` in the direction `across`, of length 1; none where the tool is not at
  // work there. guess: what it was nearby.
  std::optional<double> from(Vec2 at, Vec2 across, double guess) const;

  // mm from `at`, on the border of the picked faces, in the direction `outwards` to the last place
  // where the tool is at work; negative where that lies within the border.
  // Throws Cancelled.
  double reach_beyond(Vec2 at, Vec2 outwards, Progress& progress) const;

 private:
  struct Strip {
    DropSample one, middle, other;
    Vec2 at;  // its middle
    double wide = 0;
  };
  std::optional<Strip> strip_of(Vec2 at, Vec2 across, double width) const;

  const Ground& ground_;
  CuspRule rule_;
};

}  // namespace evenload
