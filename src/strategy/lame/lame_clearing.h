// Clears pockets with Lamé spirals [Tancsa 2023]: one spiral from the entry's circle out to the
// largest Lamé curve that fits, itself without a link or a retract; around an island from outside
// in. What it cannot reach, corners and crescents along the walls, is cleared at constant
// engagement.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/lame_curve.h"
#include "geometry/region.h"
#include "strategy/pocket/constant_engagement.h"
#include "support/progress.h"
#include "toolpath/toolpath.h"

namespace evenload {

enum class LameRest { kClear, kLeave };

// What is set is kept; what is not is fitted. All of it describes the way of the tool's centre.
struct LameParams {
  std::optional<int> segments;                     // m, 3 to 12
  std::optional<double> semi_axis_a, semi_axis_b;  // mm, > 0, of the last turn
  std::optional<double> exponent_start;            // n of the first turn, 0.05 to 1; unset: 1
  std::optional<double> exponent_end;              // n of the last turn, 0.05 to 1
  std::optional<double> rotation;                  // rad, of the first semi-axis
  std::optional<double> pitch;                     // mm per turn, > 0, at most
  std::optional<Vec2> centre;                      // of the last turn
  // How the semi-axes and the exponent come from those of the first turn to those of the last:
  // shares of the change at even steps of the way, from 0 to 1, never falling, 2 to kMostCourse of
  // them. A monotone spline runs through them. Empty: semi-axes change evenly, the exponent as is
  // quicker. With courses islands and rings have no circle between their first and last turn.
  // Where no semi-axis and no rotation is set, A is then the longer axis, of equal ones that nearer
  // to X; but for four segments both axes have one course.
  std::vector<double> semi_axis_a_course, semi_axis_b_course, exponent_course;
  LameRest rest = LameRest::kClear;

  bool has_axis_courses() const {
    return !semi_axis_a_course.empty() || !semi_axis_b_course.empty();
  }
  bool has_courses() const { return has_axis_courses() || !exponent_course.empty(); }
};
inline constexpr std::size_t kMostCourse = 20;

// The curve in which a spiral ends, and how it came there.
struct LameFigures {
  LameCurve last;             // of the tool's centre
  double exponent_start = 1;  // of the first turn
  double pitch = 0;           // mm: the largest step of a turn
};

struct LameToolpath : Toolpath {
  double cleared_share = 0;            // of the ground within reach, by spirals
  std::optional<LameFigures> figures;  // of the spiral that clears most; nothing where none is made
};

// Laws: as for clear_pocket; the engagement angle and the parameters of both strategies are kept;
// no turn of a spiral is tighter than the minimum radius, but for entries that are, and for what
// set exponents and courses demand, which the report tells. Throws
// std::invalid_argument for parameters out of range and for rest machining, GeometryError also for
// pockets that no Lamé curve resembles: those of which it would reach less than kLeastShare, rings
// of which the spiral would clear less than kLeastRingShare beside the channel that it begins from,
// and those with more than one island or with open pieces beside walls.
LameToolpath clear_with_lame_spiral(const std::vector<Region>& regions,
                                    const ClearingParams& clearing, const LameParams& params,
                                    Progress& progress);
inline constexpr double kLeastShare = 0.4, kLeastRingShare = 0.25;

}  // namespace evenload
