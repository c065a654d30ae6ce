#include "strategy/slots/pattern_notes.h"

#include <algorithm>
#include <cmath>

#include "strategy/moves/move_ends.h"
#include "strategy/trochoid/trochoid_pattern.h"

namespace evenload {
namespace {

int iterations(const Way& way) {
  return way.pattern.residuals.empty() ? 0 : static_cast<int>(way.pattern.residuals.size()) + 1;
}

}  // namespace

void PatternNotes::repeated(const Way& way, double length, const std::vector<Segment>& cut) {
  note_turns(cut);
  report_.length += length;
  note_residual(way);
  if (way.kind == TrochoidKind::kCircular && !circles_at_)
    circles_at_ = way.stretch.middle.point(0.5);
  if (length <= report_.longest) return;
  report_.longest = length;
  report_.step = way.pattern.step;
  report_.iterations = iterations(way);
  report_.residual = iterations(way) == 0 ? 0 : way.pattern.residuals.back();
  report_.removal_rate = way.removal * (params_.top - params_.levels.front());
}

void PatternNotes::note_turns(const std::vector<Segment>& cut) {
  const Segment& sharpest = sharpest_of(cut);
  const double wish = std::max(params_.roll_radius, params_.minimum_radius),
               radius = 1 / std::abs(sharpest.curvature());
  if (radius >= wish * (1 - 1e-9)) return;
  plan_.note_turn(radius, shown_place(task_, sharpest.b));
}

void PatternNotes::note_residual(const Way& way) {
  const double settled = 0.5 * kSettled * params_.tool_diameter;
  if (iterations(way) == 0 || way.pattern.residuals.back() < settled) return;
  const Finding finding{FindingCode::kAdvanceUnsettled,
                        {},
                        {static_cast<double>(iterations(way)), way.pattern.residuals.back()}};
  const std::vector<Finding>& told = plan_.made().findings;
  if (std::find(told.begin(), told.end(), finding) == told.end()) plan_.tell(finding);
}

}  // namespace evenload
