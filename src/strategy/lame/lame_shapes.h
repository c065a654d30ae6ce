// The first and last curves of Lamé spirals, fitted to outlines with what the user has set.
//
// Laws: those of fit_lame_curve; unless an exponent is set, no corner is tighter than the minimum
// radius, nor than kCornerRadius; inside an outline a curve whose size is not set is no longer than
// kLongest times its width. For courses the first axis of a last curve of four segments is
// the longer one, of equal ones that nearer to the X axis, unless a semi-axis or the rotation is
// set: so it is the same in the mirrored work of conventional milling.
#pragma once

#include <optional>
#include <vector>

#include "strategy/lame/lame_clearing.h"
#include "strategy/lame/lame_fit.h"
#include "strategy/task/clearing_params.h"

namespace evenload {

// Tool radii: the spiral's corners are no tighter, although the minimum radius may be: around
// tighter ones most of each turn would be idle, and what is left in the corners is little.
inline constexpr double kCornerRadius = 1.2;
// The spiral is no longer than this times its width: a longer one cuts with its ends only.
inline constexpr double kLongest = 2;

class LameShapes {
 public:
  // `margin` mm: the curves stay this far from outlines. Both parameters must outlive this.
  LameShapes(const ClearingParams& params, const LameParams& lame, double margin);

  bool has_wished_size() const { return lame_.semi_axis_a || lame_.semi_axis_b; }
  // What is set of a last curve, and of a first one, of which only the exponent can be.
  LameWishes last_wishes() const;
  LameWishes first_wishes() const;

  // Nothing where no curve fits.
  std::optional<LameCurve> last(const Curve& outline, LameSide side) const;
  // The first curve of an island's or a ring's spiral; around the outline.
  std::optional<LameCurve> first(const Curve& outline) const;
  // The same with another curve's segments and rotation: it goes over into that one without a
  // circle.
  std::optional<LameCurve> first_like(const LameCurve& other, const Curve& outline) const;

  // The last curve itself, and, unless its exponent is set or what they leave is not cleared,
  // rounder ones about its middle: their turns are filled more evenly, and leave more to clear.
  std::vector<LameCurve> with_rounder_ones(const LameCurve& last, const Curve& outline,
                                           LameSide side) const;

 private:
  LameFitTask task(LameSide side, const LameWishes& wishes) const;
  // Of a last curve: no longer than it may be.
  std::optional<LameCurve> fitted(const Curve& outline, LameFitTask fit) const;

  const ClearingParams& params_;
  const LameParams& lame_;
  double margin_;
};

}  // namespace evenload
