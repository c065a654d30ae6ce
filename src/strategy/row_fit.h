// Rows of tangent moves as fewer arcs, by what the tool meets along them: a linear model, in which
// to turn further left and to be further to the left both mean to meet less.
#pragma once

#include <vector>

#include "geometry/bi_arc.h"

namespace evenload {

// A place of a row.
struct RowPlace {
  double along = 0;   // mm from the row's beginning
  double turned = 0;  // rad to the left since then
  double aside = 0;   // mm: the integral of `turned` along the way
};

// What the tool meets there.
struct RowLook : RowPlace {
  double met = 0;           // rad
  double width = 0;         // mm: area removed per mm of way
  bool leans_left = false;  // more of it lies left of the feed than right of it
};

struct Row {
  PlanePoint from, to;
  std::vector<RowLook> looks;    // in the middle of equal parts of each move
  std::vector<RowPlace> joints;  // where its moves end, the last one too
};

struct RowLimits {
  double most_met = 0;        // rad
  double engagement = 0;      // rad, of a straight cut that the feed is meant for
  double tool_radius = 0;     // mm
  double least_width = 0;     // mm: the feed gets no higher where less is removed
  double shortest = 0;        // mm: no arc is shorter
  double most_curvature = 0;  // 1/mm, of any arc
};

inline constexpr std::size_t kMostArcs = 4;

// mm^2: what a row's moves, each at one feed, could remove and do not; less a share of what they do
// remove, which then is not left to other passes.
double unused_area(const Row& row, double least_width);

// `count` arcs, 2 to kMostArcs, from where the row begins to where it ends, in the same directions,
// and each tangent to the next: those found that are expected to leave the least area unused among
// such as are expected to meet no more than the limits allow. `unused`: that area; large where the
// limits cannot be kept. Empty where there are none. Condition: the row has as many moves, or one
// or two more.
std::vector<Segment> fit_row(const Row& row, std::size_t count, const RowLimits& limits,
                             double* unused);

}  // namespace evenload
