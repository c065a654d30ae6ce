#include "python/findings.h"

namespace py = pybind11;

namespace evenload {

namespace {

const char* finding_name(FindingCode code) {
  switch (code) {
    case FindingCode::kLeftUncut:
      return "left_uncut";
    case FindingCode::kLeftWithoutWallPass:
      return "left_without_wall_pass";
    case FindingCode::kLeftBesideSpiral:
      return "left_beside_spiral";
    case FindingCode::kPocketSkipped:
      return "pocket_skipped";
    case FindingCode::kRegionWithoutHole:
      return "region_without_hole";
    case FindingCode::kNothingLeft:
      return "nothing_left";
    case FindingCode::kCancelled:
      return "cancelled";
    case FindingCode::kRegionWithOwnEntry:
      return "region_with_own_entry";
    case FindingCode::kHoleInSkippedPassage:
      return "hole_in_skipped_passage";
    case FindingCode::kHoleTooNearWall:
      return "hole_too_near_wall";
    case FindingCode::kHoleTooTight:
      return "hole_too_tight";
    case FindingCode::kHoleBesideIsland:
      return "hole_beside_island";
    case FindingCode::kHoleInOpenStock:
      return "hole_in_open_stock";
    case FindingCode::kOpenEdgesTakenForWalls:
      return "open_edges_taken_for_walls";
    case FindingCode::kRampForHelix:
      return "ramp_for_helix";
    case FindingCode::kHelixForRamp:
      return "helix_for_ramp";
    case FindingCode::kHelixForSpiral:
      return "helix_for_spiral";
    case FindingCode::kHelixNarrowed:
      return "helix_narrowed";
    case FindingCode::kTightTurns:
      return "tight_turns";
    case FindingCode::kThickChips:
      return "thick_chips";
    case FindingCode::kStrongForce:
      return "strong_force";
    case FindingCode::kPassageSkipped:
      return "passage_skipped";
    case FindingCode::kPassageSkippedTooNarrow:
      return "passage_skipped_too_narrow";
    case FindingCode::kPassageReduced:
      return "passage_reduced";
    case FindingCode::kPassageReducedTooNarrow:
      return "passage_reduced_too_narrow";
    case FindingCode::kRestByTrochoids:
      return "rest_by_trochoids";
    case FindingCode::kSpiralOfSetSize:
      return "spiral_of_set_size";
    case FindingCode::kSpiralAfterChannel:
      return "spiral_after_channel";
    case FindingCode::kSmallPitch:
      return "small_pitch";
    case FindingCode::kTightSpiral:
      return "tight_spiral";
    case FindingCode::kIdleCourse:
      return "idle_course";
    case FindingCode::kNoSpiral:
      return "no_spiral";
    case FindingCode::kRegionWithoutSpiral:
      return "region_without_spiral";
    case FindingCode::kSlowSpiral:
      return "slow_spiral";
    case FindingCode::kNoPatternAfterCuts:
      return "no_pattern_after_cuts";
    case FindingCode::kNoPatternBetweenWalls:
      return "no_pattern_between_walls";
    case FindingCode::kNoPatternSoWide:
      return "no_pattern_so_wide";
    case FindingCode::kNoPatternSoShort:
      return "no_pattern_so_short";
    case FindingCode::kNoPatternWithoutRoom:
      return "no_pattern_without_room";
    case FindingCode::kNoPatternWithoutStart:
      return "no_pattern_without_start";
    case FindingCode::kCirclesForPattern:
      return "circles_for_pattern";
    case FindingCode::kAdvanceUnsettled:
      return "advance_unsettled";
  }
  return "";
}

}  // namespace

py::list findings_for_python(const std::vector<Finding>& findings) {
  py::list result;
  for (const Finding& finding : findings) {
    py::object where = py::none();
    if (finding.where) where = py::make_tuple(finding.where->x, finding.where->y);
    py::tuple numbers(finding.numbers.size());
    for (std::size_t i = 0; i < finding.numbers.size(); ++i) numbers[i] = finding.numbers[i];
    result.append(py::make_tuple(finding_name(finding.code), where, numbers));
  }
  return result;
}

}  // namespace evenload
