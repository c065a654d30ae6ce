#include "strategy/slots/slot_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/tolerances.h"

namespace evenload {
namespace {

// The longest first, of those as long the widest, so that a turned slot is cut the same.
bool comes_first(const Way& a, const Way& b) {
  if (std::abs(a.length() - b.length()) > kOnWall) return a.length() > b.length();
  return a.stretch.half_room > b.stretch.half_room + kSameWidth;
}

}  // namespace

void SlotWays::find(Use use) {
  for (const SlotStretch& stretch :
       find_slots(centres_, 0.5 * (kWidestSlot - 1) * params_.tool_diameter)) {
    if (!longest_stretch_) longest_stretch_ = stretch;
    add(stretch, use);
    add(stretch.reversed(), use);
  }
  std::stable_sort(ways.begin(), ways.end(), comes_first);
  if (task_.has_open_edges && params_.open_side)
    std::stable_sort(
        ways.begin(), ways.end(), [&wish = *params_.open_side](const Way& a, const Way& b) {
          return distance(a.stretch.middle.a, wish) < distance(b.stretch.middle.a, wish);
        });
  is_too_short = is_too_short && ways.empty();
}

void SlotWays::add(const SlotStretch& stretch, Use use) {
  const std::optional<SlotPattern> pattern = patterns_.pattern_of(stretch);
  if (!pattern) return;
  const double least = 0.5 * kLeastCircle * params_.tool_diameter;
  if (use == Use::kPockets && (has_corners(*pattern) || stretch.half_room < least)) return;
  const Way way{*pattern, stretch};
  if (way.last() + way.reach.back < kFewestPeriods * way.pattern.step) {
    is_too_short = true;
    return;
  }
  ways.push_back(way);
}

Finding SlotWays::why_none() const {
  const Vec2 place =
      longest_stretch_ ? longest_stretch_->middle.point(0.5) : task_.centres.outer.vertices()[0].p;
  return {reason(), shown_place(task_, place), {static_cast<double>(patterns_.kind())}};
}

FindingCode SlotWays::reason() const {
  if (task_.rest) return FindingCode::kNoPatternAfterCuts;
  if (!longest_stretch_)
    return find_slots(centres_, std::numeric_limits<double>::infinity()).empty()
               ? FindingCode::kNoPatternBetweenWalls
               : FindingCode::kNoPatternSoWide;
  if (is_too_short) return FindingCode::kNoPatternSoShort;
  return ways.empty() ? FindingCode::kNoPatternWithoutRoom : FindingCode::kNoPatternWithoutStart;
}

}  // namespace evenload
