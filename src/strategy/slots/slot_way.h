// Ways along slots, and how far they are cleared: where the pattern of a stretch can begin, and
// whether there is still something for it to cut. Places are mm along the stretch's middle, those
// of a period that of its origin.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/trochoid/slot.h"
#include "strategy/trochoid/slot_pattern.h"

namespace evenload {

// A stretch with the pattern that fits it, in the direction of its middle.
struct Way : SlotPattern {
  SlotStretch stretch;
  bool has_next_room = false;
  double length() const { return stretch.middle.length(); }
  // The last place of a period.
  double last() const { return stretch.middle.length() - circle_ahead; }
};

// Of the longest way along which a pattern was repeated at once, in any region; all 0 where none
// was.
struct TrochoidReport {
  double step = 0;          // mm, of its pattern
  int iterations = 0;       // passes that were steered; 0 for patterns found in one go
  double residual = 0;      // mm, at the end of the iteration
  double removal_rate = 0;  // mm^3/min at the first level: the slot's width times its depth over
                            // the time per mm, links and wall passes in it, entry and ends not
  double longest = 0;       // mm, of this way
  double length = 0;        // mm of slot along which patterns are repeated, all regions together
};

// Slots wider than this many tool diameters are pockets: they are cleared pass by pass.
inline constexpr double kWidestSlot = 4;

// Share of the tool's radius: between two looks for material along a middle.
inline constexpr double kMiddleLook = 0.5;

// The cut of a period.
std::vector<Segment> cut_at(const Way& way, double s);

// Periods are numbered back from the last place that there is for one: where the number `period`
// is.
double place_of(const Way& way, int period);

// The number of the first period that has something to cut, beyond a place at which a whole period
// would cut nothing, and no more than a step from it; none where there is no such place, or nothing
// to be cut beyond it.
std::optional<int> first_to_cut(const Way& way, const ClearedGround& ground);

// Where the middle leads from cleared ground into material for the first time, to a look.
std::optional<double> edge_of_material(const Way& way, const ClearedGround& ground);

// Whether a period at `s` would take more than the scallops that another one left.
bool has_work(const Way& way, const ClearedGround& ground, double s);

}  // namespace evenload
