#include "strategy/lame/lame_refusals.h"

#include <iomanip>
#include <sstream>

namespace evenload {
namespace {

std::string part_of_pocket(double share) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << 100 * share << " % of this pocket";
  return text.str();
}

}  // namespace

std::string no_curve_sentence(const Curve& outline, const LameWishes& w) {
  if (w.centre && !outline.contains(*w.centre))
    return "Centre lies outside the pocket: move it inside, or leave it unset.";
  if (w.centre || w.segments || w.semi_axis_a || w.semi_axis_b || w.exponent || w.rotation)
    return "With the set properties no Lamé curve keeps clear of the walls: leave some of them "
           "unset, or take the operation Adaptive.";
  return "No Lamé curve resembles this pocket: take the operation Adaptive.";
}

std::string small_share_sentence(double share, const LameParams& lame) {
  const std::string cleared = part_of_pocket(share);
  if (lame.centre)
    return "With this Centre the largest spiral would clear " + cleared +
           ": move Centre towards the middle, leave it unset, or take the operation Adaptive.";
  if (lame.segments || lame.exponent_end || lame.rotation)
    return "With the set Segments, ExponentEnd or Rotation the largest spiral would clear " +
           cleared + ": leave them unset, or take the operation Adaptive.";
  return "A Lamé spiral would clear only " + cleared + ": take the operation Adaptive.";
}

}  // namespace evenload
