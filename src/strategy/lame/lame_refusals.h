// What is said where no Lamé spiral is made, or another one than was set: each sentence names the
// setting that is in the way, or the operation that clears the pocket instead.
#pragma once

#include <string>

#include "strategy/lame/lame_clearing.h"
#include "strategy/lame/lame_fit.h"

namespace evenload {

inline constexpr const char* kKinds =
    "A Lamé spiral clears pockets without islands, or with one island and an outline that is all "
    "wall or all open: take the operation Adaptive.";
inline constexpr const char* kNoLoad =
    "No Lamé spiral keeps to the engagement angle in this pocket: take the operation Adaptive.";
inline constexpr const char* kNoGrowth =
    "No Lamé spiral leads from one outline of this pocket to the other: take the operation "
    "Adaptive.";
inline constexpr const char* kNoRoom =
    "Between the walls there is too little room for a Lamé spiral: take the operation Adaptive.";
inline constexpr const char* kSizeTooSmall =
    "SemiAxisA and SemiAxisB leave no room for a spiral around its entry: set larger ones, or "
    "leave them unset.";

// Of courses.
inline constexpr const char* kTwoCourses =
    "Only curves of four segments have two courses: set SemiAxisACourse and SemiAxisBCourse to the "
    "same values, or leave one of them empty.";
inline constexpr const char* kNoCourse =
    "With these courses no Lamé spiral leads from its first turn to its last: leave "
    "SemiAxisACourse, SemiAxisBCourse and ExponentCourse empty, or take the operation Adaptive.";
inline constexpr const char* kNoLoadOfCourse =
    "With these courses no Lamé spiral keeps to the engagement angle: make SemiAxisACourse, "
    "SemiAxisBCourse and ExponentCourse more even, or leave them empty.";

// Of pre-drilled holes.
inline constexpr const char* kHoleOutside =
    "The pre-drilled hole lies outside this pocket: choose the entry 'Automatic', or another hole.";
inline constexpr const char* kHoleTooTight =
    "The pre-drilled hole is too tight to start a spiral from: drill it wider, move EntryPoint "
    "towards the middle, or choose the entry 'Helix'.";
inline constexpr const char* kHoleOffMiddle =
    "No Lamé spiral leads from the pre-drilled hole to the pocket's walls: move EntryPoint towards "
    "the middle, or choose the entry 'Helix'.";
inline constexpr const char* kHoleBesideChannel =
    "A Lamé spiral around an island begins beside its wall: drill the hole there, or choose the "
    "entry 'Automatic'.";
inline constexpr const char* kHoleAtIsland =
    "A Lamé spiral around an island in open stock comes from outside, not from a hole: choose the "
    "entry 'Automatic'.";

// Where no curve fits into an outline with these wishes.
std::string no_curve_sentence(const Curve& outline, const LameWishes& wishes);
// Where the spiral would clear too small a share.
std::string small_share_sentence(double share, const LameParams& lame);

}  // namespace evenload
