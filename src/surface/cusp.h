// What stands between two passes side by side, and how far they may be apart for a height of it.
#pragma once

#include <functional>

#include "surface/ground.h"

namespace evenload {

// What stands between two passes of a ball, or of a rounded corner, on level ground, mm; and how
// far passes may be apart, in mm, where a height is wished. stepover: up to twice the corner.
double cusp_of(double corner, double stepover);
double stepover_for(double corner, double cusp_height);

// Between the centres c1, c2 of the corner's circle on two passes and cm midway, at one place along
// them, stand r - sqrt(r^2 - w^2/4) - e: w is the distance of c1 and c2 across the feed, e how far
// cm lies above their middle, along the normal. This is exact for a ball on all ground whose
// curvature is the same across the strip, and more than what stands for a tool with a flat. w and e
// are found on a wider strip, so that `deflection`, by which triangles leave the part, in mm,
// counts for little.
class CuspRule {
 public:
  // Condition: the tool's corner is not 0, nor the wish.
  CuspRule(const Ground& ground, double cusp_height, double deflection);

  double level() const { return level_; }  // mm, of passes on level ground

  // mm: how wide a strip is to be looked at for one of some width, where faces are as wide as that.
  double strip_for(double width, double covered) const;

  // mm: what stands between passes that are `width` apart, from the heights of the tip on both
  // sides and in the middle of a strip of `wide`; `slope`: of the feed. Infinitely little where the
  // strip is so steep that no pass helps.
  double height(double width, double wide, double one, double middle, double other,
                double slope) const;

  // mm: the largest width whose height, which `height_of` tells, is the wish; the level one where
  // it tells kNothing. guess: where to begin.
  double widest(double guess, const std::function<double(double)>& height_of) const;

  static constexpr double kNothing = -HUGE_VAL;

 private:
  double wish_, corner_, level_;
  double widening_;  // of a strip, to find its curvature in spite of the triangles
};

}  // namespace evenload
