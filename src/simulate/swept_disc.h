// The ground that a disc sweeps along a line or arc, row by row, exact: the discs at both ends, and
// the strip or ring sector between them.
#pragma once

#include "geometry/curve.h"

namespace evenload {

class SweptDisc {
 public:
  struct Interval {
    double low = 0, high = 0;
  };
  // An interval for each end and two for a ring sector, before those that overlap are joined.
  static constexpr int kMostIntervals = 4;

  // Condition: an arc turns by half a circle at the most.
  SweptDisc(const Segment& path, double radius);

  Bounds bounds() const;  // a box that holds it
  // Where the row at height y meets it: intervals in order that do not touch, and their number.
  int on_row(double y, Interval (&out)[kMostIntervals]) const;

 private:
  int line_on_row(double y, Interval (&out)[kMostIntervals]) const;
  int arc_on_row(double y, Interval (&out)[kMostIntervals]) const;

  Segment path_;
  double radius_;
  Vec2 side_;          // lines: from the path to the strip's left border
  Vec2 first_, last_;  // arcs: unit vectors from the centre to the ends, counter-clockwise
};

// The same seen in a mirror that swaps x and y: columns become rows.
Segment mirrored(const Segment& path);

}  // namespace evenload
