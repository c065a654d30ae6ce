// How far apart the turns of a Lamé spiral lie: as far as the limit of the engagement allows.
//
// At every stage of a growth the step to the turn before is the largest at which no place of the
// turn exceeds the limit [Jacsó 2021, Thesis I gives it for circles; Tancsa 2023 takes a constant
// step]. How soon the exponent leaves the circle decides how evenly the turns are filled; of a few
// runs the one with the least time is chosen.
//
// Laws: around a circle the step is the one of Thesis I; a wished pitch is never exceeded; a spiral
// begins tangent to the growth's first curve and ends with a full turn on its last, off which it
// may turn in the end. A set course of the exponent is the only one that is tried.
#pragma once

#include <optional>
#include <vector>

#include "strategy/lame/lame_spiral.h"
#include "support/progress.h"

namespace evenload {

struct TurnTask {
  double tool_radius = 3;       // mm
  double engagement = kPi / 3;  // rad
  bool inwards = false;         // clockwise, from outside in
  std::optional<double> pitch;  // mm per turn of the larger change of the semi-axes, at most
  // min/mm by the width that is cut, mm; without it the removal rate is constant at these feeds.
  std::optional<MonotoneSpline> pace;
  double feed = 255;             // mm/min at the engagement
  double maximum_feed = 510;     // mm/min where there is less; `feed` for a constant feed
  double tolerance = 0.004;      // mm, of the arcs
  double block_price = 0.02;     // s that one more block must save, > 0
  Progress* progress = nullptr;  // of which steps are made
};

// The largest change of the growth's share from one turn to the next, by the share that is reached.
// Turns are nearly closed curves, and are looked at as such.
MonotoneSpline largest_steps(const LameGrowth& growth, const TurnTask& task);

// s: what the turns take with these steps, nearly, and their blocks at the task's price.
double time_of(const LameGrowth& growth, const MonotoneSpline& steps, const TurnTask& task);

struct PlannedGrowth {
  LameGrowth growth;
  MonotoneSpline steps;  // its largest_steps()
};

// Of the growths that never leave the room between their first and last curve the one with the
// least time; growths of one stage with the best of a few runs. Nothing where there is none.
std::optional<PlannedGrowth> best_growth(const std::vector<LameGrowth>& growths,
                                         const TurnTask& task);

// The spiral with these steps, `start` rad being the polar angle where it begins. After its full
// turn on the last curve it turns off that curve by `off` mm, to where nothing is left. `pitch`: mm
// that courses of the semi-axes are not to exceed between two places where steps are known. Throws
// std::invalid_argument where it would take more than kMostTurns turns.
LameSpiral spiral_of(const LameGrowth& growth, const MonotoneSpline& steps, double start,
                     bool inwards, double off = 0, std::optional<double> pitch = {});
inline constexpr double kMostTurns = 2000;

}  // namespace evenload
