// Passes between two guides, which change from the shape of the one to that of the other.
#pragma once

#include <vector>

#include "support/progress.h"
#include "surface/beside.h"
#include "surface/polylines.h"

namespace evenload {

struct GuidedRows {
  std::vector<std::vector<Polyline>> rows;          // one line each
  double least_stepover = 0, largest_stepover = 0;  // mm, in plan
};

// Lines each of which divides the ways between places at the same share of both guides' lengths
// alike; the first and the last are half a step off the guides. Lines go on straight, and beyond
// the guides there are more of them, by `extension` mm. What follows a line lies to its left.
// Throws std::invalid_argument for guides that are no lines, or that cross.
class Guides {
 public:
  Guides(std::vector<Vec2> first, std::vector<Vec2> second);

  // How many lines keep within `stepover` mm where the guides are furthest apart.
  double count_for(double stepover) const;
  // How many keep within what `beside` tells at all places between the guides, across the lines.
  // Throws Cancelled.
  double count_for(const StepBeside& beside, int threads, Progress& progress) const;

  GuidedRows rows(double count, double extension) const;

 private:
  // A line by the share of its length, 0 to 1.
  class Guide {
   public:
    explicit Guide(std::vector<Vec2> corners);
    Vec2 at(double share) const;
    const std::vector<double>& shares() const { return shares_; }
    double length() const { return length_; }

   private:
    std::vector<Vec2> corners_;
    std::vector<double> shares_;  // of the corners
    double length_ = 0;           // mm
  };
  Vec2 between(double share, double part) const;  // a place of a line
  std::vector<double> stations() const;           // shares of places, kStationsApart at the most
  double lines_at(const StepBeside& beside, double share, double before, double after) const;

  Guide from_, to_;
  std::vector<double> shares_;         // of all corners of both
  double narrowest_ = 0, widest_ = 0;  // mm between the guides
  bool is_turned_ = false;             // the second guide lies to the right of the first
};

}  // namespace evenload
