#include "support/refusal.h"

#include <cstddef>
#include <iterator>

namespace evenload {
namespace {

using Code = GeometryErrorCode;

struct RefusalRow {
  Refusal refusal;
  GeometryErrorCode code;
  const char* name;
};

// In the order of Refusal.
constexpr RefusalRow kRefusals[] = {
    {Refusal::kCurveNotFinite, Code::kNotFinite, "curve_not_finite"},
    {Refusal::kCurveNotClosed, Code::kOpen, "curve_not_closed"},
    {Refusal::kCurveWithoutArea, Code::kTooFewPoints, "curve_without_area"},
    {Refusal::kOutlineCrossesItself, Code::kSelfCrossing, "outline_crosses_itself"},
    {Refusal::kIslandCrossesItself, Code::kSelfCrossing, "island_crosses_itself"},
    {Refusal::kOutlineCrossesIsland, Code::kSelfCrossing, "outline_crosses_island"},
    {Refusal::kIslandsCross, Code::kSelfCrossing, "islands_cross"},
    {Refusal::kIslandOutsideOutline, Code::kIslandOutside, "island_outside_outline"},
    {Refusal::kIslandInsideAnother, Code::kIslandOutside, "island_inside_another"},
    {Refusal::kMiddleNotFinite, Code::kNotFinite, "middle_not_finite"},
    {Refusal::kMiddleWithoutLength, Code::kTooFewPoints, "middle_without_length"},
    {Refusal::kMiddleCrossesItself, Code::kSelfCrossing, "middle_crosses_itself"},
    {Refusal::kMiddleBendsTooTightly, Code::kSelfCrossing, "middle_bends_too_tightly"},
    {Refusal::kSlotSidesMeet, Code::kSelfCrossing, "slot_sides_meet"},
    {Refusal::kToolFitsNowhere, Code::kToolTooLarge, "tool_fits_nowhere"},
    {Refusal::kNoRoomToDescend, Code::kToolTooLarge, "no_room_to_descend"},
    {Refusal::kHoleOutOfReach, Code::kEntryOutside, "hole_out_of_reach"},
    {Refusal::kHoleInSkippedPassage, Code::kEntryOutside, "hole_in_skipped_passage"},
    {Refusal::kHoleTooTight, Code::kEntryOutside, "hole_too_tight"},
    {Refusal::kHoleOutsidePocket, Code::kEntryOutside, "hole_outside_pocket"},
    {Refusal::kHoleTooTightForSpiral, Code::kEntryOutside, "hole_too_tight_for_spiral"},
    {Refusal::kHoleOffMiddle, Code::kEntryOutside, "hole_off_middle"},
    {Refusal::kHoleBesideChannel, Code::kEntryOutside, "hole_beside_channel"},
    {Refusal::kHoleAtIsland, Code::kEntryOutside, "hole_at_island"},
    {Refusal::kNotForSpirals, Code::kNoLameCurve, "not_for_spirals"},
    {Refusal::kCentreOutside, Code::kNoLameCurve, "centre_outside"},
    {Refusal::kNoCurveAsSet, Code::kNoLameCurve, "no_curve_as_set"},
    {Refusal::kNoCurve, Code::kNoLameCurve, "no_curve"},
    {Refusal::kSetSizeTooSmall, Code::kNoLameCurve, "set_size_too_small"},
    {Refusal::kSpiralTooSmall, Code::kNoLameCurve, "spiral_too_small"},
    {Refusal::kSpiralTooSmallAtCentre, Code::kNoLameCurve, "spiral_too_small_at_centre"},
    {Refusal::kSpiralTooSmallAsSet, Code::kNoLameCurve, "spiral_too_small_as_set"},
    {Refusal::kNoRoomForSpiral, Code::kNoLameCurve, "no_room_for_spiral"},
    {Refusal::kNoGrowth, Code::kNoLameCurve, "no_growth"},
    {Refusal::kNoGrowthByCourses, Code::kNoLameCurve, "no_growth_by_courses"},
    {Refusal::kNoLoad, Code::kNoLameCurve, "no_load"},
    {Refusal::kNoLoadByCourses, Code::kNoLameCurve, "no_load_by_courses"},
    {Refusal::kTwoCourses, Code::kNoLameCurve, "two_courses"},
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < std::size(kRefusals); ++i)
    if (kRefusals[i].refusal != static_cast<Refusal>(i)) return false;
  return std::size(kRefusals) == static_cast<std::size_t>(Refusal::kTwoCourses) + 1;
}
static_assert(is_in_order());

const RefusalRow& row_of(Refusal refusal) { return kRefusals[static_cast<std::size_t>(refusal)]; }

}  // namespace

GeometryErrorCode code_of(Refusal refusal) { return row_of(refusal).code; }

const char* name_of(Refusal refusal) { return row_of(refusal).name; }

const char* name_of(GeometryErrorCode code) {
  switch (code) {
    case Code::kNotFinite:
      return "not finite";
    case Code::kTooFewPoints:
      return "too few points";
    case Code::kOpen:
      return "open";
    case Code::kSelfCrossing:
      return "self-crossing";
    case Code::kIslandOutside:
      return "island outside";
    case Code::kToolTooLarge:
      return "tool too large";
    case Code::kEntryOutside:
      return "entry outside";
    case Code::kNoLameCurve:
      return "no lame curve";
  }
  return "unknown";
}

}  // namespace evenload
