// Long slots made short, for the time that a trochoid takes to compute: between its ends it repeats
// itself, and whatever else is cut there goes along the walls. So a piece of the slot as long as a
// whole number of periods is taken out, and the rest is moved up to close the gap; the path of what
// is left is that of the whole, but for what slot_unabridging.h puts back. Our own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/region.h"
#include "strategy/area.h"
#include "strategy/constant_engagement.h"
#include "strategy/slot.h"
#include "strategy/slot_pattern.h"

namespace evenload {

// One of the pieces of a stretch that have walls on both sides. Which way an arc is cut matters: to
// either way belongs a pattern of its own.
struct SlotPiece {
  std::size_t stretch = 0, number = 0;
  bool reversed = false;
};

// What was taken out of one, in the ground that is left.
struct SlotCut {
  SlotPiece from;
  std::vector<Region> ground;  // that is left
  std::size_t region = 0;      // the one that was cut
  // Of the slot, as far as there are walls on both sides. The region's border runs beside it, at
  // half_width mm.
  SlotStretch stretch;
  double half_width = 0;
  double at = 0;   // mm along the middle, where the piece was
  double out = 0;  // mm, its length along the middle
  int periods = 0;
  Vec2 place;  // where it was, in what is left after all cuts
  double step() const { return out / periods; }
};

// How the ground beyond moves when the slot grows by `length` mm: what placed() takes.
Pose motion_along(const Segment& middle, double length);
Vec2 moved(Vec2 p, const Pose& motion);
// mm along a line or arc to the place beside `p`, beyond its ends, too.
double along(const Segment& middle, Vec2 p);

// The pattern of a stretch; nothing where there is none.
using PatternOf = std::function<std::optional<SlotPattern>(const SlotStretch&)>;

// Pieces taken out one after the other, from the `stretches` of `regions` that are longer than
// their ends and the first periods need: from the first of each region, and from the others where
// patterns are likely to be repeated there. Laws: what is taken out has walls that are lines or
// arcs, at the same distance from a middle along which a disc as wide as the slot fits, and so has
// the slot before and beyond it as far as a pattern reaches until it repeats itself. `hole`, about
// which as much is left, is moved as the ground is. Nothing is taken out of `spared`. Empty where
// regions would meet.
std::vector<SlotCut> cuts_of(const std::vector<Region>& regions,
                             const std::vector<SlotStretch>& stretches,
                             const std::vector<SlotPiece>& spared, const ClearingParams& params,
                             const PatternOf& pattern_of, std::optional<Vec2>& hole);

// mm that were taken out of a stretch of what is left in the end.
double taken_out(const std::vector<SlotCut>& cuts, const SlotStretch& stretch);

// One region of the ground that a cut left, on both sides of a line across the slot.
class GroundSides {
 public:
  // `at` mm along the cut's middle.
  GroundSides(const SlotCut& cut, double at);
  // Whether the ground at `p`, or the ground nearest to it, moves when the slot grows there.
  bool is_beyond(Vec2 p) const;

 private:
  Area before_, beyond_;
  std::vector<Region> others_;
};

// Where places of what is left in the end are in the whole.
class WholePlaces {
 public:
  explicit WholePlaces(const std::vector<SlotCut>& cuts);
  Vec2 operator()(Vec2 p) const;

 private:
  struct Part {
    GroundSides sides;
    Pose motion;
  };
  std::shared_ptr<const std::vector<Part>> parts_;  // the last cut first
};

}  // namespace evenload
