// What the user should know about a path, without words: evenload.findings says the sentences.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vec2.h"

namespace evenload {

// Behind each: whether there is a place, and the numbers, in this order.
enum class FindingCode {
  // What is left
  kLeftUncut,            // place; mm^2
  kLeftWithoutWallPass,  // place; mm^2
  kLeftBesideSpiral,     // mm^2
  kPocketSkipped,        // place; diameter of the tool and of the largest that fits, or 0, mm
  kRegionWithoutHole,    // place
  kNothingLeft,          // nothing was there to cut
  kCancelled,            // not all was cut
  // Entries
  kRegionWithOwnEntry,      // place
  kHoleInSkippedPassage,    // place
  kHoleTooNearWall,         // place
  kHoleTooTight,            // too tight to start from
  kHoleBesideIsland,        // a spiral around an island begins beside its wall
  kHoleInOpenStock,         // a spiral around an island in open stock comes from outside
  kOpenEdgesTakenForWalls,  // place
  kRampForHelix,            // no helix fits
  kHelixForRamp,            // no cut leads on from a ramp
  kHelixForSpiral,          // the spiral begins as a circle
  kHelixNarrowed,           // diameter that was asked for, and that was taken, mm
  // Turns and loads
  kTightTurns,   // place; tightest radius and the wished one, mm; rooms with such turns
  kThickChips,   // place; times the thickness of a straight cut at the engagement angle
  kStrongForce,  // place
  // Narrow passages
  kPassageSkipped,           // place; width and what stays uncut, mm and mm^2
  kPassageSkippedTooNarrow,  // the same: too narrow for trochoids
  kPassageReduced,           // place; width, mm; left, mm^2; engaged, rad; lowest feed, mm/min
  kPassageReducedTooNarrow,  // the same: too narrow for trochoids
  kRestByTrochoids,          // not at a reduced feed
  // Spirals
  kSpiralOfSetSize,      // share of the pocket that it clears
  kSpiralAfterChannel,   // share of the pocket that it clears
  kSmallPitch,           // smallest, mm
  kTightSpiral,          // tightest radius, mm
  kIdleCourse,           // ExponentCourse changes nothing
  kNoSpiral,             // narrow passages are cleared otherwise
  kRegionWithoutSpiral,  // the same where other regions have one
  kSlowSpiral,           // at a constant feed
  // Slots: why no pattern is repeated. Place; the TrochoidKind that was asked for
  kNoPatternAfterCuts,
  kNoPatternBetweenWalls,
  kNoPatternSoWide,
  kNoPatternSoShort,
  kNoPatternWithoutRoom,
  kNoPatternWithoutStart,
  kCirclesForPattern,  // place
  kAdvanceUnsettled,   // passes; difference across the slot, mm
};

struct Finding {
  FindingCode code;
  std::optional<Vec2> where = {};  // mm, as the user sees it
  std::vector<double> numbers = {};

  bool operator==(const Finding&) const = default;
};

}  // namespace evenload
