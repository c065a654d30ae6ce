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

std::string small_size_note(double share) {
  return "The spiral clears only " + part_of_pocket(share) + ", for SemiAxisA or SemiAxisB is set.";
}

std::string channel_note(double share) {
  return "The spiral clears only " + part_of_pocket(share) +
         ": the channel along its island, from which it begins, takes most of the rest.";
}

std::string small_pitch_note(double pitch) {
  std::ostringstream note;
  note << std::fixed << std::setprecision(3) << "Pitch is smaller than set in some turns, down to "
       << pitch << " mm: the engagement angle allows no more there.";
  return note.str();
}

std::string tight_turn_note(double radius) {
  std::ostringstream note;
  note << std::fixed << std::setprecision(3)
       << "The spiral turns more tightly than MinimumRadius, down to " << radius
       << " mm: raise ExponentStart or ExponentEnd, or make the courses more even.";
  return note.str();
}

}  // namespace evenload
