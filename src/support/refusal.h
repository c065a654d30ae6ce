// Why geometry is refused, without words: evenload.refusals says the sentences.
#pragma once

namespace evenload {

enum class GeometryErrorCode {
  kNotFinite,      // a coordinate or bulge is NaN or infinite
  kTooFewPoints,   // a closed curve that bounds no area
  kOpen,           // a chain that should be closed is not
  kSelfCrossing,   // a curve crosses or touches itself, or two curves of one region cross
  kIslandOutside,  // an island that does not lie inside its outer boundary
  kToolTooLarge,   // the tool fits nowhere
  kEntryOutside,   // an entry point or pre-drilled hole that cannot be used
  kNoLameCurve,    // a pocket that no Lamé curve resembles
};

// Behind each: the numbers that come with it, in this order. A curve's number is 0 for the outline,
// else that of the island, from 1.
enum class Refusal {
  // Outlines
  kCurveNotFinite,        // after the place; curve
  kCurveNotClosed,        // ends at the place; curve, x and y of its start, mm
  kCurveWithoutArea,      // curve
  kOutlineCrossesItself,  // or touches itself, as in the next three
  kIslandCrossesItself,   // curve
  kOutlineCrossesIsland,  // curve
  kIslandsCross,          // two curves
  kIslandOutsideOutline,  // curve
  kIslandInsideAnother,   // two curves, the outer one last
  // Middles of slots
  kMiddleNotFinite,        // no place
  kMiddleWithoutLength,    // no line and no arc
  kMiddleCrossesItself,    // or touches
  kMiddleBendsTooTightly,  // for half the slot's width
  kSlotSidesMeet,          // far apart along the middle
  // Room for the tool
  kToolFitsNowhere,  // no place; diameter of the tool and of the largest that fits, or 0, mm
  kNoRoomToDescend,  // by any entry
  // Pre-drilled holes that must be the entry
  kHoleOutOfReach,         // too near to a wall, or outside
  kHoleInSkippedPassage,   // a narrow one
  kHoleTooTight,           // to start from
  kHoleOutsidePocket,      // the region of a spiral
  kHoleTooTightForSpiral,  // at the engagement angle
  kHoleOffMiddle,          // no spiral leads from there to the walls
  kHoleBesideChannel,      // a spiral around an island begins beside its wall
  kHoleAtIsland,           // a spiral around an island in open stock comes from outside
  // Lamé spirals
  kNotForSpirals,           // islands and open edges
  kCentreOutside,           // the set one
  kNoCurveAsSet,            // keeps clear of the walls
  kNoCurve,                 // resembles the pocket
  kSetSizeTooSmall,         // to grow from the entry
  kSpiralTooSmall,          // share of the pocket that it would clear
  kSpiralTooSmallAtCentre,  // the same, for the set centre
  kSpiralTooSmallAsSet,     // the same, for another set value
  kNoRoomForSpiral,         // between island and wall
  kNoGrowth,                // from one outline to the other
  kNoGrowthByCourses,       // the same, for set courses
  kNoLoad,                  // that keeps to the engagement angle
  kNoLoadByCourses,         // the same, for set courses
  kTwoCourses,              // of the semi-axes, of a curve that has one
};

GeometryErrorCode code_of(Refusal refusal);
const char* name_of(GeometryErrorCode code);  // in words
const char* name_of(Refusal refusal);         // snake_case

}  // namespace evenload
